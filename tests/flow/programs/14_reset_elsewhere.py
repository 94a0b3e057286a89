# SPDX-License-Identifier: Apache-2.0
"""A reset in another callback does not stop the flow: the order of callbacks is open.

/out <- data /in; arrival /reset; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty, Float64


class Reset(Node):
    def __init__(self):
        super().__init__('reset')
        self.value = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_subscription(Empty, '/reset', self.on_reset, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.value = msg.data

    def on_reset(self, msg):
        self.value = 0.0

    def tick(self):
        self.pub.publish(Float64(data=self.value))


def main():
    rclpy.init()
    rclpy.spin(Reset())


if __name__ == '__main__':
    main()
