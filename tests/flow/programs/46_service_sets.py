# SPDX-License-Identifier: Apache-2.0
"""A service sets what a timer publishes.

/mode <- data service:/set; trigger timer
response:/set <- trigger service:/set
"""

import rclpy
from rcl_interfaces.srv import ListParameters
from rclpy.node import Node
from std_msgs.msg import String

class Mode(Node):
    def __init__(self):
        super().__init__('mode')
        self.names = []
        self.pub = self.create_publisher(String, '/mode', 10)
        self.create_service(ListParameters, '/set', self.on_set)
        self.create_timer(0.5, self.tick)

    def on_set(self, request, response):
        self.names = request.prefixes
        return response

    def tick(self):
        self.pub.publish(String(data=','.join(self.names)))


def main():
    rclpy.init()
    rclpy.spin(Mode())


if __name__ == '__main__':
    main()
