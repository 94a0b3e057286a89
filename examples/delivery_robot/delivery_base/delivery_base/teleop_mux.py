# SPDX-License-Identifier: Apache-2.0
"""Chooses who drives: the joystick, a remote operator or the planner, in this order."""

from functools import partial

from delivery_common.names import ROBOT
from delivery_common.nodes import HeartbeatNode
from delivery_common.qos import COMMAND, STATE
from delivery_common.run import run
from geometry_msgs.msg import Twist
from rclpy.duration import Duration
from std_msgs.msg import String

SOURCES = ['joystick', 'remote', 'planner']


class TeleopMux(HeartbeatNode):
    """Passes on the commands of the most important source that has spoken lately."""

    def __init__(self):
        super().__init__('mux', namespace=f'{ROBOT}/teleop')
        self._hold = Duration(seconds=self.declare_parameter('hold', 0.5).value)
        self._active = len(SOURCES)
        self._last = self.get_clock().now()
        self._command = self.create_publisher(Twist, f'/{ROBOT}/cmd_vel', COMMAND)
        self._chosen = self.create_publisher(String, '~/active', STATE)
        for priority, source in enumerate(SOURCES):
            self.create_subscription(Twist, f'~/{source}', partial(self._on_command, priority), COMMAND)

    def _on_command(self, priority, command):
        now = self.get_clock().now()
        if priority > self._active and now - self._last < self._hold:
            return
        if priority != self._active:
            self._active = priority
            self._chosen.publish(String(data=SOURCES[priority]))
        self._last = now
        self._command.publish(command)


def main(args=None):
    """Run the node."""
    run(TeleopMux, args=args)


if __name__ == '__main__':
    main()
