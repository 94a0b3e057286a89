# SPDX-License-Identifier: Apache-2.0
"""Messages leave ROS: into a file, a process, a socket, the console.

file <- data /a; never /b /c /d; trigger /a
process <- data /b; never /a /c /d; trigger /b
network <- data /c; never /a /b /d; trigger /c
stdout <- data /d; never /a /b /c; trigger /d
"""

import socket
import subprocess

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Outside(Node):
    def __init__(self):
        super().__init__('outside')
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.create_subscription(String, '/a', self.on_a, 10)
        self.create_subscription(String, '/b', self.on_b, 10)
        self.create_subscription(String, '/c', self.on_c, 10)
        self.create_subscription(String, '/d', self.on_d, 10)

    def on_a(self, msg):
        with open('/tmp/flow.txt', 'a') as file:
            file.write(msg.data + '\n')

    def on_b(self, msg):
        subprocess.run(['say', msg.data])

    def on_c(self, msg):
        self.socket.sendto(msg.data.encode(), ('127.0.0.1', 9))

    def on_d(self, msg):
        print('got', msg.data)


def main():
    rclpy.init()
    rclpy.spin(Outside())


if __name__ == '__main__':
    main()
