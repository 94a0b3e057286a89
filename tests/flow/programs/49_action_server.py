# SPDX-License-Identifier: Apache-2.0
"""The goal is in feedback and result; a topic aborts it.

feedback:/count <- data goal:/count; control /stop; trigger goal:/count
result:/count <- data goal:/count; control /stop; trigger goal:/count
values /stop: true false false
"""

import rclpy
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import Bool
from test_msgs.action import Fibonacci

class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.stopped = False
        self.create_subscription(Bool, '/stop', self.on_stop, 10)
        self.server = ActionServer(self, Fibonacci, '/count', self.execute)

    def on_stop(self, msg):
        self.stopped = msg.data

    def execute(self, goal):
        result = Fibonacci.Result()
        if self.stopped:
            goal.abort()
            return result
        feedback = Fibonacci.Feedback()
        feedback.sequence = [goal.request.order, goal.request.order * 2]
        goal.publish_feedback(feedback)
        goal.succeed()
        result.sequence = feedback.sequence
        return result


def main():
    rclpy.init()
    rclpy.spin(Server())


if __name__ == '__main__':
    main()
