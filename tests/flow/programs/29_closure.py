# SPDX-License-Identifier: Apache-2.0
"""Two closures share a variable of the function around them.

/out <- data /in; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


def main():
    rclpy.init()
    node = Node('closures')
    value = 0.0
    pub = node.create_publisher(Float64, '/out', 10)

    def on_in(msg):
        nonlocal value
        value = msg.data

    def tick():
        pub.publish(Float64(data=value))

    node.create_subscription(Float64, '/in', on_in, 10)
    node.create_timer(0.1, tick)
    rclpy.spin(node)


if __name__ == '__main__':
    main()
