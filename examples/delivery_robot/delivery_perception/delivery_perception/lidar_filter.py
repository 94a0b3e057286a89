# SPDX-License-Identifier: Apache-2.0
"""Makes one clean scan of the lidars at both ends of the robot."""

import math

from delivery_common.names import SIDES, sensor_topic
from delivery_common.nodes import HeartbeatNode
from delivery_common.qos import SENSOR
from delivery_common.run import run
from rcl_interfaces.msg import SetParametersResult
from sensor_msgs.msg import LaserScan


class LidarFilter(HeartbeatNode):
    """Drops the echoes of the robot's own body."""

    def __init__(self):
        super().__init__('lidar_filter')
        inputs = [sensor_topic(side, 'scan') for side in SIDES]
        self._inputs = self.declare_parameter('inputs', inputs).value
        self._minimum = self.declare_parameter('minimum_range', 0.25).value
        self.add_on_set_parameters_callback(self._on_parameters)
        self._scan = self.create_publisher(LaserScan, 'scan', SENSOR)
        for topic in self._inputs:
            self.create_subscription(LaserScan, topic, self._on_scan, SENSOR)

    def _on_parameters(self, parameters):
        for parameter in parameters:
            if parameter.name == 'inputs':
                return SetParametersResult(successful=False, reason='set inputs at the start')
            if parameter.name == 'minimum_range':
                self._minimum = parameter.value
        return SetParametersResult(successful=True)

    def _on_scan(self, scan):
        scan.ranges = [r if r >= self._minimum else math.inf for r in scan.ranges]
        self._scan.publish(scan)


def main(args=None):
    """Run the node."""
    run(LidarFilter, args=args)


if __name__ == '__main__':
    main()
