# SPDX-License-Identifier: Apache-2.0
"""Two nodes of one class in one process: each has its own fields.

/left/out <- data /left/in; never /right/in; trigger timer
/right/out <- data /right/in; never /left/in; trigger timer
"""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float64

class Side(Node):
    def __init__(self, side):
        super().__init__(side)
        self.last = 0.0
        self.pub = self.create_publisher(Float64, f'/{side}/out', 10)
        self.create_subscription(Float64, f'/{side}/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.last = msg.data

    def tick(self):
        self.pub.publish(Float64(data=self.last))


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    for side in ('left', 'right'):
        executor.add_node(Side(side))
    executor.spin()


if __name__ == '__main__':
    main()
