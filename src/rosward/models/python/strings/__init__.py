# SPDX-License-Identifier: Apache-2.0
"""What becomes of texts, whose parts may be unknown."""
