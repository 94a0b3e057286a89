# SPDX-License-Identifier: Apache-2.0
"""The usual pattern: a callback keeps the message, a timer uses it.

/out <- data /in; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Last(Node):
    def __init__(self):
        super().__init__('last')
        self.last = None
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.last = msg

    def tick(self):
        if self.last is not None:
            self.pub.publish(Float64(data=self.last.data * 2.0))


def main():
    rclpy.init()
    rclpy.spin(Last())


if __name__ == '__main__':
    main()
