# SPDX-License-Identifier: Apache-2.0
"""Drives the wheels: velocity commands in, odometry out."""

import math

from delivery_common.nodes import HardwareNode
from delivery_common.qos import COMMAND, SENSOR
from delivery_common.run import run
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import BatteryState
from std_srvs.srv import SetBool
from tf2_ros import TransformBroadcaster


class BaseDriver(HardwareNode):
    """The motor controller of the robot."""

    hardware_id = 'wheels'

    def __init__(self):
        super().__init__('base_driver')
        rate = self.declare_parameter('rate', 20.0).value
        self._period = 1.0 / rate
        self._enabled = True
        self._command = Twist()
        self._x = self._y = self._yaw = 0.0
        self.create_subscription(Twist, 'cmd_vel', self._on_command, COMMAND)
        self._odometry = self.create_publisher(Odometry, 'odom', SENSOR)
        self._battery = self.create_publisher(BatteryState, 'battery', SENSOR)
        self._transforms = TransformBroadcaster(self)
        self.create_service(SetBool, '~/enable', self._on_enable)
        self.create_timer(self._period, self._step)
        self.create_timer(1.0, lambda: self._battery.publish(BatteryState(percentage=0.8)))

    def check(self, status):
        """Report a switched-off drive."""
        if self._enabled:
            return super().check(status)
        status.summary(DiagnosticStatus.WARN, 'drive is switched off')
        return status

    def _on_command(self, command):
        self._command = command if self._enabled else Twist()

    def _on_enable(self, request, response):
        self._enabled = request.data
        response.success = True
        return response

    def _step(self):
        speed = self._command.linear.x * self._period
        self._yaw += self._command.angular.z * self._period
        self._x += speed * math.cos(self._yaw)
        self._y += speed * math.sin(self._yaw)
        odometry = Odometry()
        odometry.header.stamp = self.get_clock().now().to_msg()
        odometry.header.frame_id = 'odom'
        odometry.child_frame_id = 'base_link'
        odometry.pose.pose.position.x = self._x
        odometry.pose.pose.position.y = self._y
        odometry.pose.pose.orientation.z = math.sin(self._yaw / 2.0)
        odometry.pose.pose.orientation.w = math.cos(self._yaw / 2.0)
        odometry.twist.twist = self._command
        self._odometry.publish(odometry)

        transform = TransformStamped(header=odometry.header, child_frame_id='base_link')
        transform.transform.translation.x = self._x
        transform.transform.translation.y = self._y
        transform.transform.rotation = odometry.pose.pose.orientation
        self._transforms.sendTransform(transform)


def main(args=None):
    """Run the node."""
    run(BaseDriver, args=args)


if __name__ == '__main__':
    main()
