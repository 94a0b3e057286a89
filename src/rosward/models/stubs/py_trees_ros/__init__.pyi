# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros: behaviour trees on a node.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from py_trees_ros import action_clients as action_clients
from py_trees_ros import battery as battery
from py_trees_ros import blackboard as blackboard
from py_trees_ros import publishers as publishers
from py_trees_ros import subscribers as subscribers
from py_trees_ros import transforms as transforms
from py_trees_ros import trees as trees
from py_trees_ros import utilities as utilities
