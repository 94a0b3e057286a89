# SPDX-License-Identifier: Apache-2.0
"""rclpy.action.server: goals, their acceptance, execution and cancelling may come at any time.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from enum import Enum, IntEnum

from _rosward import ask, create, creates, message, reads_only, schedule, sender, sends, unknown

from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.waitable import Waitable

reads_only(__name__)


class GoalResponse(Enum):
    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    REJECT = 1
    ACCEPT = 2


class GoalEvent(IntEnum):
    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


class ServerGoalHandle:
    def __init__(self, action_server, goal_info, goal_request):
        self._action_server = action_server
        self._goal_request = goal_request

    def __eq__(self, other) -> bool: ...
    def __ne__(self, other) -> bool: ...

    @property
    def request(self):
        return self._goal_request

    @property
    def goal_id(self): ...

    @property
    def is_active(self) -> bool: ...

    @property
    def is_cancel_requested(self):
        return unknown("message", "cancel request", "bool")

    @property
    def status(self) -> int: ...

    def execute(self, execute_callback=None):
        self._action_server.notify_execute(self, execute_callback)

    @sends(
        "feedback",
        "feedback",
        "_action_server._node",
        "_action_server._action_name",
        "_action_server._action_type.Feedback",
    )
    def publish_feedback(self, feedback) -> None: ...

    def succeed(self) -> None: ...
    def abort(self) -> None: ...
    def canceled(self) -> None: ...
    def destroy(self) -> None: ...


def default_handle_accepted_callback(goal_handle):
    goal_handle.execute()


def default_goal_callback(goal_request):
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request):
    return CancelResponse.REJECT


class ActionServer(Waitable):
    @creates("action_server", node="node", name="action_name", type="action_type", callback="execute_callback")
    def __init__(
        self,
        node,
        action_type,
        action_name,
        execute_callback,
        *,
        callback_group=None,
        goal_callback=default_goal_callback,
        handle_accepted_callback=default_handle_accepted_callback,
        cancel_callback=default_cancel_callback,
        goal_service_qos_profile=qos_profile_services_default,
        result_service_qos_profile=qos_profile_services_default,
        cancel_service_qos_profile=qos_profile_services_default,
        feedback_pub_qos_profile=QoSProfile(depth=10),
        status_pub_qos_profile=qos_profile_action_status_default,
        result_timeout=900,
    ):
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        self._execute_callback = execute_callback
        ask(node, "get_clock")
        self.register_goal_callback(goal_callback)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_cancel_callback(cancel_callback)
        if execute_callback is not None:
            self.register_execute_callback(execute_callback)
        ask(node, "add_waitable", self)
        ask(node, "get_logger")

    def _goal(self):
        return ServerGoalHandle(self, None, message(self._action_type.Goal, "goal"))

    def _result(self):
        return sender("result", self._node, self._action_name, self._action_type.Result)

    @property
    def action_type(self):
        return self._action_type

    def is_ready(self, wait_set) -> bool: ...
    def take_data(self): ...
    def execute(self, taken_data) -> None: ...
    def get_num_entities(self): ...
    def add_to_wait_set(self, wait_set) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, t, v, tb) -> None: ...

    def notify_execute(self, goal_handle, execute_callback):
        callback = self._execute_callback if execute_callback is None else execute_callback
        if callback is not None:
            schedule(callback, goal_handle, event="execute", answered=self._result())

    def notify_goal_done(self) -> None: ...

    def register_handle_accepted_callback(self, handle_accepted_callback):
        if handle_accepted_callback is not None:
            schedule(handle_accepted_callback, self._goal(), event="accepted")

    def register_goal_callback(self, goal_callback):
        if goal_callback is not None:
            schedule(goal_callback, message(self._action_type.Goal, "goal"), event="goal")

    def register_cancel_callback(self, cancel_callback):
        if cancel_callback is not None:
            schedule(cancel_callback, self._goal(), event="cancel")

    def register_execute_callback(self, execute_callback):
        self._execute_callback = execute_callback
        schedule(execute_callback, self._goal(), event="execute", answered=self._result())

    def configure_introspection(self, clock, service_event_qos_profile, introspection_state):
        if introspection_state != ServiceIntrospectionState.OFF:
            create(
                "action_server",  # of which the event publisher is recorded
                self._node,
                self._action_name,
                self._action_type,
                qos=service_event_qos_profile,
                introspection=True,
            )

    def destroy(self):
        ask(self._node, "remove_waitable", self)
