# SPDX-License-Identifier: Apache-2.0
"""Which topics stay on the robot, and the content of which leaves it?

Content leaves where it reaches a socket, a file, another program, or a topic to which no node of the system subscribes: somebody else may.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final, final

from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.influence.search import Reached, at_least, downstream, way_to
from rosward.network.enclaves import enclave_paths
from rosward.network.holes import may_meet
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind, Node
from rosward.ros.flows import End

_LEAVING: Final = ("network", "file", "process", "device", "stdout", "log")


class Leaving(NamedTuple):
    """A topic, what its content reaches outside, by which way, and the enclave from which it leaves."""

    topic: str
    target: Vertex
    reached: Reached
    way: tuple[Edge, ...]
    enclave: str


class Kept(NamedTuple):
    """A topic whose content stays, with the enclaves of those that may publish it, and subscribe to it."""

    topic: str
    senders: tuple[str, ...]
    receivers: tuple[str, ...]


class Privacy(NamedTuple):
    """The topics that stay, those that are read by nobody known, and those whose content leaves."""

    private: tuple[Kept, ...]
    unread: tuple[str, ...]
    leaving: tuple[Leaving, ...]


def privacy(nodes: Iterable[Node], graph: FlowGraph) -> Privacy:
    """What is known of each topic of the system that some node publishes or subscribes to."""
    known = list(nodes)
    published = _topics(known, EntityKind.PUBLISHER)
    subscribed = _topics(known, EntityKind.SUBSCRIPTION)
    paths = enclave_paths(known)
    enclave_of = {node.display_name: paths[node.enclave] for node in known}
    senders, receivers = (_Users(known, kind, paths) for kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION))
    private, unread, leaving = [], [], []
    for topic in sorted(published | subscribed):
        end = End("topic", topic)
        found = downstream(graph, [Vertex(end), Vertex(end, "", "sent")], at_least("data"))
        outside = [v for v in found if v.side == "sent" and v.end.kind in _LEAVING]
        if outside:
            for vertex in sorted(outside):
                way = tuple(way_to(found, vertex))
                leaving.append(Leaving(topic, vertex, found[vertex], way, enclave_of[way[-1].node]))
        elif topic not in subscribed:
            unread.append(topic)
        else:
            private.append(Kept(topic, senders.of(topic), receivers.of(topic)))
    return Privacy(tuple(private), tuple(unread), tuple(leaving))


@final
class _Users:
    """The enclaves that use topics in one way."""

    def __init__(self, nodes: Iterable[Node], kind: EntityKind, paths: Mapping[str, str]) -> None:
        self._exact: dict[str, set[str]] = {}
        for node in nodes:
            for entity in node.of_kind(kind):
                if not entity.system:
                    self._exact.setdefault(entity.name, set()).add(paths[node.enclave])
        self._patterns = [name for name in self._exact if "*" in name]

    def of(self, topic: str) -> tuple[str, ...]:
        """Those that use a topic, by its name or by one of which a part is not known."""
        names = [topic, *(p for p in self._patterns if may_meet(p, topic))]
        return tuple(sorted({enclave for name in names for enclave in self._exact.get(name, ())}))


def _topics(nodes: Iterable[Node], kind: EntityKind) -> set[str]:
    return {e.name for node in nodes for e in node.of_kind(kind) if not e.system and "*" not in e.name}
