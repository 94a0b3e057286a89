# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: ready-made tasks.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

import time

from diagnostic_updater._diagnostic_updater import DiagnosticTask


class FrequencyStatusParam:
    def __init__(self, freq_bound, tolerance=0.1, window_size=5):
        self.freq_bound = freq_bound
        self.tolerance = tolerance
        self.window_size = window_size


class FrequencyStatus(DiagnosticTask):
    def __init__(self, params, name="FrequencyStatus"):
        DiagnosticTask.__init__(self, name)
        self.params = params
        self.count = 0

    def clear(self):
        self.count = 0

    def tick(self):
        self.count += 1

    def run(self, stat):
        stat.add("Actual frequency (Hz)", (self.count, time.time(), self.params))
        return stat


class TimeStampStatusParam:
    def __init__(self, min_acceptable=-1, max_acceptable=5):
        self.min_acceptable = min_acceptable
        self.max_acceptable = max_acceptable


class TimeStampStatus(DiagnosticTask):
    def __init__(self, params=TimeStampStatusParam(), name="Timestamp Status"):
        DiagnosticTask.__init__(self, name)
        self.params = params
        self.stamps = []

    def tick(self, stamp):
        self.stamps.append(stamp)

    def run(self, stat):
        stat.add("Timestamps", (self.stamps, time.time(), self.params))
        return stat


class Heartbeat(DiagnosticTask):
    def __init__(self):
        DiagnosticTask.__init__(self, "Heartbeat")

    def run(self, stat):
        return stat
