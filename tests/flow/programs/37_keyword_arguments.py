# SPDX-License-Identifier: Apache-2.0
"""Values travel as keyword arguments through a dict; one of them is not used.

/out <- data /a; never /b; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Keywords(Node):
    def __init__(self):
        super().__init__('keywords')
        self.values = {'x': 0.0, 'y': 0.0}
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/a', self.on_a, 10)
        self.create_subscription(Float64, '/b', self.on_b, 10)
        self.create_timer(0.1, self.tick)

    def on_a(self, msg):
        self.values['x'] = msg.data

    def on_b(self, msg):
        self.values['y'] = msg.data

    def send(self, x, **others):
        self.pub.publish(Float64(data=x))

    def tick(self):
        self.send(**self.values)


def main():
    rclpy.init()
    rclpy.spin(Keywords())


if __name__ == '__main__':
    main()
