# SPDX-License-Identifier: Apache-2.0
"""Functions in a dict, chosen by the message; each publishes something else.

/stop <- control /command; never /speed; trigger /command
/go <- data /speed; control /command; trigger /command
values /command: stop go wait
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String


class Dispatch(Node):
    def __init__(self):
        super().__init__('dispatch')
        self.speed = 0.0
        self.stop = self.create_publisher(Float64, '/stop', 10)
        self.go = self.create_publisher(Float64, '/go', 10)
        self.commands = {'stop': self.do_stop, 'go': self.do_go}
        self.create_subscription(String, '/command', self.on_command, 10)
        self.create_subscription(Float64, '/speed', self.on_speed, 10)

    def on_speed(self, msg):
        self.speed = msg.data

    def do_stop(self):
        self.stop.publish(Float64(data=0.0))

    def do_go(self):
        self.go.publish(Float64(data=self.speed))

    def on_command(self, msg):
        action = self.commands.get(msg.data)
        if action is not None:
            action()


def main():
    rclpy.init()
    rclpy.spin(Dispatch())


if __name__ == '__main__':
    main()
