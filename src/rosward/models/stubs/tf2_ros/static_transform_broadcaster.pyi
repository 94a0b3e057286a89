# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.static_transform_broadcaster: publishes /tf_static.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import creator, reads_only, sink

from rclpy.qos import DurabilityPolicy as DurabilityPolicy, HistoryPolicy as HistoryPolicy, QoSProfile as QoSProfile
from tf2_msgs.msg import TFMessage

reads_only(__name__)


@creator
class StaticTransformBroadcaster:
    def __init__(self, node, qos=None):
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(TFMessage, "/tf_static", qos)

    @sink("tf")
    def sendTransform(self, transform) -> None: ...
