# SPDX-License-Identifier: Apache-2.0
"""The result of a comparison is published: that is data, not control.

/out <- data /in; trigger /in
values /in: 5 50
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float64


class Compare(Node):
    def __init__(self):
        super().__init__('compare')
        self.pub = self.create_publisher(Bool, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.pub.publish(Bool(data=msg.data > 10.0))


def main():
    rclpy.init()
    rclpy.spin(Compare())


if __name__ == '__main__':
    main()
