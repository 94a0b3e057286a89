# SPDX-License-Identifier: Apache-2.0
"""rclpy.time.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import raises_nothing, reads_only

from builtin_interfaces.msg import Time as TimeMsg

from rclpy.clock_type import ClockType as ClockType
from rclpy.duration import Duration as Duration

reads_only(__name__)
raises_nothing(__name__)

CONVERSION_CONSTANT = 10**9


class Time:
    def __init__(self, *, seconds=0, nanoseconds=0, clock_type=ClockType.SYSTEM_TIME): ...

    @property
    def nanoseconds(self) -> int: ...

    def seconds_nanoseconds(self):
        return (self.nanoseconds, self.nanoseconds)

    @property
    def clock_type(self): ...

    def __add__(self, other) -> Time: ...
    def __radd__(self, other) -> Time: ...

    def __sub__(self, other) -> Duration: ...  # a Time if the other is a Duration: the two answer to the same names

    def __eq__(self, other) -> bool: ...
    def __ne__(self, other) -> bool: ...
    def __lt__(self, other) -> bool: ...
    def __le__(self, other) -> bool: ...
    def __gt__(self, other) -> bool: ...
    def __ge__(self, other) -> bool: ...
    def to_msg(self) -> TimeMsg: ...

    @classmethod
    def from_msg(cls, msg, clock_type=ClockType.ROS_TIME) -> Time: ...
