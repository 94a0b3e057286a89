# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.action_clients: an action client on the node of the tree.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from _rosward import reads_only

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard
from rclpy.action import ActionClient


@reads_only
class FromBlackboard(Behaviour):
    def __init__(
        self, name, action_type, action_name, key, generate_feedback_message=None, wait_for_server_timeout_sec=-3.0
    ):
        Behaviour.__init__(self, name)
        self.action_type = action_type
        self.action_name = action_name
        self.key = key
        self.result_message = None
        self.generate_feedback_message = generate_feedback_message
        self.node = None

    def setup(self, **kwargs):
        self.node = kwargs["node"]
        self.action_client = ActionClient(node=self.node, action_type=self.action_type, action_name=self.action_name)

    def update(self):
        if self.result_message is None and Blackboard.exists(self.key):
            self.send_goal_request(Blackboard.get(self.key))
        return common._status(self.result_message)

    def feedback_callback(self, msg):
        if self.generate_feedback_message is not None:
            self.feedback_message = self.generate_feedback_message(msg)

    def send_goal_request(self, goal):
        future = self.action_client.send_goal_async(goal, feedback_callback=self.feedback_callback)
        future.add_done_callback(self.goal_response_callback)

    def goal_response_callback(self, future):
        future.result().get_result_async().add_done_callback(self.get_result_callback)

    def get_result_callback(self, future):
        self.result_message = future.result()

    def send_cancel_request(self) -> None: ...
    def cancel_response_callback(self, future) -> None: ...


class FromConstant(FromBlackboard):
    def __init__(
        self,
        name,
        action_type,
        action_name,
        action_goal,
        generate_feedback_message=None,
        wait_for_server_timeout_sec=-3.0,
    ):
        FromBlackboard.__init__(
            self, name, action_type, action_name, "goal", generate_feedback_message, wait_for_server_timeout_sec
        )
        self.goal = action_goal

    def update(self):
        if self.result_message is None:
            self.send_goal_request(self.goal)
        return common._status(self.result_message)
