# SPDX-License-Identifier: Apache-2.0
"""launch.substitution: text that is known when the launch file is executed.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import perform


class Substitution:
    def __eq__(self, other): return self is other
    def __ne__(self, other): return self is not other
    def __hash__(self): return id(self)
    @reads_only
    def describe(self) -> str: ...
    def perform(self, context): return perform(self)
