# SPDX-License-Identifier: Apache-2.0
"""One topic decides whether the other is passed on.

/out <- data /scan; control /enable; trigger /scan
values /enable: true false false
"""

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


class Gate(Node):
    def __init__(self):
        super().__init__('gate')
        self.enabled = False
        self.pub = self.create_publisher(LaserScan, '/out', 10)
        self.create_subscription(Bool, '/enable', self.on_enable, 10)
        self.create_subscription(LaserScan, '/scan', self.on_scan, 10)

    def on_enable(self, msg):
        self.enabled = msg.data

    def on_scan(self, msg):
        if self.enabled:
            self.pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Gate())


if __name__ == '__main__':
    main()
