# SPDX-License-Identifier: Apache-2.0
"""A response tells what a subscription received; the request only chooses.

response:/ask <- data /status; control service:/ask; trigger service:/ask
values service:/ask: true false false
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool

class Status(Node):
    def __init__(self):
        super().__init__('status')
        self.status = ''
        self.create_subscription(String, '/status', self.on_status, 10)
        self.create_service(SetBool, '/ask', self.on_ask)

    def on_status(self, msg):
        self.status = msg.data

    def on_ask(self, request, response):
        response.success = True
        response.message = self.status if request.data else 'quiet'
        return response


def main():
    rclpy.init()
    rclpy.spin(Status())


if __name__ == '__main__':
    main()
