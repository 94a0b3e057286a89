# SPDX-License-Identifier: Apache-2.0
"""The input says how often a constant is published, and counts it up.

/tick <- control /in; trigger /in
/sum <- control /in; trigger /in
values /in: 1 3 4
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class Loop(Node):
    def __init__(self):
        super().__init__('loop')
        self.tick = self.create_publisher(String, '/tick', 10)
        self.sum = self.create_publisher(Int32, '/sum', 10)
        self.create_subscription(Int32, '/in', self.on_in, 10)

    def on_in(self, msg):
        left = msg.data
        total = 0
        while left > 0:
            self.tick.publish(String(data='tick'))
            total += 2
            left -= 1
        self.sum.publish(Int32(data=total))


def main():
    rclpy.init()
    rclpy.spin(Loop())


if __name__ == '__main__':
    main()
