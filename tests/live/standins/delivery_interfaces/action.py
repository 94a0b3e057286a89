# SPDX-License-Identifier: Apache-2.0
"""delivery_interfaces/action. A goal leads through a door by default: without one, no door would ever be opened."""
# mypy: ignore-errors

from borrowed import message
from geometry_msgs.msg import PoseStamped
from test_msgs.action import Fibonacci

_Result = message(Fibonacci.Result, delivered=bool, message=str)
_GetResult = Fibonacci.Impl.GetResultService


class _GetResultService(_GetResult):
    Response = message(_GetResult.Response, result=_Result)


class _Impl(Fibonacci.Impl):
    GetResultService = _GetResultService


class Deliver(Fibonacci):
    """The action of the robots."""

    Goal = message(Fibonacci.Goal, delivery_id=str, destination=PoseStamped, doors=lambda: ["lobby"])
    Result = _Result
    Feedback = message(Fibonacci.Feedback, distance_remaining=float)
    Impl = _Impl
