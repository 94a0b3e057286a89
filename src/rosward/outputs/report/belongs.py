# SPDX-License-Identifier: Apache-2.0
"""Which nodes, endpoints and entities does a finding speak of?

    RW101 at talker.py:12   the name of this publisher is not known   ->  the entities created there whose name is not known
    RW306 at viewer.py:40   topic /scan: A (publisher in /driver); …  ->  the topic /scan and all of its ends

A finding about a line belongs to what is created, defined or started there, by the nodes that it is about, where it says so; where its message
names some of these, to those alone. A finding
about the whole belongs to what its message names: nodes, endpoints, or the nodes of an enclave. With an entity it belongs to the node and the
endpoint of it, too. A finding about a line at which nothing is made belongs to nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Final, TypeVar, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.enclaves import enclave_paths
from rosward.outputs.report.numbered import Member, Numbered, NumberedEnd, NumberedEndpoint
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["Belongings"]

_T = TypeVar("_T")

_MENTION: Final = re.compile(
    r"(?:\b(topic|publisher|subscription|(?:service|action)(?: server| client)?) )?(/[^\s,;:()]*)"
)
_TOPIC_WORDS: Final = ("publisher", "subscription")
_OF_NODES: Final = frozenset({"RW301", "RW307"})
_OF_ENCLAVES: Final = frozenset({"RW303", "RW304", "RW340"})
_OF_NODE_AND_NAME: Final = frozenset({"RW302", "RW305"})
_OF_ENDPOINTS: Final = frozenset({"RW306", "RW309", "RW331", "RW332", "RW333", "RW334"})
_OF_FLOWS: Final = frozenset({"RW601", "RW604", "RW605", "RW606"})

_FITTING_ENTITIES: Final[dict[str, Callable[[Entity], bool]]] = {
    "RW101": lambda entity: entity.resolution is Resolution.UNKNOWN,
    "RW102": lambda entity: entity.resolution is Resolution.PATTERN,
    "RW108": lambda entity: entity.resolution is Resolution.UNKNOWN,
    "RW104": lambda entity: entity.type is None,
    "RW105": lambda _: False,
}
_FITTING_NODES: Final[dict[str, Callable[[Node], bool]]] = {
    "RW101": lambda _: False,
    "RW102": lambda node: node.resolution is Resolution.PATTERN,
    "RW104": lambda _: False,
    "RW105": lambda node: node.resolution is Resolution.UNKNOWN,
    "RW108": lambda _: False,
}
"""What a finding of a code can be about, where several things are made in one line."""


class _Mention(NamedTuple):
    """A full name in a message, and what the word before it calls it: topic, service, action, or '' for anything."""

    word: str
    name: str


@final
class Belongings:
    """What is made where and is called how, ready to be asked for each finding."""

    def __init__(self, numbers: Numbered) -> None:
        self._ends_at: dict[tuple[str, int], dict[str, list[NumberedEnd]]] = {}
        self._members_at: dict[tuple[str, int], dict[str, list[Member]]] = {}
        self._members_called: dict[str, list[Member]] = {}
        self._members_in: dict[str, list[Member]] = {}
        paths = enclave_paths(member.node for member in numbers.members)
        self._endpoints = {(endpoint.word, endpoint.name): endpoint for endpoint in numbers.endpoints}
        for member in numbers.members:
            self._members_called.setdefault(member.node.fqn, []).append(member)
            self._members_in.setdefault(paths[member.node.enclave], []).append(member)
            for place in dict.fromkeys(_line(p) for p in _places_of(member.node)):
                self._members_at.setdefault(place, {}).setdefault(member.node.fqn, []).append(member)
            for end in member.ends:
                if not end.entity.system:
                    for place in dict.fromkeys(map(_line, end.entity.created_at)):
                        self._ends_at.setdefault(place, {}).setdefault(end.entity.name, []).append(end)

    def of(self, finding: Finding) -> list[str]:
        """The ids of what a finding speaks of: nodes, then endpoints, then entities."""
        mentions = [_Mention(_word(kind), name) for kind, name in _MENTION.findall(finding.message)]
        if finding.code in _OF_NODES:
            return _ids((), (m for mention in mentions for m in self._members_called.get(mention.name, ())), ())
        if finding.code in _OF_ENCLAVES:
            return _ids((), self._members_in.get(mentions[0].name, ()) if mentions else (), ())
        if finding.code in _OF_FLOWS:
            return _ids((), (m for name in finding.nodes for m in self._members_called.get(name, ())), ())
        if finding.code in _OF_ENDPOINTS:
            return self._of_endpoints(finding, mentions)
        if finding.code in _OF_NODE_AND_NAME:
            return self._of_node_and_name(mentions)
        return self._of_line(finding, {mention.name for mention in mentions})

    def _of_endpoints(self, finding: Finding, mentions: list[_Mention]) -> list[str]:
        """The first name is that of the endpoint."""
        endpoint = self._endpoints.get(mentions[0]) if mentions else None
        if endpoint is None:
            return []
        ends = [end for end in endpoint.ends if not end.entity.system]
        if finding.code == "RW309":
            ends = [end for end in ends if _has_quality_of(end.entity, finding.message)]
        return _ids(ends, (), [endpoint])

    def _of_node_and_name(self, mentions: list[_Mention]) -> list[str]:
        """The first name is that of the node, the second, if any, that of an endpoint of it."""
        members = self._members_called.get(mentions[0].name, []) if mentions else []
        if len(mentions) < 2:
            return _ids((), members, ())
        name = mentions[1]
        ends = (end for member in members for end in member.ends if not end.entity.system)
        return _ids([end for end in ends if end.entity.name == name.name], (), ())

    def _of_line(self, finding: Finding, mentioned: set[str]) -> list[str]:
        line = _line(finding.place)
        if line[1] == 0:
            return []
        fits, suits = _FITTING_ENTITIES.get(finding.code, _any), _FITTING_NODES.get(finding.code, _any)
        ends, members = self._ends_at.get(line, {}), self._members_at.get(line, {})
        if finding.nodes:
            ends = {name: [end for end in found if end.node.fqn in finding.nodes] for name, found in ends.items()}
            members = {name: found for name, found in members.items() if name in finding.nodes}
        for names in (mentioned, None):  # those that are named, else all
            found = (
                [end for end in _called(ends, names) if fits(end.entity)],
                [member for member in _called(members, names) if suits(member.node)],
            )
            if any(found):
                return _ids(*_in_column(finding.place, *found), ())
        return []


def _called(things: Mapping[str, list[_T]], names: Collection[str] | None) -> list[_T]:
    """What is called so; all where there are no names."""
    return [thing for name in (things if names is None else names) for thing in things.get(name, ())]


def _in_column(place: Place, ends: list[NumberedEnd], members: list[Member]) -> tuple[list[NumberedEnd], list[Member]]:
    """What is made in the very column of a place; all where nothing is."""
    exact = (
        [end for end in ends if place in end.entity.created_at],
        [member for member in members if place in _places_of(member.node)],
    )
    return exact if any(exact) else (ends, members)


def _line(place: Place) -> tuple[str, int]:
    return place.file, place.line


def _places_of(node: Node) -> tuple[Place, ...]:
    return (node.defined_at,) if node.launched_by is None else (node.defined_at, node.launched_by)


def _word(kind: str) -> str:
    return "topic" if kind in _TOPIC_WORDS else kind.partition(" ")[0]


def _any(_: object) -> bool:
    return True


def _has_quality_of(entity: Entity, message: str) -> bool:
    """Whether the QoS of an end is one of the two that a message of RW309 says do not fit."""
    offers = entity.kind is EntityKind.PUBLISHER
    qos = entity.qos
    if qos is None:
        return False
    if " offers best_effort" in message:
        return qos.reliability == ("best_effort" if offers else "reliable")
    return qos.durability == ("volatile" if offers else "transient_local")


def _ids(ends: Iterable[NumberedEnd], members: Iterable[Member], endpoints: Iterable[NumberedEndpoint]) -> list[str]:
    chosen = list(ends)
    nodes = {member.id for member in members} | {end.node_id for end in chosen}
    topics = {endpoint.id for endpoint in endpoints} | {end.endpoint_id for end in chosen}
    return [*_sorted(nodes), *_sorted(topics), *_sorted({end.id for end in chosen})]


def _sorted(ids: Iterable[str]) -> list[str]:
    return sorted(ids, key=lambda text: int(text[1:]))
