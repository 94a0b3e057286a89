# SPDX-License-Identifier: Apache-2.0
"""rclpy.time_source: subscribes to /clock while use_sim_time is true (a node does so by itself: a row of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, message, raises_nothing, reads_only, taken
from rcl_interfaces.msg import SetParametersResult
from rosgraph_msgs.msg import Clock

from rclpy.qos import QoSProfile, ReliabilityPolicy

raises_nothing(__name__)

CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    def __init__(self, *, node=None):
        self._clock_sub = None
        self._node = None
        if node is not None:
            self.attach_node(node)

    @property
    @reads_only
    def ros_time_is_active(self) -> bool: ...

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled):
        if enabled and self._node is not None:
            self._clock_sub = self._node.create_subscription(
                Clock,
                CLOCK_TOPIC,
                self.clock_callback,
                QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT),
            )
        elif self._clock_sub is not None and self._node is not None:
            self._node.destroy_subscription(self._clock_sub)
            self._clock_sub = None

    def attach_node(self, node):
        self._node = node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        self.ros_time_is_active = taken(node.get_parameter(USE_SIM_TIME_NAME).value)
        ask(node, "get_logger")
        ask(node, "add_on_set_parameters_callback", self._on_parameter_event)

    def _on_parameter_event(self, parameter_list):
        return message(SetParametersResult, "result")

    def detach_node(self):
        if self._clock_sub is not None and self._node is not None:
            self._node.destroy_subscription(self._clock_sub)
        self._clock_sub = None
        self._node = None

    @reads_only
    def attach_clock(self, clock) -> None: ...
    @reads_only
    def clock_callback(self, msg) -> None: ...
