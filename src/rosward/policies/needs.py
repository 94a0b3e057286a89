# SPDX-License-Identifier: Apache-2.0
"""What does each enclave of a network need?

    enclave /talker: publisher /chatter of node /talker at talker.py:7, publisher /rosout, …

A name of which nothing is known needs `/*`: no less is sure to hold it. A name that ROS cannot hold needs nothing, since creating it
fails in any case.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final, NamedTuple

from rosward.network.enclaves import enclave_paths
from rosward.policies.rights import Direction, Right, rights_of
from rosward.ros.entities import Entity, EntityKind, Node, Resolution
from rosward.source.location import Place

__all__ = ["EnclaveNeeds", "Need", "needs_of"]

_NAME: Final = re.compile(r"(/[A-Za-z_*][A-Za-z0-9_*]*)+")


class Need(NamedTuple):
    """One kind of endpoint at one name, the nodes that have it and where they create it."""

    kind: EntityKind
    name: str
    rights: tuple[Right, ...]
    nodes: tuple[str, ...]
    places: tuple[Place, ...]
    conditional: bool
    known: bool = True
    """Whether a rule can name it: else the analysis says so (RW101, RW305), and no policy can be held against it."""

    def __str__(self) -> str:
        return f"{self.kind.value} {self.name}"


class EnclaveNeeds(NamedTuple):
    """An enclave by the path to write and the path as found, its nodes and their needs."""

    path: str
    found: str
    nodes: tuple[Node, ...]
    needs: tuple[Need, ...]


def needs_of(nodes: Iterable[Node]) -> tuple[EnclaveNeeds, ...]:
    """The needs of every enclave, sorted by path."""
    members: dict[str, list[Node]] = {}
    for node in nodes:
        members.setdefault(node.enclave, []).append(node)
    paths = enclave_paths(node for group in members.values() for node in group)
    return tuple(
        EnclaveNeeds(paths[found], found, tuple(members[found]), _needs(members[found]))
        for found in sorted(members, key=paths.__getitem__)
    )


def _needs(nodes: list[Node]) -> tuple[Need, ...]:
    wanted: dict[tuple[EntityKind, str, bool], list[tuple[Node, Entity]]] = {}
    for node in nodes:
        for entity in node.entities:
            if not entity.ros_prefix or _NAME.fullmatch(entity.name):
                wanted.setdefault((entity.kind, _name(entity), entity.ros_prefix), []).append((node, entity))
    return tuple(_need(*key, wanted[key]) for key in sorted(wanted, key=lambda k: (k[0].value, k[1], k[2])))


def _need(kind: EntityKind, name: str, prefixed: bool, users: list[tuple[Node, Entity]]) -> Need:
    """`prefixed`: with rt before the name on DDS, where all topics of ROS are but those that go without its conventions."""
    direction = Direction.PUBLISH if kind is EntityKind.PUBLISHER else Direction.SUBSCRIBE
    return Need(
        kind,
        name,
        rights_of(kind, name) if prefixed else (Right(direction, name),),
        tuple(sorted({node.display_name for node, _ in users})),
        tuple(sorted({place for node, e in users for place in (e.created_at or (node.defined_at,))})),
        all(e.conditional for _, e in users),
        any(e.resolution is not Resolution.UNKNOWN for _, e in users) and _NAME.fullmatch(name) is not None,
    )


def _name(entity: Entity) -> str:
    """An unknown name may also turn out to be an absolute one."""
    return "/*" if entity.resolution is Resolution.UNKNOWN and entity.name.endswith("/*") else entity.name
