# SPDX-License-Identifier: Apache-2.0
"""A parameter that is set while it runs reaches a field.

/out <- data parameter:offset; trigger timer
"""

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from std_msgs.msg import Float64

class Offset(Node):
    def __init__(self):
        super().__init__('offset')
        self.declare_parameter('offset', 1.0)
        self.declare_parameter('unused', 1.0)
        self.offset = self.get_parameter('offset').value
        self.pub = self.create_publisher(Float64, '/out', 10)
        self.add_on_set_parameters_callback(self.on_set)
        self.create_timer(0.5, self.tick)

    def on_set(self, parameters):
        for parameter in parameters:
            if parameter.name == 'offset':
                self.offset = parameter.value
        return SetParametersResult(successful=True)

    def tick(self):
        self.pub.publish(Float64(data=self.offset))


def main():
    rclpy.init()
    rclpy.spin(Offset())


if __name__ == '__main__':
    main()
