# SPDX-License-Identifier: Apache-2.0
"""How does Python say it? From `ast` to the intermediate representation."""
