# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.buffer_interface.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import either, reads_only, source

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration

reads_only(__name__)


class BufferInterface:
    def __init__(self):
        self.registration = TransformRegistration()

    @source("tf")
    def transform(self, object_stamped, target_frame, timeout=Duration(), new_type=None): ...
    @source("tf")
    def transform_full(
        self, object_stamped, target_frame, target_time, fixed_frame, timeout=Duration(), new_type=None
    ): ...
    @source("tf")
    def lookup_transform(self, target_frame, source_frame, time, timeout=Duration()) -> TransformStamped: ...
    @source("tf")
    def lookup_transform_full(
        self, target_frame, target_time, source_frame, source_time, fixed_frame, timeout=Duration()
    ) -> TransformStamped: ...
    @source("tf")
    def can_transform(self, target_frame, source_frame, time, timeout=Duration()) -> bool: ...
    @source("tf")
    def can_transform_full(
        self, target_frame, target_time, source_frame, source_time, fixed_frame, timeout=Duration()
    ) -> bool: ...


def Stamped(obj, stamp, frame_id):
    return obj


class TypeException(Exception):
    def __init__(self, errstr) -> None: ...


class NotImplementedException(Exception):
    def __init__(self) -> None: ...


class TransformRegistration:
    def print_me(self) -> None: ...
    def add(self, key, callback) -> None: ...
    def get(self, key): ...


class ConvertRegistration:
    def add_from_msg(self, key, callback) -> None: ...
    def add_to_msg(self, key, callback) -> None: ...
    def add_convert(self, key, callback) -> None: ...
    def get_from_msg(self, key): ...
    def get_to_msg(self, key): ...
    def get_convert(self, key): ...


def _converted(a, b_type): ...


def convert(a, b_type):
    return either(a, _converted(a, b_type))
