# SPDX-License-Identifier: Apache-2.0
"""The content only decides which constant goes out.

/out <- control /in; trigger /in
values /in: 5 50
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String


class Branch(Node):
    def __init__(self):
        super().__init__('branch')
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        out = String()
        if msg.data < 10.0:
            out.data = 'low'
        else:
            out.data = 'high'
        self.pub.publish(out)


def main():
    rclpy.init()
    rclpy.spin(Branch())


if __name__ == '__main__':
    main()
