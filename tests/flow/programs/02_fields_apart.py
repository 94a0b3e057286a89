# SPDX-License-Identifier: Apache-2.0
"""Two fields of one message come from two topics, two outputs take one each.

/speed <- data /odom; never /imu; trigger timer
/turn <- data /imu; never /odom; trigger timer
/both <- data /odom /imu; trigger timer
"""

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from sensor_msgs.msg import Imu
from std_msgs.msg import Float64


class Fields(Node):
    def __init__(self):
        super().__init__('fields')
        self.cmd = Twist()
        self.speed = self.create_publisher(Float64, '/speed', 10)
        self.turn = self.create_publisher(Float64, '/turn', 10)
        self.both = self.create_publisher(Twist, '/both', 10)
        self.create_subscription(Odometry, '/odom', self.on_odom, 10)
        self.create_subscription(Imu, '/imu', self.on_imu, 10)
        self.create_timer(0.1, self.tick)

    def on_odom(self, msg):
        self.cmd.linear.x = msg.twist.twist.linear.x

    def on_imu(self, msg):
        self.cmd.angular.z = msg.angular_velocity.z

    def tick(self):
        self.speed.publish(Float64(data=self.cmd.linear.x))
        self.turn.publish(Float64(data=self.cmd.angular.z))
        self.both.publish(self.cmd)


def main():
    rclpy.init()
    rclpy.spin(Fields())


if __name__ == '__main__':
    main()
