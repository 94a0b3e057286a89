# SPDX-License-Identifier: Apache-2.0
"""A loop makes a relay for each name; each keeps its own publisher.

/a/out <- data /a/in; never /b/in; trigger /a/in
/b/out <- data /b/in; never /a/in; trigger /b/in
"""

from functools import partial

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Relays(Node):
    def __init__(self):
        super().__init__('relays')
        for name in ('a', 'b'):
            pub = self.create_publisher(String, f'/{name}/out', 10)
            self.create_subscription(String, f'/{name}/in', partial(self.relay, pub), 10)

    def relay(self, pub, msg):
        pub.publish(String(data=msg.data.upper()))


def main():
    rclpy.init()
    rclpy.spin(Relays())


if __name__ == '__main__':
    main()
