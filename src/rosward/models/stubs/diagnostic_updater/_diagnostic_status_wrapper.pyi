# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: a status that tasks fill in.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from _rosward import pure, reads_only

pure(__name__)


@reads_only
def _text(*content) -> str: ...


@reads_only
def _level(*content) -> bytes: ...


@reads_only
def _values(*content) -> list: ...


class DiagnosticStatusWrapper:
    def __init__(self, *args, **kwds):
        self._content = []
        self.name = _text()
        self.hardware_id = _text()
        self.level = _level()
        self.message = _text()
        self.values = _values()

    def summary(self, *args):
        self._content.extend(args)
        self.level = _level(*args)
        self.message = _text(*args)

    def clearSummary(self):
        self.summary(0, "")

    def mergeSummary(self, *args):
        self._content.extend(args)
        self.level = _level(self.level, *args)
        self.message = _text(self.message, *args)

    def add(self, key, val):
        self._content.extend((key, val))
        self.values = _values(self.values, key, val)
