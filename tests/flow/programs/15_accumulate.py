# SPDX-License-Identifier: Apache-2.0
"""A running sum: each output depends on every message so far.

/total <- data /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Sum(Node):
    def __init__(self):
        super().__init__('sum')
        self.total = 0.0
        self.pub = self.create_publisher(Float64, '/total', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.total += msg.data
        self.pub.publish(Float64(data=self.total))


def main():
    rclpy.init()
    rclpy.spin(Sum())


if __name__ == '__main__':
    main()
