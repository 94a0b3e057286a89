# SPDX-License-Identifier: Apache-2.0
"""Arrays of numpy: computed, written by index, and as an out argument.

/mean <- data /in; trigger /in
/copy <- data /in; trigger /in
/mask <- data /in /limit; trigger /in
values /limit: 5 7 9 11 13 15
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Float64MultiArray
import numpy as np

class Arrays(Node):
    def __init__(self):
        super().__init__('arrays')
        self.limit = 0.0
        self.mean = self.create_publisher(Float64, '/mean', 10)
        self.copy = self.create_publisher(Float64MultiArray, '/copy', 10)
        self.mask = self.create_publisher(Float64MultiArray, '/mask', 10)
        self.create_subscription(Float64MultiArray, '/in', self.on_in, 10)
        self.create_subscription(Float64, '/limit', self.on_limit, 10)

    def on_limit(self, msg):
        self.limit = msg.data

    def on_in(self, msg):
        values = np.array(msg.data)
        self.mean.publish(Float64(data=float(np.mean(values))))
        copy = np.zeros(3)
        np.copyto(copy, values)
        self.copy.publish(Float64MultiArray(data=copy.tolist()))
        values[values < self.limit] = self.limit / 2.0
        self.mask.publish(Float64MultiArray(data=values.tolist()))


def main():
    rclpy.init()
    rclpy.spin(Arrays())


if __name__ == '__main__':
    main()
