# SPDX-License-Identifier: Apache-2.0
"""Python launch files, run by the engine, become the tree."""
