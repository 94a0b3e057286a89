# SPDX-License-Identifier: Apache-2.0
"""A part of the input becomes part of the output; a later write through the alias changes both.

/a <- data /in; trigger /in
/b <- data /in /frame; trigger /in
"""

import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.node import Node
from std_msgs.msg import String


class Alias(Node):
    def __init__(self):
        super().__init__('alias')
        self.frame = 'map'
        self.a = self.create_publisher(PointStamped, '/a', 10)
        self.b = self.create_publisher(PointStamped, '/b', 10)
        self.create_subscription(PointStamped, '/in', self.on_in, 10)
        self.create_subscription(String, '/frame', self.on_frame, 10)

    def on_frame(self, msg):
        self.frame = msg.data

    def on_in(self, msg):
        first = PointStamped()
        first.header = msg.header
        self.a.publish(first)
        second = PointStamped()
        second.header = first.header
        msg.header.frame_id = self.frame
        self.b.publish(second)


def main():
    rclpy.init()
    rclpy.spin(Alias())


if __name__ == '__main__':
    main()
