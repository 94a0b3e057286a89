# SPDX-License-Identifier: Apache-2.0
"""launch.condition: when an action is executed.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import evaluate, keep


class Condition:
    def __init__(self, *, predicate=None):
        keep(self, None, predicate=predicate)

    @reads_only
    def describe(self) -> str: ...
    def evaluate(self, context): return evaluate(self)
