# SPDX-License-Identifier: Apache-2.0
"""A helper returns a pair, each half goes its own way.

/x <- data /left; never /right; trigger timer
/y <- data /right; never /left; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Pair(Node):
    def __init__(self):
        super().__init__('pair')
        self.left = self.right = 0.0
        self.x = self.create_publisher(Float64, '/x', 10)
        self.y = self.create_publisher(Float64, '/y', 10)
        self.create_subscription(Float64, '/left', self.on_left, 10)
        self.create_subscription(Float64, '/right', self.on_right, 10)
        self.create_timer(0.1, self.tick)

    def on_left(self, msg):
        self.left = msg.data

    def on_right(self, msg):
        self.right = msg.data

    def compute(self):
        return Float64(data=self.left + 1.0), Float64(data=self.right - 1.0)

    def tick(self):
        x, y = self.compute()
        self.x.publish(x)
        self.y.publish(y)


def main():
    rclpy.init()
    rclpy.spin(Pair())


if __name__ == '__main__':
    main()
