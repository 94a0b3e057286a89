# SPDX-License-Identifier: Apache-2.0
"""A helper returns its second argument, and does not look at the first.

/out <- data /b; never /a; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Second(Node):
    def __init__(self):
        super().__init__('second')
        self.a = self.b = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/a', self.on_a, 10)
        self.create_subscription(Float64, '/b', self.on_b, 10)
        self.create_timer(0.1, self.tick)

    def on_a(self, msg):
        self.a = msg.data

    def on_b(self, msg):
        self.b = msg.data

    def pick(self, first, second):
        return second

    def tick(self):
        self.pub.publish(Float64(data=self.pick(self.a, self.b)))


def main():
    rclpy.init()
    rclpy.spin(Second())


if __name__ == '__main__':
    main()
