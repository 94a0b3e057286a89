# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: a status that tasks fill in.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from _rosward import reads_only, unknown

class DiagnosticStatusWrapper:
    @reads_only
    def __init__(self, *args, **kwds) -> None: ...
    def summary(self, *args):
        self.level = unknown("call", "level of a diagnostic status")
        self.message = unknown("call", "message of a diagnostic status", "str")

    def clearSummary(self):
        self.summary(0, "")

    def mergeSummary(self, *args):
        self.summary(*args)

    def add(self, key, val):
        self.values = unknown("call", "values of a diagnostic status", "list")
