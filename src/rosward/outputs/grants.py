# SPDX-License-Identifier: Apache-2.0
"""What each enclave may do: the rights of its nodes, and what is left out and why. `policy.py` and `permissions.py`
write it down.

    Node /robot1/talker: publisher /robot1/chatter, publisher of an unknown name
      ->  Enclave /robot1/talker
            Profile ns=/robot1 node=talker
              Grant(publisher, /robot1/chatter), Omission(publisher, "unknown name")

A right is granted for what some execution needs, so also for what is only conditional. A pattern is granted as it is
written: `*` in it matches any text, `/` included. No right is written for a name that ROS cannot hold, since what is
special to the matching of DDS (`[`, `?`) would then grant other names instead.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple

from rosward.network.checks import UnknownNames
from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["Enclave", "Grant", "Omission", "Profile", "enclave_named", "enclaves"]

_NAME: Final = re.compile(r"(/[A-Za-z_*][A-Za-z0-9_*]*)+")
_OUTSIDE: Final = "outside the ROS name space, which policy.xml cannot express"
_KIND_ORDER: Final = {kind: index for index, kind in enumerate(EntityKind)}


class Grant(NamedTuple):
    """A right: one kind of endpoint at one name, and the entities that need it."""

    kind: EntityKind
    name: str
    entities: tuple[Entity, ...]


class Omission(NamedTuple):
    """An entity that the policy has no rule for, and why. `dds_name`: DDS permissions can have one for that name."""

    entity: Entity
    why: str
    dds_name: bool


class Profile(NamedTuple):
    """The rights of a node by its full name; several nodes of one full name in one enclave are one profile."""

    namespace: str
    name: str
    nodes: tuple[Node, ...]
    grants: tuple[Grant, ...]
    omissions: tuple[Omission, ...]


class Enclave(NamedTuple):
    """A path and the profiles in it. `found` is the path as the analysis found it: another one where it has a hole."""

    path: str
    found: str
    profiles: tuple[Profile, ...]


def enclaves(network: Network, unknown: UnknownNames = "deny") -> tuple[Enclave, ...]:
    """Every enclave of the network, sorted by path."""
    members: dict[str, list[Node]] = {}
    for node in network.nodes:
        members.setdefault(node.enclave, []).append(node)
    paths = enclave_paths(network.nodes)
    return tuple(
        Enclave(paths[found], found, tuple(_profiles(members[found], unknown)))
        for found in sorted(members, key=paths.__getitem__)
    )


def enclave_named(network: Network, name: str, unknown: UnknownNames = "deny") -> Enclave:
    """The enclave of this path (as written or as found); ValueError if the network has none of that path."""
    for enclave in enclaves(network, unknown):
        if name in (enclave.path, enclave.found):
            return enclave
    raise ValueError(f"no enclave {name!r} in this network")


def _profiles(nodes: list[Node], unknown: UnknownNames) -> Iterator[Profile]:
    members: dict[tuple[str, str], list[Node]] = {}
    for node in nodes:
        members.setdefault((node.namespace, node.name), []).append(node)
    for namespace, name in sorted(members, key=lambda key: key[0] + key[1]):
        same = members[namespace, name]
        entities = [entity for node in same for entity in node.entities]
        yield Profile(namespace, name, tuple(same), *_rights(entities, unknown))


def _rights(entities: Iterable[Entity], unknown: UnknownNames) -> tuple[tuple[Grant, ...], tuple[Omission, ...]]:
    needed: dict[tuple[int, str], list[Entity]] = {}
    omissions = []
    for entity in entities:
        why = _why_not(entity, unknown)
        if why:
            omissions.append(Omission(entity, why, dds_name=why == _OUTSIDE))
        else:
            needed.setdefault((_KIND_ORDER[entity.kind], _name_to_grant(entity)), []).append(entity)
    grants = tuple(Grant(needed[key][0].kind, key[1], tuple(needed[key])) for key in sorted(needed))
    return grants, tuple(
        sorted(omissions, key=lambda o: (_KIND_ORDER[o.entity.kind], o.entity.name, o.entity.created_at))
    )


def _why_not(entity: Entity, unknown: UnknownNames) -> str | None:
    if entity.resolution is Resolution.UNKNOWN and unknown == "deny":
        return "name not known"
    if not _NAME.fullmatch(entity.name):
        return "not a valid name in ROS"
    return None if entity.ros_prefix else _OUTSIDE


def _name_to_grant(entity: Entity) -> str:
    """An unknown name may also turn out to be an absolute one, so that nothing less than `/*` is sure to hold it."""
    wholly_unknown = entity.resolution is Resolution.UNKNOWN and entity.name.endswith("/*")
    return "/*" if wholly_unknown else entity.name
