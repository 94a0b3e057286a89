# SPDX-License-Identifier: Apache-2.0
"""py_trees: behaviour trees. What matters here is which behaviours a tree holds.

Read from py_trees 2.6.0.
"""

from py_trees import behaviour as behaviour
from py_trees import behaviours as behaviours
from py_trees import blackboard as blackboard
from py_trees import common as common
from py_trees import composites as composites
from py_trees import console as console
from py_trees import decorators as decorators
from py_trees import display as display
from py_trees import idioms as idioms
from py_trees import logging as logging
from py_trees import timers as timers
from py_trees import trees as trees
from py_trees import visitors as visitors
