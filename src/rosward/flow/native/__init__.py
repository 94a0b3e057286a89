# SPDX-License-Identifier: Apache-2.0
"""Builtins and models in code: what they do with what they get."""
