# SPDX-License-Identifier: Apache-2.0
"""Strings, streams, paths and regular expressions."""
