# SPDX-License-Identifier: Apache-2.0
"""It publishes as soon as both inputs have arrived; only one of them is in the message.

/out <- data /pose; arrival /map; trigger /pose /map
"""

import rclpy
from geometry_msgs.msg import Pose
from nav_msgs.msg import OccupancyGrid
from rclpy.node import Node


class Ready(Node):
    def __init__(self):
        super().__init__('ready')
        self.have_map = False
        self.pose = None
        self.pub = self.create_publisher(Pose, '/out', 10)
        self.create_subscription(OccupancyGrid, '/map', self.on_map, 10)
        self.create_subscription(Pose, '/pose', self.on_pose, 10)

    def on_map(self, msg):
        self.have_map = True
        self.send()

    def on_pose(self, msg):
        self.pose = msg
        self.send()

    def send(self):
        if self.have_map and self.pose is not None:
            self.pub.publish(self.pose)


def main():
    rclpy.init()
    rclpy.spin(Ready())


if __name__ == '__main__':
    main()
