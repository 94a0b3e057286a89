# SPDX-License-Identifier: Apache-2.0
"""Which ends have the topics, services and actions of a network, and who is told of in a message?

    topic /scan  ->  sources: publisher in /driver; sinks: subscription in /viewer, subscription in /mapper

Ends meet where name and prefix on DDS are the same. The source of a topic is its publisher, that of a service or action its server.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, EntityKind, Node

__all__ = ["End", "Meeting", "listed_names", "meetings"]

_MOST_TOLD: Final = 3


class End(NamedTuple):
    """An entity of a node."""

    node: Node
    entity: Entity

    @property
    def place(self) -> Place:
        """Where it is created; where its node is defined if nothing nearer is known."""
        return self.entity.created_at[0] if self.entity.created_at else self.node.defined_at


class Meeting(NamedTuple):
    """A topic, service or action (`word`) and its ends."""

    word: str
    name: str
    sources: tuple[End, ...]
    sinks: tuple[End, ...]


_KINDS: Final = (
    ("topic", EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION),
    ("service", EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT),
    ("action", EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT),
)


def meetings(nodes: Iterable[Node], words: Collection[str] = ("topic", "service", "action")) -> list[Meeting]:
    """What the nodes meet in, by kind and name; `words` are the kinds that are asked for."""
    members = tuple(nodes)
    return [m for word, source, sink in _KINDS if word in words for m in _of_kind(members, word, source, sink)]


def _of_kind(nodes: Iterable[Node], word: str, source: EntityKind, sink: EntityKind) -> Iterable[Meeting]:
    found: dict[tuple[str, bool], tuple[list[End], list[End]]] = {}
    for node in nodes:
        for entity in node.entities:
            if entity.kind is source or entity.kind is sink:
                ends = found.setdefault((entity.name, entity.ros_prefix), ([], []))
                ends[entity.kind is sink].append(End(node, entity))
    for key in sorted(found):
        sources, sinks = found[key]
        yield Meeting(word, key[0], tuple(sources), tuple(sinks))


def listed_names(names: Iterable[str]) -> str:
    """`/a, /b, /c and 2 more`."""
    unique = sorted(set(names))
    more = f" and {len(unique) - _MOST_TOLD} more" if len(unique) > _MOST_TOLD else ""
    return ", ".join(unique[:_MOST_TOLD]) + more
