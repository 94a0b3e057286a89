# SPDX-License-Identifier: Apache-2.0
"""rclpy.timer.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import calls, raises_nothing, reads_only, schedule, stops, waits

from rclpy.clock_type import ClockType
from rclpy.time import Time

reads_only(__name__)
raises_nothing(__name__)


class TimerInfo:
    def __init__(self, *, expected_call_time=0, actual_call_time=0, clock_type=ClockType.SYSTEM_TIME) -> None: ...

    @property
    def expected_call_time(self) -> Time: ...

    @property
    def actual_call_time(self) -> Time: ...


class Timer:
    @calls("callback", event="timer", args=())
    def __init__(self, callback, callback_group, timer_period_ns, clock, *, context=None, autostart=True):
        self._callback = callback
        self._period_ns = timer_period_ns
        self.callback_group = callback_group

    @property
    def callback(self):
        return self._callback

    @callback.setter
    def callback(self, value):
        self._callback = value
        schedule(value, event="timer")

    @property
    def handle(self): ...

    @stops
    def destroy(self) -> None: ...

    @property
    def clock(self): ...

    @property
    def timer_period_ns(self):
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value):
        self._period_ns = value

    def is_ready(self) -> bool: ...
    def is_canceled(self) -> bool: ...
    @stops
    def cancel(self) -> None: ...
    @stops
    def reset(self) -> None: ...
    def time_since_last_call(self) -> int: ...
    def time_until_next_call(self) -> int: ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...


class Rate:
    def __init__(self, timer, *, context):
        self._timer = timer
    def destroy(self) -> None: ...
    @waits
    def sleep(self) -> None: ...
