# SPDX-License-Identifier: Apache-2.0
"""What is said of the running system, whoever says it: a snapshot, or the texts of `ros2 node info`.

    LiveNode("/talker", entities=(LiveEntity(PUBLISHER, "/chatter", "std_msgs/msg/String"), …))

An action stands for the topics and services that it is made of: these are no entities of their own where the action is there.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind, Qos

__all__ = [
    "ALL_KINDS",
    "LiveEntity",
    "LiveGraph",
    "LiveNode",
    "is_hidden",
    "part_of_action",
    "with_actions",
]

ALL_KINDS: Final = frozenset(EntityKind)

_PART: Final = re.compile(r"(/.+)/_action/(feedback|status|send_goal|cancel_goal|get_result)")
_TOPICS: Final = frozenset({"feedback", "status"})
_OF_SERVER: Final = frozenset({EntityKind.PUBLISHER, EntityKind.SERVICE_SERVER})
_ENDPOINTS: Final = frozenset({EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION})
_SERVICES: Final = frozenset({EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT})


class LiveEntity(NamedTuple):
    """One endpoint by its full name. `seen` is the number of looks that saw it, 0 where nobody counted; `qos` what is known of its profiles."""

    kind: EntityKind
    name: str
    type: str
    seen: int = 0
    qos: tuple[Qos, ...] = ()
    ros_prefix: bool = True

    def __str__(self) -> str:
        return f"{self.kind.value} {self.name}"


@dataclass(frozen=True, slots=True)
class LiveNode:
    """All running nodes of one full name, `count` of them. `known` holds the kinds of entities of which is said what the node has;
    `hidden` says whether those are told whose name begins with `_`."""

    name: str
    entities: tuple[LiveEntity, ...] = ()
    count: int = 1
    seen: int = 0
    known: frozenset[EntityKind] = ALL_KINDS
    hidden: bool = True
    enclaves: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class LiveGraph:
    """The running system. `whole`: every running node is in it; `loose` are endpoints that belong to no node; `looks` is 0 where nobody
    counted. `source` is the file it was read from, '' where none was; `findings` tell what could not be read."""

    nodes: tuple[LiveNode, ...]
    loose: tuple[LiveEntity, ...] = ()
    looks: int = 0
    whole: bool = True
    distro: str | None = None
    source: str = ""
    findings: tuple[Finding, ...] = ()


def is_hidden(name: str) -> bool:
    """Whether ROS tools show the name only when they are asked for hidden ones."""
    return "/_" in name


def part_of_action(kind: EntityKind, name: str) -> tuple[EntityKind, str] | None:
    """The action to which a topic or service belongs by its name, and the side of it."""
    found = _PART.fullmatch(name)
    if found is None or kind not in (_ENDPOINTS if found[2] in _TOPICS else _SERVICES):
        return None
    return (EntityKind.ACTION_SERVER if kind in _OF_SERVER else EntityKind.ACTION_CLIENT), found[1]


def with_actions(entities: Iterable[LiveEntity]) -> tuple[LiveEntity, ...]:
    """The entities without the parts of actions that are among them."""
    listed = tuple(dict.fromkeys(entities))
    actions = {(e.kind, e.name) for e in listed if e.kind in (EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT)}
    return tuple(e for e in listed if part_of_action(e.kind, e.name) not in actions)
