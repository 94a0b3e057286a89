# SPDX-License-Identifier: Apache-2.0
"""By which short name does one part of the report speak of another?

    node /a/talker with a publisher /a/chatter   ->   n0, its end e0, and the topic t0 that e0 is an end of

Numbers follow the order of the network, so the same sources give the same ones. Everything that is looked up later is in a dictionary here.
"""

from __future__ import annotations

from typing import Final

from rosward.network.graph import Network
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Node

__all__ = ["Member", "Numbered", "NumberedEnd", "NumberedEndpoint", "numbered"]

_WORDS: Final = ("topic", "service", "action")


class Member(NamedTuple):
    """A node and its entities."""

    id: str
    node: Node
    ends: tuple[NumberedEnd, ...]


class NumberedEnd(NamedTuple):
    """An entity, with the ids of its node and of the topic, service or action that it is an end of."""

    id: str
    node_id: str
    endpoint_id: str
    node: Node
    entity: Entity


class NumberedEndpoint(NamedTuple):
    """A topic, service or action, and its ends."""

    id: str
    word: str
    name: str
    ends: tuple[NumberedEnd, ...]


class Numbered(NamedTuple):
    """All of a network under its ids. `entity_ids` is by the identity of the record: equal entities of two nodes are two."""

    members: tuple[Member, ...]
    endpoints: tuple[NumberedEndpoint, ...]
    entity_ids: dict[int, str]


def numbered(network: Network) -> Numbered:
    """Give everything its id."""
    rank = {word: number for number, word in enumerate(_WORDS)}
    names = {(rank[e.kind.meeting], e.name) for node in network.nodes for e in node.entities}
    ids = {(_WORDS[word], name): f"t{number}" for number, (word, name) in enumerate(sorted(names))}
    ends_of: dict[tuple[str, str], list[NumberedEnd]] = {key: [] for key in ids}
    members: list[Member] = []
    entity_ids: dict[int, str] = {}
    counted = 0
    for number, node in enumerate(network.nodes):
        own: list[NumberedEnd] = []
        for entity in node.entities:
            key = (entity.kind.meeting, entity.name)
            end = NumberedEnd(f"e{counted}", f"n{number}", ids[key], node, entity)
            entity_ids[id(entity)] = end.id
            ends_of[key].append(end)
            own.append(end)
            counted += 1
        members.append(Member(f"n{number}", node, tuple(own)))
    endpoints = tuple(NumberedEndpoint(ids[key], *key, tuple(ends)) for key, ends in ends_of.items())
    return Numbered(tuple(members), endpoints, entity_ids)
