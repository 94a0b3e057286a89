# SPDX-License-Identifier: Apache-2.0
"""Which rights on DDS does an endpoint of ROS need?

    publisher /chatter   ->  publish rt/chatter
    service client /add  ->  publish rq/addRequest, subscribe rr/addReply
    action server /dock  ->  three services and two topics below /dock/_action

It is what sros2 makes of a policy (permissions.xsl), so that a policy and permissions are compared, and written, in one form.
"""

from __future__ import annotations

import enum
from typing import Final

from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind

__all__ = ["ACTION_SERVICES", "ACTION_TOPICS", "DISCOVERY", "Direction", "Right", "rights_of"]


class Direction(enum.Enum):
    """The two things that permissions speak of."""

    PUBLISH = "publish"
    SUBSCRIBE = "subscribe"


class Right(NamedTuple):
    """To publish or to subscribe to a topic of DDS; the name may be a pattern."""

    direction: Direction
    name: str

    def __str__(self) -> str:
        return f"{self.direction.value} {self.name}"


_PUBLISH, _SUBSCRIBE = Direction.PUBLISH, Direction.SUBSCRIBE

DISCOVERY: Final = (Right(_PUBLISH, "ros_discovery_info"), Right(_SUBSCRIBE, "ros_discovery_info"))
"""Every RMW on DDS needs these; sros2 adds them to what a policy says."""

ACTION_SERVICES: Final = ("cancel_goal", "get_result", "send_goal")
ACTION_TOPICS: Final = ("feedback", "status")
"""The parts of an action, below its name."""


def rights_of(kind: EntityKind, name: str, *, ros: bool = True) -> tuple[Right, ...]:
    """The rights that an endpoint of this kind and full name needs. Not `ros`: a topic outside the ROS namespace has the same name on DDS."""
    if not ros:
        return (Right(_PUBLISH if kind is EntityKind.PUBLISHER else _SUBSCRIBE, name),)
    match kind:
        case EntityKind.PUBLISHER:
            return (Right(_PUBLISH, f"rt{name}"),)
        case EntityKind.SUBSCRIPTION:
            return (Right(_SUBSCRIBE, f"rt{name}"),)
        case EntityKind.SERVICE_CLIENT:
            return _service(name, _PUBLISH, _SUBSCRIBE)
        case EntityKind.SERVICE_SERVER:
            return _service(name, _SUBSCRIBE, _PUBLISH)
        case EntityKind.ACTION_CLIENT:
            return _action(name, _PUBLISH, _SUBSCRIBE)
        case EntityKind.ACTION_SERVER:
            return _action(name, _SUBSCRIBE, _PUBLISH)


def _service(name: str, request: Direction, reply: Direction) -> tuple[Right, ...]:
    return (Right(request, f"rq{name}Request"), Right(reply, f"rr{name}Reply"))


def _action(name: str, request: Direction, reply: Direction) -> tuple[Right, ...]:
    services = (right for part in ACTION_SERVICES for right in _service(f"{name}/_action/{part}", request, reply))
    return (*services, *(Right(reply, f"rt{name}/_action/{part}") for part in ACTION_TOPICS))
