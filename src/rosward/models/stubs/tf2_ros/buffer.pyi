# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.buffer: given a node, a buffer serves the frames as `tf2_frames` in the namespace of the node.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import reads_only, source

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration as Duration
from rclpy.task import Future
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

from tf2_ros.buffer_interface import BufferInterface

reads_only(__name__)


class Buffer(BufferCore, BufferInterface):
    def __init__(self, cache_time=None, node=None):
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        if node is not None:
            self.srv = node.create_service(FrameGraph, "tf2_frames", self._get_frames)

    def _get_frames(self, request, response):
        return response

    def time_jump_callback(self, time_jump) -> None: ...
    def set_transform(self, transform, authority) -> None: ...
    def set_transform_static(self, transform, authority) -> None: ...
    @source("tf")
    def lookup_transform(self, target_frame, source_frame, time, timeout=Duration()) -> TransformStamped: ...
    @source("tf")
    async def lookup_transform_async(self, target_frame, source_frame, time) -> TransformStamped: ...
    @source("tf")
    def lookup_transform_full(
        self, target_frame, target_time, source_frame, source_time, fixed_frame, timeout=Duration()
    ) -> TransformStamped: ...
    @source("tf")
    async def lookup_transform_full_async(
        self, target_frame, target_time, source_frame, source_time, fixed_frame
    ) -> TransformStamped: ...
    @source("tf")
    def can_transform(
        self, target_frame, source_frame, time, timeout=Duration(), return_debug_tuple=False
    ) -> bool: ...
    @source("tf")
    def can_transform_full(
        self,
        target_frame,
        target_time,
        source_frame,
        source_time,
        fixed_frame,
        timeout=Duration(),
        return_debug_tuple=False,
    ) -> bool: ...

    def wait_for_transform_async(self, target_frame, source_frame, time):
        future = Future()
        future.set_result(self.lookup_transform(target_frame, source_frame, time))
        return future

    def wait_for_transform_full_async(self, target_frame, target_time, source_frame, source_time, fixed_frame):
        return self.wait_for_transform_async(target_frame, source_frame, source_time)
