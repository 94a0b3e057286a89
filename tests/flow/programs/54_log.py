# SPDX-License-Identifier: Apache-2.0
"""What a subscription receives ends in the log, and so on /rosout.

log @leak <- data /secret; trigger /secret
log @fine <- never /secret; trigger /secret
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Log(Node):
    def __init__(self):
        super().__init__('logging')
        self.create_subscription(String, '/secret', self.on_secret, 10)

    def on_secret(self, msg):
        self.get_logger().info('something came')  # @fine
        self.get_logger().debug(f'it was {msg.data}')  # @leak


def main():
    rclpy.init()
    rclpy.spin(Log())


if __name__ == '__main__':
    main()
