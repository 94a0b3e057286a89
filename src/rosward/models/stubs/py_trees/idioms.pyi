# SPDX-License-Identifier: Apache-2.0
"""py_trees.idioms: subtrees made of what they are given.

Read from py_trees 2.6.0.
"""

from py_trees import common
from py_trees.composites import Selector, Sequence


def pick_up_where_you_left_off(name, tasks):
    return Sequence(name, True, tasks)


def either_or(conditions, subtrees, name="Either Or", namespace=None):
    return Selector(name, False, subtrees)


def oneshot(
    behaviour, name="Oneshot", variable_name="oneshot", policy=common.OneShotPolicy.ON_SUCCESSFUL_COMPLETION
):
    return Selector(name, False, [behaviour])
