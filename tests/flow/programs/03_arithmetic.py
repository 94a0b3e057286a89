# SPDX-License-Identifier: Apache-2.0
"""Values are computed, a constant is mixed in.

/out <- data /in; trigger /in
"""

import math

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64

class Compute(Node):
    def __init__(self):
        super().__init__('compute')
        self.gain = 2.5
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        angle = math.atan2(msg.data, 2.0)
        self.pub.publish(Float64(data=round(self.gain * angle + 1.0, 6)))


def main():
    rclpy.init()
    rclpy.spin(Compute())


if __name__ == '__main__':
    main()
