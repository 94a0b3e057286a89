# SPDX-License-Identifier: Apache-2.0
"""An object that is no node keeps the state between callbacks.

/throttle <- data /height /target; never /battery; trigger /height
"""

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Float64


class Pid:
    def __init__(self, kp, ki):
        self.kp, self.ki = kp, ki
        self.target = 0.0
        self.integral = 0.0

    def step(self, measured):
        error = self.target - measured
        self.integral += error
        return self.kp * error + self.ki * self.integral


class Control(Node):
    def __init__(self):
        super().__init__('control')
        self.pid = Pid(1.5, 0.1)
        self.pub = self.create_publisher(Float64, '/throttle', 10)
        self.create_subscription(Float64, '/height', self.on_height, 10)
        self.create_subscription(Float64, '/target', self.on_target, 10)
        self.create_subscription(BatteryState, '/battery', self.on_battery, 10)

    def on_target(self, msg):
        self.pid.target = msg.data

    def on_battery(self, msg):
        self.level = msg.percentage

    def on_height(self, msg):
        self.pub.publish(Float64(data=self.pid.step(msg.data)))


def main():
    rclpy.init()
    rclpy.spin(Control())


if __name__ == '__main__':
    main()
