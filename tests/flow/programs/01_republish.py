# SPDX-License-Identifier: Apache-2.0
"""A message is passed on as it is.

/out <- data /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Relay(Node):
    def __init__(self):
        super().__init__('relay')
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.pub.publish, 10)


def main():
    rclpy.init()
    rclpy.spin(Relay())


if __name__ == '__main__':
    main()
