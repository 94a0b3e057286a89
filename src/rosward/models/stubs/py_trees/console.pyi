# SPDX-License-Identifier: Apache-2.0
"""py_trees.console: shows things; its functions have no effect on the graph.

Read from py_trees 2.6.0.
"""

