# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: publishers that measure themselves.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from diagnostic_updater._diagnostic_updater import CompositeDiagnosticTask
from diagnostic_updater._update_functions import FrequencyStatus, TimeStampStatus

class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    def __init__(self, name, diag, freq):
        CompositeDiagnosticTask.__init__(self, name + " topic status")
        self.diag = diag
        self.freq = FrequencyStatus(freq)
        self.addTask(self.freq)
        self.diag.add(self)

    def tick(self):
        self.freq.tick()

    def clear_window(self):
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    def __init__(self, name, diag, freq, stamp):
        HeaderlessTopicDiagnostic.__init__(self, name, diag, freq)
        self.stamp = TimeStampStatus(stamp)
        self.addTask(self.stamp)

    def tick(self, stamp):
        self.stamp.tick(stamp)
        self.freq.tick()


class DiagnosedPublisher(TopicDiagnostic):
    def __init__(self, pub, diag, freq, stamp):
        TopicDiagnostic.__init__(self, pub.topic_name, diag, freq, stamp)
        self.publisher = pub

    def publish(self, message):
        self.tick(message.header.stamp)
        self.publisher.publish(message)
