# SPDX-License-Identifier: Apache-2.0
"""A round trip through JSON; one field is left out.

/out <- data /in; never /secret; trigger timer
"""

import json

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Json(Node):
    def __init__(self):
        super().__init__('json')
        self.text = '{}'
        self.secret = ''
        self.pub = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)
        self.create_subscription(String, '/secret', self.on_secret, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.text = json.dumps({'value': msg.data})

    def on_secret(self, msg):
        self.secret = json.dumps({'key': msg.data})

    def tick(self):
        self.pub.publish(String(data=json.loads(self.text).get('value', '')))


def main():
    rclpy.init()
    rclpy.spin(Json())


if __name__ == '__main__':
    main()
