# SPDX-License-Identifier: Apache-2.0
"""From source text to the intermediate representation, one language a module."""
