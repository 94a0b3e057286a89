# SPDX-License-Identifier: Apache-2.0
"""The base class subscribes, the subclass publishes.

/out <- data /in; trigger /in
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Base(Node):
    def __init__(self, name):
        super().__init__(name)
        self.create_subscription(Float64, '/in', self._on_in, 10)

    def _on_in(self, msg):
        self.use(self.prepare(msg.data))

    def prepare(self, value):
        return value

    def use(self, value):
        raise NotImplementedError


class Derived(Base):
    def __init__(self):
        super().__init__('derived')
        self.pub = self.create_publisher(Float64, '/out', 10)

    def prepare(self, value):
        return super().prepare(value) + 1.0

    def use(self, value):
        self.pub.publish(Float64(data=value))


def main():
    rclpy.init()
    rclpy.spin(Derived())


if __name__ == '__main__':
    main()
