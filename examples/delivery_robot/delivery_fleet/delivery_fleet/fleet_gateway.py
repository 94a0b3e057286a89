# SPDX-License-Identifier: Apache-2.0
"""Takes orders from the building's staff and hands them to the robots."""

from functools import partial
from itertools import count, cycle

from delivery_common.names import FLEET, ROBOT
from delivery_common.run import run
from delivery_interfaces.action import Deliver
from delivery_interfaces.msg import DeliveryStatus
from delivery_interfaces.srv import RequestDelivery
from rclpy.action import ActionClient
from rclpy.node import Node


class FleetGateway(Node):
    """One action client for each robot of the fleet."""

    def __init__(self):
        super().__init__('gateway', namespace=FLEET)
        robots = self.declare_parameter('robots', [ROBOT]).value
        self._robots = {robot: ActionClient(self, Deliver, f'/{robot}/deliver') for robot in robots}
        self._turn = cycle(robots)
        self._numbers = count(1)
        self._status = self.create_publisher(DeliveryStatus, 'deliveries', 10)
        self.create_service(RequestDelivery, 'request_delivery', self._on_request)

    def _on_request(self, request, response):
        robot = next(self._turn)
        client = self._robots[robot]
        response.accepted = client.server_is_ready()
        if response.accepted:
            response.robot = robot
            response.delivery_id = f'{robot}-{next(self._numbers)}'
            goal = Deliver.Goal(
                delivery_id=response.delivery_id,
                destination=request.destination,
                doors=request.doors,
            )
            future = client.send_goal_async(goal)
            future.add_done_callback(partial(self._on_answer, robot, goal.delivery_id))
        return response

    def _on_answer(self, robot, delivery_id, future):
        handle = future.result()
        if not handle.accepted:
            self._tell(robot, delivery_id, DeliveryStatus.FAILED)
            return
        self._tell(robot, delivery_id, DeliveryStatus.UNDER_WAY)
        handle.get_result_async().add_done_callback(partial(self._on_result, robot, delivery_id))

    def _on_result(self, robot, delivery_id, future):
        delivered = future.result().result.delivered
        self._tell(robot, delivery_id, DeliveryStatus.DELIVERED if delivered else DeliveryStatus.FAILED)

    def _tell(self, robot, delivery_id, state):
        now = self.get_clock().now().to_msg()
        self._status.publish(DeliveryStatus(stamp=now, robot=robot, delivery_id=delivery_id, state=state))


def main(args=None):
    """Run the node."""
    run(FleetGateway, args=args)


if __name__ == '__main__':
    main()
