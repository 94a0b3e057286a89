# SPDX-License-Identifier: Apache-2.0
"""Which writers and readers does a node have on DDS? Written from what ROS 2 does there, not from our own outputs.

service server /add of example_interfaces/srv/AddTwoInts
  ->  read  rq/addRequest  example_interfaces::srv::dds_::AddTwoInts_Request_
      write rr/addReply    example_interfaces::srv::dds_::AddTwoInts_Response_
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final, NamedTuple

from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["DISCOVERY", "Endpoint", "endpoints_of", "turned"]


class Endpoint(NamedTuple):
    """A writer or a reader of a topic of DDS."""

    way: str
    topic: str
    type: str


_GRAPH: Final = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"
DISCOVERY: Final = frozenset(
    {Endpoint("write", "ros_discovery_info", _GRAPH), Endpoint("read", "ros_discovery_info", _GRAPH)}
)
"""What the RMW makes once in each process."""

_ANY: Final = "std_msgs/msg/String"
_NAME: Final = re.compile(r"(/[A-Za-z0-9_*]+)+")


def endpoints_of(*nodes: Node) -> frozenset[Endpoint]:
    """All endpoints of a process with these nodes, but for those whose name is not known."""
    known = [e for n in nodes for e in n.entities if e.resolution is not Resolution.UNKNOWN and _NAME.fullmatch(e.name)]
    return DISCOVERY.union(*map(_of, known))


def turned(endpoint: Endpoint) -> Endpoint:
    """The same topic, the other way."""
    return endpoint._replace(way="read" if endpoint.way == "write" else "write")


def _of(entity: Entity) -> Iterator[Endpoint]:
    package, folder, name = (entity.type or _ANY).split("/")
    match entity.kind:
        case EntityKind.PUBLISHER | EntityKind.SUBSCRIPTION:
            way = "write" if entity.kind is EntityKind.PUBLISHER else "read"
            yield Endpoint(
                way, ("rt" if entity.ros_prefix else "") + entity.name, f"{package}::{folder}::dds_::{name}_"
            )
        case EntityKind.SERVICE_SERVER | EntityKind.SERVICE_CLIENT:
            server = entity.kind is EntityKind.SERVICE_SERVER
            yield from _service(entity.name, f"{package}::{folder}::dds_::{name}", server=server)
        case EntityKind.ACTION_SERVER | EntityKind.ACTION_CLIENT:
            server = entity.kind is EntityKind.ACTION_SERVER
            hidden, type_ = f"{entity.name}/_action", f"{package}::{folder}::dds_::{name}"
            yield from _service(f"{hidden}/send_goal", f"{type_}_SendGoal", server=server)
            yield from _service(f"{hidden}/get_result", f"{type_}_GetResult", server=server)
            yield from _service(f"{hidden}/cancel_goal", "action_msgs::srv::dds_::CancelGoal", server=server)
            way = "write" if server else "read"
            yield Endpoint(way, f"rt{hidden}/feedback", f"{type_}_FeedbackMessage_")
            yield Endpoint(way, f"rt{hidden}/status", "action_msgs::msg::dds_::GoalStatusArray_")


def _service(name: str, type_: str, *, server: bool) -> Iterator[Endpoint]:
    asks, answers = ("read", "write") if server else ("write", "read")
    yield Endpoint(asks, f"rq{name}Request", f"{type_}_Request_")
    yield Endpoint(answers, f"rr{name}Reply", f"{type_}_Response_")
