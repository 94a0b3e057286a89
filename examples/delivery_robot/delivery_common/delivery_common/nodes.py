# SPDX-License-Identifier: Apache-2.0
"""Base classes: a node that shows that it is alive, and one that looks after hardware."""

from diagnostic_msgs.msg import DiagnosticStatus
from diagnostic_updater import Updater
from rclpy.node import Node
from std_msgs.msg import Header

from delivery_common.names import ROBOT


class HeartbeatNode(Node):
    """A node of the robot that tells the monitor twice a second that it is alive."""

    heartbeat_period = 0.5

    def __init__(self, name, *, namespace=ROBOT, **kwargs):
        super().__init__(name, namespace=namespace, **kwargs)
        self._heartbeat = self.create_publisher(Header, f'/{ROBOT}/heartbeat', 10)
        self.create_timer(self.heartbeat_period, self._beat)

    def _beat(self):
        self._heartbeat.publish(
            Header(
                stamp=self.get_clock().now().to_msg(),
                frame_id=self.get_fully_qualified_name(),
            )
        )


class HardwareNode(HeartbeatNode):
    """A node that looks after a piece of hardware and reports its condition as diagnostics."""

    hardware_id = 'unnamed'

    def __init__(self, name, **kwargs):
        super().__init__(name, **kwargs)
        self.updater = Updater(self)
        self.updater.setHardwareID(self.hardware_id)
        self.updater.add(f'{self.hardware_id} status', self.check)

    def check(self, status):
        """Fill in a diagnostic status; a subclass says what matters to it."""
        status.summary(DiagnosticStatus.OK, 'running')
        return status
