# SPDX-License-Identifier: Apache-2.0
"""The operators of values of builtin types."""
