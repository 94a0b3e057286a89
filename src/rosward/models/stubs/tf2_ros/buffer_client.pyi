# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.buffer_client: asks the buffer of another node by the action whose name is `ns`.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import creator, reads_only, source

from geometry_msgs.msg import TransformStamped
from rclpy.action.client import ActionClient
from rclpy.duration import Duration as Duration
from tf2_msgs.action import LookupTransform

from tf2_ros.buffer_interface import BufferInterface

reads_only(__name__)


@creator
class BufferClient(BufferInterface):
    def __init__(self, node, ns, check_frequency=10.0, timeout_padding=Duration(seconds=2.0)):
        BufferInterface.__init__(self)
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

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
    def destroy(self) -> None: ...
