# SPDX-License-Identifier: Apache-2.0
"""Carries out deliveries: drives to a place, through the doors on the way."""

import math

from delivery_common.nodes import HeartbeatNode
from delivery_common.qos import COMMAND, STATE
from delivery_common.run import run
from delivery_interfaces.action import Deliver
from geometry_msgs.msg import PoseStamped, Twist
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_msgs.msg import Bool

from delivery_navigation.doors import DoorOpener


class DeliveryPlanner(HeartbeatNode):
    """The action server behind `deliver`."""

    def __init__(self):
        super().__init__('delivery_planner')
        self._pose = PoseStamped()
        self._battery_low = False
        self._doors = DoorOpener(self)
        self._drive = self.create_publisher(Twist, 'teleop/mux/planner', COMMAND)
        self.create_subscription(PoseStamped, 'pose', self._on_pose, STATE)
        self.create_subscription(Bool, 'battery_low', self._on_battery_low, STATE)
        self._server = ActionServer(
            self,
            Deliver,
            'deliver',
            execute_callback=self._deliver,
            goal_callback=self._on_goal,
            cancel_callback=lambda goal: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )

    def _on_pose(self, pose):
        self._pose = pose

    def _on_battery_low(self, low):
        self._battery_low = low.data

    def _on_goal(self, goal):
        return GoalResponse.REJECT if self._battery_low else GoalResponse.ACCEPT

    async def _deliver(self, goal_handle):
        goal = goal_handle.request
        for door in goal.doors:
            if not await self._doors.open(door):
                goal_handle.abort()
                return Deliver.Result(delivered=False, message=f'{door} stays closed')
        rate = self.create_rate(5.0)
        while (distance := self._distance(goal.destination)) > 0.1:
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                return Deliver.Result(delivered=False, message='cancelled')
            command = Twist()
            command.linear.x = min(0.5, distance)
            self._drive.publish(command)
            goal_handle.publish_feedback(Deliver.Feedback(distance_remaining=distance))
            rate.sleep()
        goal_handle.succeed()
        return Deliver.Result(delivered=True)

    def _distance(self, destination):
        here, there = self._pose.pose.position, destination.pose.position
        return math.hypot(there.x - here.x, there.y - here.y)


def main(args=None):
    """Run the node."""
    run(DeliveryPlanner, executor_class=MultiThreadedExecutor, args=args)


if __name__ == '__main__':
    main()
