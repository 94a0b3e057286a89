# SPDX-License-Identifier: Apache-2.0
"""A value is carried through a recursion; the depth is another input.

/out <- data /in; either /depth; trigger /in
values /depth: 1 3
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Int32


class Recurse(Node):
    def __init__(self):
        super().__init__('recurse')
        self.depth = 1
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_subscription(Int32, '/depth', self.on_depth, 10)

    def on_depth(self, msg):
        self.depth = msg.data

    def halve(self, value, left):
        return value if left <= 0 else self.halve(value / 2.0, left - 1)

    def on_in(self, msg):
        self.pub.publish(Float64(data=self.halve(msg.data, self.depth)))


def main():
    rclpy.init()
    rclpy.spin(Recurse())


if __name__ == '__main__':
    main()
