# SPDX-License-Identifier: Apache-2.0
"""What stands behind a test that is never true does not flow.

/out <- data /public; never /secret; trigger /public
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


DEBUG = False

class Dead(Node):
    def __init__(self):
        super().__init__('dead')
        self.secret = ''
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/secret', self.on_secret, 10)
        self.create_subscription(String, '/public', self.on_public, 10)

    def on_secret(self, msg):
        self.secret = msg.data

    def on_public(self, msg):
        text = msg.data
        if DEBUG:
            text = self.secret
        self.pub.publish(String(data=text))

    def dump(self):
        self.pub.publish(String(data=self.secret))


def main():
    rclpy.init()
    rclpy.spin(Dead())


if __name__ == '__main__':
    main()
