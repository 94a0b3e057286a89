# SPDX-License-Identifier: Apache-2.0
"""rclpy.guard_condition.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import calls, reads_only, schedule

reads_only(__name__)


class GuardCondition:
    @calls("callback", event="guard condition", args=())
    def __init__(self, callback, callback_group, context=None):
        self._callback = callback
        self.callback_group = callback_group

    @property
    def callback(self):
        return self._callback

    @callback.setter
    def callback(self, value):
        self._callback = value
        schedule(value, event="guard condition")

    def trigger(self) -> None: ...

    @property
    def handle(self): ...

    def destroy(self) -> None: ...
