# SPDX-License-Identifier: Apache-2.0
"""py_trees.timers.

Read from py_trees 2.6.0.
"""

from py_trees import common
from py_trees.behaviour import Behaviour


class Timer(Behaviour):
    def __init__(self, name='Timer', duration=5.0):
        Behaviour.__init__(self, name)
