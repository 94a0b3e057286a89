# SPDX-License-Identifier: Apache-2.0
"""The builtin functions and types, called."""
