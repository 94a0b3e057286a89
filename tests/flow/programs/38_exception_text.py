# SPDX-License-Identifier: Apache-2.0
"""The text of an exception holds the input.

/error <- data /in; trigger /in
values /in: 12 x1 x2 34 x3 x4
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Parse(Node):
    def __init__(self):
        super().__init__('parse')
        self.pub = self.create_publisher(String, '/error', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        try:
            self.number = int(msg.data)
        except ValueError as error:
            self.pub.publish(String(data=str(error)))


def main():
    rclpy.init()
    rclpy.spin(Parse())


if __name__ == '__main__':
    main()
