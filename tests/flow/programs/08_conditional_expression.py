# SPDX-License-Identifier: Apache-2.0
"""A conditional expression: the test decides, both values flow.

/out <- data /left /right; control /choose; trigger timer
values /choose: true false false
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float64


class Select(Node):
    def __init__(self):
        super().__init__('select')
        self.left = self.right = 0.0
        self.choice = False
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/left', lambda m: setattr(self, 'left', m.data), 10)
        self.create_subscription(Float64, '/right', lambda m: setattr(self, 'right', m.data), 10)
        self.create_subscription(Bool, '/choose', lambda m: setattr(self, 'choice', m.data), 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.pub.publish(Float64(data=self.left if self.choice else self.right))


def main():
    rclpy.init()
    rclpy.spin(Select())


if __name__ == '__main__':
    main()
