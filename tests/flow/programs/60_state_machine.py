# SPDX-License-Identifier: Apache-2.0
"""States go on by messages; the outputs are constants that follow the state.

/state <- control /go /stop; never /data; trigger timer
/data_out <- data /data; control /go /stop; trigger /data
values /go: true false
values /stop: false true false false
"""

from enum import Enum

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float64, String

class State(Enum):
    IDLE = 'idle'
    RUN = 'run'


class Machine(Node):
    def __init__(self):
        super().__init__('machine')
        self.state = State.IDLE
        self.pub = self.create_publisher(String, '/state', 10)
        self.data = self.create_publisher(Float64, '/data_out', 10)
        self.create_subscription(Bool, '/go', self.on_go, 10)
        self.create_subscription(Bool, '/stop', self.on_stop, 10)
        self.create_subscription(Float64, '/data', self.on_data, 10)
        self.create_timer(0.1, self.tick)

    def on_go(self, msg):
        if self.state is State.IDLE and msg.data:
            self.state = State.RUN

    def on_stop(self, msg):
        if msg.data:
            self.state = State.IDLE

    def on_data(self, msg):
        if self.state is State.RUN:
            self.data.publish(msg)

    def tick(self):
        self.pub.publish(String(data=self.state.value))


def main():
    rclpy.init()
    rclpy.spin(Machine())


if __name__ == '__main__':
    main()
