# SPDX-License-Identifier: Apache-2.0
"""How a function is called: followed, recalled, or one of those that share a summary."""
