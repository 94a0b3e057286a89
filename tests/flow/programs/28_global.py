# SPDX-License-Identifier: Apache-2.0
"""A module variable is the conduit, functions are the callbacks.

/out <- data /in; trigger timer
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


latest = 0.0


def on_in(msg):
    global latest
    latest = msg.data


def main():
    rclpy.init()
    node = Node('functions')
    pub = node.create_publisher(Float64, '/out', 10)
    node.create_subscription(Float64, '/in', on_in, 10)
    node.create_timer(0.1, lambda: pub.publish(Float64(data=latest)))
    rclpy.spin(node)


if __name__ == '__main__':
    main()
