# SPDX-License-Identifier: Apache-2.0
"""What an entity sends and what arrives at it, as sinks and sources of information."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.location import Place
from rosward.ros.entities import EntityKind, Node
from rosward.ros.flows import End, NodeSink

SENT: Final = {
    EntityKind.PUBLISHER: ("topic",),
    EntityKind.SERVICE_CLIENT: ("request",),
    EntityKind.SERVICE_SERVER: ("response",),
    EntityKind.ACTION_CLIENT: ("goal", "cancel"),
    EntityKind.ACTION_SERVER: ("feedback", "result"),
}
"""The sinks that an entity is."""
ARRIVING: Final = {
    EntityKind.SUBSCRIPTION: ("topic",),
    EntityKind.SERVICE_CLIENT: ("response",),
    EntityKind.SERVICE_SERVER: ("service",),
    EntityKind.ACTION_CLIENT: ("feedback", "result"),
    EntityKind.ACTION_SERVER: ("goal", "cancel"),
}
"""The sources that an entity is."""


def all_to_all(node: Node, of: Iterable[Node]) -> Iterator[NodeSink]:
    """Each output of a node made of each input of these, where nobody knows better."""
    sources = tuple(sorted(inputs(of)))
    for entity in node.entities:
        if not entity.system:
            for kind in SENT.get(entity.kind, ()):
                yield NodeSink(
                    End(kind, entity.name), _place_of(entity.created_at, node), data=sources, assumed=sources
                )


def inputs(nodes: Iterable[Node]) -> Iterator[End]:
    """What may come into nodes."""
    for node in nodes:
        for entity in node.entities:
            if not entity.system:
                yield from (End(kind, entity.name) for kind in ARRIVING.get(entity.kind, ()))
        yield from (End("parameter", parameter.name) for parameter in node.parameters)


def _place_of(places: tuple[Place, ...], node: Node) -> Place:
    return places[0] if places else node.defined_at
