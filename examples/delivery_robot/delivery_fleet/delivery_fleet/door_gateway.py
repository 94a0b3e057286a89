# SPDX-License-Identifier: Apache-2.0
"""Lets the robots open the doors of the building."""

from delivery_common.names import BUILDING, DOOR_SERVICE
from delivery_common.qos import STATE
from delivery_common.run import run
from delivery_interfaces.srv import OpenDoor
from rclpy.node import Node
from std_msgs.msg import Bool

DOORS = {'lobby': 'A1', 'laboratory': 'B7'}


class DoorGateway(Node):
    """Stands between ROS and the door controllers."""

    def __init__(self):
        super().__init__('door_gateway', namespace=BUILDING)
        self._states = {
            door: self.create_publisher(Bool, 'doors/{}/open'.format(door), STATE) for door in DOORS
        }
        self.create_service(OpenDoor, DOOR_SERVICE, self._on_open)

    def _on_open(self, request, response):
        address = DOORS.get(request.door)
        if address is None:
            response.message = f'there is no door {request.door}'
            return response
        self.get_logger().info(f'opening {request.door} at {address}')
        self._states[request.door].publish(Bool(data=True))
        response.open = True
        return response


def main(args=None):
    """Run the node."""
    run(DoorGateway, args=args)


if __name__ == '__main__':
    main()
