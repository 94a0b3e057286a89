# SPDX-License-Identifier: Apache-2.0
"""A field that is overwritten at the start of the callback that reads it: nothing is left of the other callback.

/out <- data /b; never /a; trigger /b
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Clear(Node):
    def __init__(self):
        super().__init__('clear')
        self.value = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/a', self.on_a, 10)
        self.create_subscription(Float64, '/b', self.on_b, 10)

    def on_a(self, msg):
        self.value = msg.data

    def on_b(self, msg):
        self.value = 1.0
        self.value += msg.data
        self.pub.publish(Float64(data=self.value))


def main():
    rclpy.init()
    rclpy.spin(Clear())


if __name__ == '__main__':
    main()
