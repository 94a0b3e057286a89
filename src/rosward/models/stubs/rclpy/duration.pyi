# SPDX-License-Identifier: Apache-2.0
"""rclpy.duration.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import raises_nothing, reads_only

from builtin_interfaces.msg import Duration as DurationMsg

reads_only(__name__)
raises_nothing(__name__)


class Duration:
    def __init__(self, *, seconds=0, nanoseconds=0):
        self._nanoseconds = nanoseconds + int(seconds * 1000000000)

    @property
    def nanoseconds(self):
        return self._nanoseconds

    def __add__(self, other) -> Duration: ...
    def __sub__(self, other) -> Duration: ...
    def __mul__(self, other) -> Duration: ...
    def __eq__(self, other) -> bool: ...
    def __ne__(self, other) -> bool: ...
    def __lt__(self, other) -> bool: ...
    def __le__(self, other) -> bool: ...
    def __gt__(self, other) -> bool: ...
    def __ge__(self, other) -> bool: ...
    def to_msg(self) -> DurationMsg: ...

    @classmethod
    def from_msg(cls, msg) -> Duration: ...

    def get_c_duration(self): ...


Infinite = Duration(nanoseconds=9223372036854775807)
