# SPDX-License-Identifier: Apache-2.0
"""py_trees.logging: shows things; its functions have no effect on the graph.

Read from py_trees 2.6.0.
"""

