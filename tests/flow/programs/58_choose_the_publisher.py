# SPDX-License-Identifier: Apache-2.0
"""The message says on which of two topics it goes out.

/red <- data /in; trigger /in
/blue <- data /in; trigger /in
values /in: red1 blue1 red2 blue2
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Route(Node):
    def __init__(self):
        super().__init__('route')
        self.outs = {c: self.create_publisher(String, f'/{c}', 10) for c in ('red', 'blue')}
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.outs[msg.data[:-1]].publish(String(data=msg.data[-1]))


def main():
    rclpy.init()
    rclpy.spin(Route())


if __name__ == '__main__':
    main()
