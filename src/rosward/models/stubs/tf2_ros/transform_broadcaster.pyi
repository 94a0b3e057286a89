# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.transform_broadcaster: publishes /tf.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import creator, reads_only, sink

from rclpy.qos import QoSProfile as QoSProfile
from tf2_msgs.msg import TFMessage

reads_only(__name__)


@creator
class TransformBroadcaster:
    def __init__(self, node, qos=None):
        if qos is None:
            qos = QoSProfile(depth=100)
        self.pub_tf = node.create_publisher(TFMessage, "/tf", qos)

    @sink("tf")
    def sendTransform(self, transform) -> None: ...
