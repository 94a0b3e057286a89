# SPDX-License-Identifier: Apache-2.0
"""A message becomes a goal; feedback and result are published.

goal:/count <- data /order; trigger /order
/progress <- data feedback:/count; never result:/count; trigger feedback:/count
/result <- data result:/count; never feedback:/count; trigger result:/count
"""

import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Int32
from test_msgs.action import Fibonacci

class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = ActionClient(self, Fibonacci, '/count')
        self.progress = self.create_publisher(Int32, '/progress', 10)
        self.result = self.create_publisher(Int32, '/result', 10)
        self.create_subscription(Int32, '/order', self.on_order, 10)

    def on_order(self, msg):
        goal = Fibonacci.Goal(order=msg.data)
        self.client.send_goal_async(goal, feedback_callback=self.on_feedback).add_done_callback(self.on_accept)

    def on_feedback(self, message):
        self.progress.publish(Int32(data=message.feedback.sequence[-1]))

    def on_accept(self, future):
        handle = future.result()
        if handle.accepted:
            handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future):
        self.result.publish(Int32(data=sum(future.result().result.sequence)))


def main():
    rclpy.init()
    rclpy.spin(Client())


if __name__ == '__main__':
    main()
