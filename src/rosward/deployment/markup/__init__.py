# SPDX-License-Identifier: Apache-2.0
"""XML and YAML launch files become the tree."""
