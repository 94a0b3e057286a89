# SPDX-License-Identifier: Apache-2.0
"""The key comes from a message: which entry is read is data too.

/out <- data /in /ask; trigger /ask
values /in: red green
values /ask: red green
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class Lookup(Node):
    def __init__(self):
        super().__init__('lookup')
        self.count = {}
        self.pub = self.create_publisher(Int32, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)
        self.create_subscription(String, '/ask', self.on_ask, 10)

    def on_in(self, msg):
        self.count[msg.data] = self.count.get(msg.data, 0) + 1

    def on_ask(self, msg):
        self.pub.publish(Int32(data=self.count.get(msg.data, 0)))


def main():
    rclpy.init()
    rclpy.spin(Lookup())


if __name__ == '__main__':
    main()
