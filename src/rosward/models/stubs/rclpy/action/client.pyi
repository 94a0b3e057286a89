# SPDX-License-Identifier: Apache-2.0
"""rclpy.action.client.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, create, creates, either, message, reads_only, schedule, sends, unknown, waits

from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.task import Future
from rclpy.waitable import Waitable

reads_only(__name__)


class _Feedback:
    """Stands for the message on NAME/_action/feedback."""

    def __init__(self, action_type):
        self.goal_id = unknown("message", "goal id")
        self.feedback = message(action_type.Feedback, "feedback")


class _GetResultResponse:
    """Stands for the response of NAME/_action/get_result."""

    def __init__(self, action_type):
        self.status = unknown("message", "status of the goal")
        self.result = message(action_type.Result, "result")


class ClientGoalHandle:
    def __init__(self, action_client, goal_id, goal_response):
        self._action_client = action_client

    def __eq__(self, other) -> bool: ...
    def __ne__(self, other) -> bool: ...

    @property
    def goal_id(self): ...

    @property
    def stamp(self): ...

    @property
    def accepted(self):
        return unknown("message", "answer to a goal", "bool")

    @property
    def status(self):
        return unknown("message", "answer to a goal", "int")

    @sends("cancel", "", "_action_client._node", "_action_client._action_name", "_action_client._action_type")
    @waits
    def cancel_goal(self): ...

    @sends("cancel", "", "_action_client._node", "_action_client._action_name", "_action_client._action_type")
    def cancel_goal_async(self):
        future = Future()
        future._result = unknown("message", "response to a cancel request")
        return future

    @waits
    def get_result(self):
        return _GetResultResponse(self._action_client._action_type)

    def get_result_async(self):
        future = Future()
        future._result = either(None, _GetResultResponse(self._action_client._action_type))
        return future


class ActionClient(Waitable):
    @creates("action_client", node="node", name="action_name", type="action_type")
    def __init__(
        self,
        node,
        action_type,
        action_name,
        *,
        callback_group=None,
        goal_service_qos_profile=qos_profile_services_default,
        result_service_qos_profile=qos_profile_services_default,
        cancel_service_qos_profile=qos_profile_services_default,
        feedback_sub_qos_profile=QoSProfile(depth=10),
        status_sub_qos_profile=qos_profile_action_status_default,
    ):
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        ask(node, "add_waitable", self)
        ask(node, "get_logger")

    def is_ready(self, wait_set) -> bool: ...
    def take_data(self): ...
    def execute(self, taken_data) -> None: ...
    def get_num_entities(self): ...
    def add_to_wait_set(self, wait_set) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, t, v, tb) -> None: ...

    @waits
    @sends("goal", "goal", "_node", "_action_name", "_action_type.Goal")
    def send_goal(self, goal, **kwargs):
        if "feedback_callback" in kwargs:
            schedule(kwargs["feedback_callback"], _Feedback(self._action_type), event="feedback")
        return _GetResultResponse(self._action_type)

    @sends("goal", "goal", "_node", "_action_name", "_action_type.Goal")
    def send_goal_async(self, goal, feedback_callback=None, goal_uuid=None):
        if feedback_callback is not None:
            schedule(feedback_callback, _Feedback(self._action_type), event="feedback")
        future = Future()
        future._result = either(None, ClientGoalHandle(self, goal_uuid, None))
        return future

    # What a goal handle calls, and programs that keep one.

    def _cancel_goal(self, goal_handle):
        return goal_handle.cancel_goal()

    def _cancel_goal_async(self, goal_handle):
        return goal_handle.cancel_goal_async()

    def _get_result(self, goal_handle):
        return goal_handle.get_result()

    def _get_result_async(self, goal_handle):
        return goal_handle.get_result_async()

    @waits
    def server_is_ready(self) -> bool: ...
    @waits
    def wait_for_server(self, timeout_sec=None) -> bool: ...

    def configure_introspection(self, clock, service_event_qos_profile, introspection_state):
        if introspection_state != ServiceIntrospectionState.OFF:
            create(
                "action_client",  # of which the event publisher is recorded
                self._node,
                self._action_name,
                self._action_type,
                qos=service_event_qos_profile,
                introspection=True,
            )

    def destroy(self):
        ask(self._node, "remove_waitable", self)
