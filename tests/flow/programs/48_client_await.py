# SPDX-License-Identifier: Apache-2.0
"""A coroutine waits for the answer; what it was asked is another matter.

/answer <- data response:/switch; never /light; trigger /light
request:/switch <- data /light; trigger /light
values /light: 5 50
"""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool

class Await(Node):
    def __init__(self):
        super().__init__('waiting')
        self.client = self.create_client(SetBool, '/switch')
        self.pub = self.create_publisher(String, '/answer', 10)
        self.create_subscription(Float64, '/light', self.on_light, 10)

    async def on_light(self, msg):
        request = SetBool.Request(data=msg.data > 10.0)
        response = await self.client.call_async(request)
        self.pub.publish(String(data=response.message))


def main():
    rclpy.init()
    rclpy.spin(Await())


if __name__ == '__main__':
    main()
