# SPDX-License-Identifier: Apache-2.0
"""A property computes from a field that a callback sets.

/out <- data /in; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Prop(Node):
    def __init__(self):
        super().__init__('prop')
        self._level = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    @property
    def level(self):
        return self._level / 2.0

    @level.setter
    def level(self, value):
        self._level = value + 1.0

    def on_in(self, msg):
        self.level = msg.data

    def tick(self):
        self.pub.publish(Float64(data=self.level))


def main():
    rclpy.init()
    rclpy.spin(Prop())


if __name__ == '__main__':
    main()
