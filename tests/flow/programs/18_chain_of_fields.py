# SPDX-License-Identifier: Apache-2.0
"""Three callbacks hand a value on through fields.

/out <- data /in; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Chain(Node):
    def __init__(self):
        super().__init__('chain')
        self.raw = self.filtered = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_timer(0.1, self.send)
        self.create_timer(0.1, self.work)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.raw = msg.data

    def work(self):
        self.filtered = 0.5 * self.filtered + 0.5 * self.raw

    def send(self):
        self.pub.publish(Float64(data=self.filtered))


def main():
    rclpy.init()
    rclpy.spin(Chain())


if __name__ == '__main__':
    main()
