# SPDX-License-Identifier: Apache-2.0
"""One helper serves two topics: the calls must be kept apart.

/out_a <- data /a; never /b; trigger /a
/out_b <- data /b; never /a; trigger /b
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Twice(Node):
    def __init__(self):
        super().__init__('twice')
        self.out_a = self.create_publisher(Float64, '/out_a', 10)
        self.out_b = self.create_publisher(Float64, '/out_b', 10)
        self.create_subscription(Float64, '/a', lambda m: self.send(m.data, self.out_a), 10)
        self.create_subscription(Float64, '/b', lambda m: self.send(m.data, self.out_b), 10)

    def scale(self, value):
        return value * 3.0

    def send(self, value, pub):
        pub.publish(Float64(data=self.scale(value)))


def main():
    rclpy.init()
    rclpy.spin(Twice())


if __name__ == '__main__':
    main()
