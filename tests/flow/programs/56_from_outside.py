# SPDX-License-Identifier: Apache-2.0
"""What comes from outside is published: a socket, a file, the clock, a process.

/net <- data network; trigger thread
/config <- data file; trigger main
/time <- data clock; trigger timer
/shell <- data process; trigger timer
process <- trigger timer
"""

import socket
import subprocess
import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String

class Inside(Node):
    def __init__(self):
        super().__init__('inside')
        self.net = self.create_publisher(String, '/net', 10)
        self.config = self.create_publisher(String, '/config', 10)
        self.time = self.create_publisher(Float64, '/time', 10)
        self.shell = self.create_publisher(String, '/shell', 10)
        with open('/etc/hostname', 'r') as file:
            self.config.publish(String(data=file.read()))
        self.socket = socket.socket()
        threading.Thread(target=self.listen, daemon=True).start()
        self.create_timer(1.0, self.tick)

    def listen(self):
        while rclpy.ok():
            data = self.socket.recv(100)
            if data:
                self.net.publish(String(data=data.decode()))

    def tick(self):
        self.time.publish(Float64(data=time.time()))
        self.shell.publish(String(data=subprocess.check_output(['uptime'], text=True)))


def main():
    rclpy.init()
    rclpy.spin(Inside())


if __name__ == '__main__':
    main()
