# SPDX-License-Identifier: Apache-2.0
"""rclpy.experimental.events_executor: a function in the library, whose result looks like an Executor.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from rclpy.executors import Executor


class EventsExecutor(Executor):
    def __init__(self, *, context=None):
        super().__init__(context=context)
