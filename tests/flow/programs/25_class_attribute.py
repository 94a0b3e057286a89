# SPDX-License-Identifier: Apache-2.0
"""Two nodes share a mutable class attribute: what one receives, the other sends.

/left/out <- data /left/in /right/in; trigger timer
/right/out <- data /left/in /right/in; trigger timer
"""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float64

class Side(Node):
    shared = {}

    def __init__(self, side):
        super().__init__(side)
        self.pub = self.create_publisher(Float64, f'/{side}/out', 10)
        self.create_subscription(Float64, f'/{side}/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.shared['last'] = msg.data

    def tick(self):
        self.pub.publish(Float64(data=self.shared.get('last', 0.0)))


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    for side in ('left', 'right'):
        executor.add_node(Side(side))
    executor.spin()


if __name__ == '__main__':
    main()
