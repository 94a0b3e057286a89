# SPDX-License-Identifier: Apache-2.0
"""Texts are cut, joined and formatted.

/out <- data /in; trigger /in
/first <- data /in; trigger /in
"""

import re

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Texts(Node):
    def __init__(self):
        super().__init__('texts')
        self.out = self.create_publisher(String, '/out', 10)
        self.first = self.create_publisher(String, '/first', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        words = re.sub('[aeiou]', '', msg.data).split('t')
        self.out.publish(String(data='-'.join(f'<{w:>6}>' for w in words)))
        self.first.publish(String(data=msg.data[:4].strip()))


def main():
    rclpy.init()
    rclpy.spin(Texts())


if __name__ == '__main__':
    main()
