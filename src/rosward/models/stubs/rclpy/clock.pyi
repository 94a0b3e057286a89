# SPDX-License-Identifier: Apache-2.0
"""rclpy.clock: times are never known; jump callbacks may run.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from enum import IntEnum

from _rosward import calls, raises_nothing, reads_only, source, waits

from rclpy.clock_type import ClockType as ClockType
from rclpy.context import Context
from rclpy.duration import Duration as Duration
from rclpy.time import Time as Time

reads_only(__name__)
raises_nothing(__name__)


class ClockChange(IntEnum):
    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    def __init__(self, *, min_forward, min_backward, on_clock_change=True):
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change


class TimeJump:
    def __init__(self, clock_change, delta): ...

    @property
    def clock_change(self): ...

    @property
    def delta(self) -> Duration: ...


class JumpHandle:
    def __init__(self, *, clock, threshold, pre_callback, post_callback) -> None: ...
    def unregister(self) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, t, v, tb) -> None: ...


class Clock:
    def __init__(self, *, clock_type=ClockType.SYSTEM_TIME):
        self._clock_type = clock_type

    @property
    def clock_type(self): ...

    @property
    def handle(self): ...

    @source("clock")
    def now(self) -> Time: ...

    @calls("pre_callback", event="time jump", args=())
    @calls("post_callback", event="time jump", args=("unknown",))
    def create_jump_callback(self, threshold, *, pre_callback=None, post_callback=None) -> JumpHandle: ...

    @waits
    def sleep_until(self, until, context=None) -> bool: ...
    @waits
    def sleep_for(self, rel_time, context=None) -> bool: ...


class ROSClock(Clock):
    def __init__(self) -> None: ...

    @property
    def ros_time_is_active(self) -> bool: ...

    def set_ros_time_override(self, time) -> None: ...
