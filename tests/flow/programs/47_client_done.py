# SPDX-License-Identifier: Apache-2.0
"""What a service answers is published when the future is done.

/answer <- data response:/query; control /in; trigger response:/query
request:/query <- control /in; trigger /in
values /in: go stop stop
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

class Ask(Node):
    def __init__(self):
        super().__init__('ask')
        self.client = self.create_client(Trigger, '/query')
        self.pub = self.create_publisher(String, '/answer', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        if msg.data == 'go':
            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.pub.publish(String(data=future.result().message))


def main():
    rclpy.init()
    rclpy.spin(Ask())


if __name__ == '__main__':
    main()
