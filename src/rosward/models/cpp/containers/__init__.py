# SPDX-License-Identifier: Apache-2.0
"""Sequences, sets, maps, pairs and tuples."""
