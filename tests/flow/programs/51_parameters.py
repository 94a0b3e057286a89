# SPDX-License-Identifier: Apache-2.0
"""One parameter is data, one decides, one is the period of the timer.

/out <- data parameter:gain /in; control parameter:invert; never parameter:period; trigger timer
values parameter:invert: false true
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Gain(Node):
    def __init__(self):
        super().__init__('gain')
        self.gain = self.declare_parameter('gain', 2.0).value
        self.declare_parameter('invert', False)
        period = self.declare_parameter('period', 0.5).value
        self.last = 0.0
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(period, self.tick)

    def on_in(self, msg):
        self.last = msg.data

    def tick(self):
        value = self.gain * self.last
        if self.get_parameter('invert').value:
            value = -value
        self.pub.publish(Float64(data=value))


def main():
    rclpy.init()
    rclpy.spin(Gain())


if __name__ == '__main__':
    main()
