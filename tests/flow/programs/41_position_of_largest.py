# SPDX-License-Identifier: Apache-2.0
"""The position of the largest element is found by comparisons, the element itself is data.

/where <- control /in; trigger /in
/value <- data /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Float64MultiArray, Int32


class Largest(Node):
    def __init__(self):
        super().__init__('largest')
        self.where = self.create_publisher(Int32, '/where', 10)
        self.value = self.create_publisher(Float64, '/value', 10)
        self.create_subscription(Float64MultiArray, '/in', self.on_in, 10)

    def on_in(self, msg):
        position = 0
        best = -1.0
        for index, value in enumerate(msg.data):
            if value % 4.0 > best:
                position, best = index, value % 4.0
        self.where.publish(Int32(data=position))
        self.value.publish(Float64(data=best))


def main():
    rclpy.init()
    rclpy.spin(Largest())


if __name__ == '__main__':
    main()
