# SPDX-License-Identifier: Apache-2.0
"""The classic mistake: each lambda sees the last publisher of the loop.

/b/out <- data /a/in /b/in; trigger /a/in /b/in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Late(Node):
    def __init__(self):
        super().__init__('late')
        for name in ('a', 'b'):
            pub = self.create_publisher(String, f'/{name}/out', 10)
            self.create_subscription(String, f'/{name}/in', lambda msg: pub.publish(msg), 10)


def main():
    rclpy.init()
    rclpy.spin(Late())


if __name__ == '__main__':
    main()
