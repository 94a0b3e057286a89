# SPDX-License-Identifier: Apache-2.0
"""A worker thread takes from a queue what a callback puts in.

/out <- data /in; trigger thread
"""

import queue
import threading

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.jobs = queue.Queue()
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)
        threading.Thread(target=self.work, daemon=True).start()

    def on_in(self, msg):
        self.jobs.put(msg.data)

    def work(self):
        while rclpy.ok():
            job = self.jobs.get()
            self.pub.publish(String(data=f'done {job}'))


def main():
    rclpy.init()
    rclpy.spin(Worker())


if __name__ == '__main__':
    main()
