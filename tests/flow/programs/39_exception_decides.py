# SPDX-License-Identifier: Apache-2.0
"""Whether an exception comes depends on the input: that is control.

/ok <- control /in; trigger /in
/failed <- control /in; trigger /in
values /in: 12 x x
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Decide(Node):
    def __init__(self):
        super().__init__('decide')
        self.ok = self.create_publisher(String, '/ok', 10)
        self.failed = self.create_publisher(String, '/failed', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        try:
            int(msg.data)
        except ValueError:
            self.failed.publish(String(data='no number'))
        else:
            self.ok.publish(String(data='a number'))


def main():
    rclpy.init()
    rclpy.spin(Decide())


if __name__ == '__main__':
    main()
