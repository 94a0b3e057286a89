# SPDX-License-Identifier: Apache-2.0
"""What happens to the actions of a program? Each server gets goals and a wish to cancel, each client its answers.

    ActionServer(node, Fibonacci, "count", execute, cancel_callback=cancel)    -> execute(goal) and cancel(goal) are called
    client.send_goal_async(goal, feedback_callback=on_feedback)                -> accepted, with feedback and a result

The handles are rclpy's own; only the way over the middleware is left out.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, Final

from rclpy.action.client import ClientGoalHandle
from rclpy.action.server import ServerGoalHandle
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.task import Future

GoalInfo: Final[Any] = importlib.import_module("action_msgs.msg").GoalInfo
UUID: Final[Any] = importlib.import_module("unique_identifier_msgs.msg").UUID

Call = Callable[..., Any]


def serve_goals(server: Any, number: int, call: Call) -> None:
    """Ask an action server for goals; `call` calls a callback and keeps its exceptions."""
    request = server._action_type.Goal()
    call(server._goal_callback, request)
    first, second = (_accepted(server, 2 * number + k, request) for k in (0, 1))
    call(server._handle_accepted_callback, first)
    call(server._cancel_callback, first)
    second._update_state(_rclpy.GoalEvent.EXECUTE)
    call(server._execute_callback, second)


def _accepted(server: Any, number: int, request: Any) -> Any:
    identity = UUID(uuid=list(number.to_bytes(16, "little")))
    handle = ServerGoalHandle(server, GoalInfo(goal_id=identity), request)
    server._goal_handles[bytes(identity.uuid)] = handle
    server._result_futures[bytes(identity.uuid)] = Future()
    return handle


def answer_goals(client: Any, call: Call) -> None:
    """Accept each goal that an action client has sent, give feedback, and the result where it was asked for."""
    action = client._action_type
    for number, future in list(client._pending_goal_requests.items()):
        response = action.Impl.SendGoalService.Response(accepted=True)
        identity = client._goal_sequence_number_to_goal_id[number]
        if not future.done():
            call(future.set_result, ClientGoalHandle(client, identity, response))
    for callback in list(client._feedback_callbacks.values()):
        call(callback, action.Impl.FeedbackMessage())
    for future in list(client._pending_cancel_requests.values()):
        _done(future, action.Impl.CancelGoalService.Response(), call)
    for future in list(client._pending_result_requests.values()):
        _done(future, action.Impl.GetResultService.Response(), call)


def _done(future: Any, response: Any, call: Call) -> None:
    if not future.done():
        call(future.set_result, response)
