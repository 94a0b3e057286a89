# SPDX-License-Identifier: Apache-2.0
"""Two inputs under two known keys of one dict.

/out_a <- data /a; never /b; trigger timer
/out_b <- data /b; never /a; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Keys(Node):
    def __init__(self):
        super().__init__('keys')
        self.state = {'a': 0.0, 'b': 0.0}
        self.out_a = self.create_publisher(Float64, '/out_a', 10)
        self.out_b = self.create_publisher(Float64, '/out_b', 10)
        self.create_subscription(Float64, '/a', self.on_a, 10)
        self.create_subscription(Float64, '/b', self.on_b, 10)
        self.create_timer(0.1, self.tick)

    def on_a(self, msg):
        self.state['a'] = msg.data

    def on_b(self, msg):
        self.state['b'] = msg.data

    def tick(self):
        self.out_a.publish(Float64(data=self.state['a']))
        self.out_b.publish(Float64(data=self.state['b']))


def main():
    rclpy.init()
    rclpy.spin(Keys())


if __name__ == '__main__':
    main()
