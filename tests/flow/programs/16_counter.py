# SPDX-License-Identifier: Apache-2.0
"""Messages are counted: that they come matters, not what they say.

/count <- arrival /in; never /other; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class Count(Node):
    def __init__(self):
        super().__init__('count')
        self.seen = 0
        self.pub = self.create_publisher(Int32, '/count', 10)
        self.create_subscription(String, '/in', self.on_in, 10)
        self.create_subscription(String, '/other', self.on_other, 10)
        self.create_timer(1.0, self.tick)

    def on_in(self, msg):
        self.seen += 1

    def on_other(self, msg):
        self.text = msg.data

    def tick(self):
        self.pub.publish(Int32(data=self.seen))


def main():
    rclpy.init()
    rclpy.spin(Count())


if __name__ == '__main__':
    main()
