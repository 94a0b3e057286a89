# SPDX-License-Identifier: Apache-2.0
"""launch.substitution: text that is known when the launch file is executed.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import perform


class Substitution:
    __eq__ = object.__eq__
    __ne__ = object.__ne__
    __hash__ = object.__hash__
    @reads_only
    def describe(self) -> str: ...
    def perform(self, context): return perform(self)
