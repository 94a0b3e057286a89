# SPDX-License-Identifier: Apache-2.0
"""rclpy.time_source: subscribes to /clock while use_sim_time is true (a node does so by itself: a row of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from rosgraph_msgs.msg import Clock

from rclpy.qos import QoSProfile, ReliabilityPolicy

CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    def __init__(self, *, node=None):
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool: ...

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled):
        if enabled and self._node is not None:
            self._node.create_subscription(
                Clock,
                CLOCK_TOPIC,
                self.clock_callback,
                QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT),
            )

    def attach_node(self, node):
        self._node = node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        self.ros_time_is_active = node.get_parameter(USE_SIM_TIME_NAME).value

    def detach_node(self) -> None: ...
    def attach_clock(self, clock) -> None: ...
    def clock_callback(self, msg) -> None: ...
