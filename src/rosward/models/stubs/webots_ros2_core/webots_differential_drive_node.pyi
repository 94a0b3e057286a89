# SPDX-License-Identifier: Apache-2.0
"""webots_ros2_core.webots_differential_drive_node.

Read from cyberbotics/webots_ros2, tag 1.2.3.
"""

from _rosward import reads_only

from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf2_ros import TransformBroadcaster

from webots_ros2_core.webots_node import WebotsNode

reads_only(__name__)


class WebotsDifferentialDriveNode(WebotsNode):
    def __init__(
        self,
        name,
        args,
        wheel_distance=0,
        wheel_radius=0,
        left_joint="left wheel motor",
        right_joint="right wheel motor",
        left_encoder="left wheel sensor",
        right_encoder="right wheel sensor",
        command_topic="/cmd_vel",
        odometry_topic="/odom",
        odometry_frame="odom",
        robot_base_frame="base_link",
    ):
        super().__init__(name, args)
        self.declare_parameter("wheel_distance", wheel_distance)
        self.declare_parameter("wheel_radius", wheel_radius)
        self.declare_parameter("left_joint", left_joint)
        self.declare_parameter("right_joint", right_joint)
        self.declare_parameter("left_encoder", left_encoder)
        self.declare_parameter("right_encoder", right_encoder)
        command = self.declare_parameter("command_topic", command_topic)
        odometry = self.declare_parameter("odometry_topic", odometry_topic)
        self.declare_parameter("odometry_frame", odometry_frame)
        self.declare_parameter("robot_base_frame", robot_base_frame)
        self.create_subscription(Twist, command.value, self._cmd_vel_callback, 1)
        self._odometry_publisher = self.create_publisher(Odometry, odometry.value, 1)
        self._tf_broadcaster = TransformBroadcaster(self)

    def _cmd_vel_callback(self, twist) -> None: ...
