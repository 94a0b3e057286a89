# SPDX-License-Identifier: Apache-2.0
"""Values come out of a generator.

/out <- data /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Float64MultiArray


class Generate(Node):
    def __init__(self):
        super().__init__('generate')
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64MultiArray, '/in', self.on_in, 10)

    def pairs(self, values):
        previous = 0.0
        for value in values:
            yield value - previous
            previous = value

    def on_in(self, msg):
        for difference in self.pairs(msg.data):
            self.pub.publish(Float64(data=difference))


def main():
    rclpy.init()
    rclpy.spin(Generate())


if __name__ == '__main__':
    main()
