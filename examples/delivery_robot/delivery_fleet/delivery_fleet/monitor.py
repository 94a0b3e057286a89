# SPDX-License-Identifier: Apache-2.0
"""Raises an alarm when a node of a robot falls silent or reports an error."""

from delivery_common.names import FLEET, ROBOT
from delivery_common.run import run
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import Header, String
from std_srvs.srv import Trigger


class Monitor(Node):
    """Which topics it listens to is a matter of its parameters."""

    def __init__(self):
        super().__init__('monitor', namespace=FLEET)
        self.declare_parameters(
            namespace='topics',
            parameters=[
                ('heartbeat', f'/{ROBOT}/heartbeat'),
                ('diagnostics', '/diagnostics'),
                ('alarms', 'alarms'),
            ],
        )
        self._patience = Duration(seconds=self.declare_parameter('patience', 2.0).value)
        self._seen = {}
        self._alarms = self.create_publisher(String, self._topic('alarms'), 10)
        self.create_subscription(Header, self._topic('heartbeat'), self._on_heartbeat, 10)
        self.create_subscription(DiagnosticArray, self._topic('diagnostics'), self._on_diagnostics, 10)
        self.create_service(Trigger, '~/reset', self._on_reset)
        self.create_timer(1.0, self._look_around)

    def _topic(self, role):
        return self.get_parameter(f'topics.{role}').value

    def _on_heartbeat(self, beat):
        self._seen[beat.frame_id] = Time.from_msg(beat.stamp)

    def _on_diagnostics(self, diagnostics):
        for status in diagnostics.status:
            if status.level == DiagnosticStatus.ERROR:
                self._alarms.publish(String(data=f'{status.name}: {status.message}'))

    def _on_reset(self, request, response):
        self._seen.clear()
        response.success = True
        return response

    def _look_around(self):
        now = self.get_clock().now()
        for name, seen in self._seen.items():
            if now - seen > self._patience:
                self._alarms.publish(String(data=f'{name} has fallen silent'))


def main(args=None):
    """Run the node."""
    run(Monitor, args=args)


if __name__ == '__main__':
    main()
