# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: a status that tasks fill in.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from _rosward import unknown

class DiagnosticStatusWrapper:
    def __init__(self, *args, **kwds):
        self._content = []
        self.name = unknown("call", "name of a diagnostic status", "str")
        self.hardware_id = unknown("call", "hardware of a diagnostic status", "str")
        self.level = unknown("call", "level of a diagnostic status")
        self.message = unknown("call", "message of a diagnostic status", "str")
        self.values = unknown("call", "values of a diagnostic status", "list")

    def summary(self, *args):
        self._content.extend(args)
        self.level = unknown("call", "level of a diagnostic status")
        self.message = unknown("call", "message of a diagnostic status", "str")

    def clearSummary(self):
        self.summary(0, "")

    def mergeSummary(self, *args):
        self.summary(*args)

    def add(self, key, val):
        self._content.extend((key, val))
        self.values = unknown("call", "values of a diagnostic status", "list")
