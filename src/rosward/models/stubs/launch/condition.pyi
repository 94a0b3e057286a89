# SPDX-License-Identifier: Apache-2.0
"""launch.condition: when an action is executed.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward.launch import evaluate, keep


class Condition:
    def __init__(self, *, predicate=None):
        keep(self, None, predicate=predicate)

    def describe(self) -> str: ...
    def evaluate(self, context): return evaluate(self)
