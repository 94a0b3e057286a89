# SPDX-License-Identifier: Apache-2.0
"""A window of the last values.

/mean <- data /in; trigger /in
/size <- arrival /in; trigger timer
"""

from collections import deque

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Int32

class Window(Node):
    def __init__(self):
        super().__init__('window')
        self.values = deque(maxlen=3)
        self.mean = self.create_publisher(Float64, '/mean', 10)
        self.size = self.create_publisher(Int32, '/size', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.values.append(msg.data)
        self.mean.publish(Float64(data=sum(self.values) / len(self.values)))

    def tick(self):
        self.size.publish(Int32(data=len(self.values)))


def main():
    rclpy.init()
    rclpy.spin(Window())


if __name__ == '__main__':
    main()
