# SPDX-License-Identifier: Apache-2.0
"""What does each enclave of a network need?

    enclave /talker: publisher /chatter of node /talker at talker.py:7, publisher /rosout, …

A name of which nothing is known needs `/*`: no less is sure to hold it. A name that ROS cannot hold needs nothing, since creating it
fails in any case.
"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.location import Place
from rosward.network.enclaves import enclave_paths
from rosward.policies.granted import is_name_of_ros, name_to_grant
from rosward.policies.rights import Right, rights_of
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["EnclaveNeeds", "Need", "needs_of"]


class Need(NamedTuple):
    """One kind of endpoint at one name, the nodes that have it and where they create it."""

    kind: EntityKind
    name: str
    rights: tuple[Right, ...]
    nodes: tuple[str, ...]
    places: tuple[Place, ...]
    conditional: bool
    known: bool = True
    """Whether a rule can name it: else the analysis says so (RW101, RW305), and no policy can be checked against it."""

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
            if not entity.ros_prefix or is_name_of_ros(entity.name):
                wanted.setdefault((entity.kind, name_to_grant(entity), entity.ros_prefix), []).append((node, entity))
    return tuple(_need(*key, wanted[key]) for key in sorted(wanted, key=lambda k: (k[0].value, k[1], k[2])))


def _need(kind: EntityKind, name: str, prefixed: bool, users: list[tuple[Node, Entity]]) -> Need:
    """`prefixed`: with rt before the name on DDS, where all topics of ROS are but those that go without its conventions."""
    return Need(
        kind,
        name,
        rights_of(kind, name, ros=prefixed),
        tuple(sorted({node.display_name for node, _ in users})),
        tuple(sorted({place for node, e in users for place in (e.created_at or (node.defined_at,))})),
        all(e.conditional for _, e in users),
        any(e.resolution is not Resolution.UNKNOWN for _, e in users) and is_name_of_ros(name),
    )
