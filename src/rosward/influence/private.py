# SPDX-License-Identifier: Apache-2.0
"""Which topics stay on the robot, and the content of which leaves it?

Content leaves where it reaches a socket, a file, another program, or a topic to which no node of the system subscribes: somebody else may.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.influence.search import Reached, at_least, downstream, way_to
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind, Node
from rosward.ros.flows import End

_LEAVING: Final = ("network", "file", "process", "device", "stdout", "log")


class Leaving(NamedTuple):
    """A topic, what its content reaches outside, and by which way."""

    topic: str
    target: Vertex
    reached: Reached
    way: tuple[Edge, ...]


class Privacy(NamedTuple):
    """The topics that stay, those that are read by nobody known, and those whose content leaves."""

    private: tuple[str, ...]
    unread: tuple[str, ...]
    leaving: tuple[Leaving, ...]


def privacy(nodes: Iterable[Node], graph: FlowGraph) -> Privacy:
    """What is known of each topic of the system that some node publishes or subscribes to."""
    known = list(nodes)
    published = _topics(known, EntityKind.PUBLISHER)
    subscribed = _topics(known, EntityKind.SUBSCRIPTION)
    private, unread, leaving = [], [], []
    for topic in sorted(published | subscribed):
        end = End("topic", topic)
        found = downstream(graph, [Vertex(end), Vertex(end, "", "sent")], at_least("data"))
        outside = [v for v in found if v.side == "sent" and v.end.kind in _LEAVING]
        if outside:
            leaving += [Leaving(topic, v, found[v], tuple(way_to(found, v))) for v in sorted(outside)]
        elif topic not in subscribed:
            unread.append(topic)
        else:
            private.append(topic)
    return Privacy(tuple(private), tuple(unread), tuple(leaving))


def _topics(nodes: Iterable[Node], kind: EntityKind) -> set[str]:
    return {e.name for node in nodes for e in node.of_kind(kind) if not e.system and "*" not in e.name}
