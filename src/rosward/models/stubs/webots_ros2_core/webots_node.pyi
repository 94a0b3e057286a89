# SPDX-License-Identifier: Apache-2.0
"""webots_ros2_core.webots_node: a node that publishes the clock of the simulation.

Read from cyberbotics/webots_ros2, tag 1.2.3. (Later ones have the node in C++.)
"""

from _rosward import reads_only, report
from rclpy.node import Node
from rosgraph_msgs.msg import Clock
from webots_ros2_msgs.srv import SetInt

from webots_ros2_core.joint_state_publisher import JointStatePublisher


class WebotsNode(Node):
    def __init__(self, name, args=None, controller_class=None):
        super().__init__(name)
        self.declare_parameter("synchronization", False)
        self.declare_parameter("use_joint_state_publisher", False)
        self._rosward_clock_publisher = self.create_publisher(Clock, "clock", 10)
        self._rosward_step_service = self.create_service(SetInt, "step", self._rosward_step)
        self._rosward_timer = self.create_timer(0.01, self._rosward_tick)
        if self.get_parameter("use_joint_state_publisher").value:
            self.start_joint_state_publisher()

    def _rosward_tick(self):
        self.step(self.timestep)

    def _rosward_step(self, request, response):
        self.step(request.value)
        return response

    def start_joint_state_publisher(self):
        self._rosward_joint_state_publisher = JointStatePublisher(self.robot, "", self)

    @reads_only
    def step(self, ms) -> None: ...

    def start_device_manager(self, config=None):
        report("RW202", "the device manager of Webots publishes one or more topics for each device of the simulated robot")
