# SPDX-License-Identifier: Apache-2.0
"""Tells the rest of the robot when the battery runs low."""

from delivery_common.nodes import HardwareNode
from delivery_common.qos import SENSOR, STATE
from delivery_common.run import run
from diagnostic_msgs.msg import DiagnosticStatus
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool


class BatteryMonitor(HardwareNode):
    """Watches the charge of the battery."""

    hardware_id = 'battery'

    def __init__(self):
        super().__init__('battery_monitor')
        self.declare_parameters('', [('input', 'battery'), ('low', 0.2)])
        self._charge = 1.0
        self._was_low = None
        self._low = self.create_publisher(Bool, 'battery_low', STATE)
        topic = self.get_parameter('input').get_parameter_value().string_value
        self.create_subscription(BatteryState, topic, self._on_state, SENSOR)

    def check(self, status):
        """Report the charge."""
        low = self._charge < self.get_parameter('low').value
        level = DiagnosticStatus.WARN if low else DiagnosticStatus.OK
        status.summary(level, f'{self._charge:.0%} charged')
        status.add('charge', str(self._charge))
        return status

    def _on_state(self, state):
        self._charge = state.percentage
        low = self._charge < self.get_parameter('low').value
        if low != self._was_low:
            self._was_low = low
            self._low.publish(Bool(data=low))


def main(args=None):
    """Run the node."""
    run(BatteryMonitor, args=args)


if __name__ == '__main__':
    main()
