# SPDX-License-Identifier: Apache-2.0
"""The message only starts the publication: its content goes nowhere.

/out <- never /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Beep(Node):
    def __init__(self):
        super().__init__('beep')
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.pub.publish(String(data='beep'))


def main():
    rclpy.init()
    rclpy.spin(Beep())


if __name__ == '__main__':
    main()
