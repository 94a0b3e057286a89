# SPDX-License-Identifier: Apache-2.0
"""A function takes away what is secret: the length of a text remains, or its digest.

/length <- data /secret; trigger /secret
/digest <- data /secret; trigger /secret
/fixed <- never /secret; trigger /secret
values /secret: a bb ccc dddd
"""

import hashlib

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String

class Redact(Node):
    def __init__(self):
        super().__init__('redact')
        self.length = self.create_publisher(Int32, '/length', 10)
        self.digest = self.create_publisher(String, '/digest', 10)
        self.fixed = self.create_publisher(String, '/fixed', 10)
        self.create_subscription(String, '/secret', self.on_secret, 10)

    def on_secret(self, msg):
        self.length.publish(Int32(data=len(msg.data)))
        self.digest.publish(String(data=hashlib.sha256(msg.data.encode()).hexdigest()))
        self.fixed.publish(String(data='*' * 8))


def main():
    rclpy.init()
    rclpy.spin(Redact())


if __name__ == '__main__':
    main()
