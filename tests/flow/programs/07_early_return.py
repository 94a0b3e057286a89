# SPDX-License-Identifier: Apache-2.0
"""An early return makes all that follows depend on the test.

/out <- control /in; never /other; trigger /in
/after <- data /other; never /in; trigger /other
values /in: 1 9 9
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String


class Guard(Node):
    def __init__(self):
        super().__init__('guard')
        self.out = self.create_publisher(String, '/out', 10)
        self.after = self.create_publisher(Float64, '/after', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_subscription(Float64, '/other', self.on_other, 10)

    def on_in(self, msg):
        if msg.data > 5.0:
            return
        self.out.publish(String(data='small'))

    def on_other(self, msg):
        self.after.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Guard())


if __name__ == '__main__':
    main()
