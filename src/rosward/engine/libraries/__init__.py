# SPDX-License-Identifier: Apache-2.0
"""Lowered sources, and the models of libraries, which are run once and kept."""
