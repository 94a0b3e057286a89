# SPDX-License-Identifier: Apache-2.0
"""A field is written twice before the message leaves: only the second write counts.

/out <- data /public; never /secret; trigger /public
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Overwrite(Node):
    def __init__(self):
        super().__init__('overwrite')
        self.secret = ''
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/secret', self.on_secret, 10)
        self.create_subscription(String, '/public', self.on_public, 10)

    def on_secret(self, msg):
        self.secret = msg.data

    def on_public(self, msg):
        out = String()
        out.data = self.secret
        out.data = msg.data
        self.pub.publish(out)


def main():
    rclpy.init()
    rclpy.spin(Overwrite())


if __name__ == '__main__':
    main()
