# SPDX-License-Identifier: Apache-2.0
"""What each enclave may do: the rights of its nodes, and what is left out and why. `policy.py` and `permissions.py`
write it down.

    Node /robot1/talker: publisher /robot1/chatter, publisher of an unknown name
      ->  Enclave /robot1/talker
            Profile ns=/robot1 node=talker
              Grant(publisher, /robot1/chatter), Omission(publisher, "unknown name")

A right is granted for what some execution needs, so also for what is only conditional. A pattern is granted as it is
written: `*` in it matches any text, `/` included. No right is written for a name that ROS cannot hold, since what is
special to the matching of DDS (`[`, `?`) would then grant other names instead. Patterns that the user accepts in place of
names (`compact.py`) take their places in every profile that has one of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from types import MappingProxyType
from typing import Final

from rosward.enclaves.privileges import Privilege, parts
from rosward.enclaves.widened import Widened, Widenings
from rosward.network.checks import UnknownNames
from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.policies.granted import OUTSIDE, name_to_grant, why_not
from rosward.records import NamedTuple
from rosward.ros.entities import KIND_ORDER, Entity, EntityKind, Node

__all__ = ["NOT_WIDENED", "Enclave", "Grant", "Omission", "Profile", "enclave_named", "enclaves"]

NOT_WIDENED: Final[Widenings] = MappingProxyType({})
"""Each right has its own name: so it is unless the user asks otherwise."""


class Grant(NamedTuple):
    """A right: one kind of endpoint at one name, and the entities that need it. `widened`: the name is a pattern in place of several."""

    kind: EntityKind
    name: str
    entities: tuple[Entity, ...]
    widened: Widened | None = None


class Omission(NamedTuple):
    """An entity that the policy has no rule for, and why. `dds_name`: DDS permissions can have one for that name."""

    entity: Entity
    why: str
    dds_name: bool


class Profile(NamedTuple):
    """The rights of a node by its full name; several nodes of one full name in one enclave are one profile. One of unknown name is no other."""

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


def enclaves(network: Network, unknown: UnknownNames = "deny", widened: Widenings = NOT_WIDENED) -> tuple[Enclave, ...]:
    """Every enclave of the network, sorted by path."""
    members: dict[str, list[Node]] = {}
    for node in network.nodes:
        members.setdefault(node.enclave, []).append(node)
    paths = enclave_paths(network.nodes)
    return tuple(
        Enclave(paths[found], found, tuple(_profiles(members[found], unknown, widened.get(paths[found], ()))))
        for found in sorted(members, key=paths.__getitem__)
    )


def enclave_named(
    network: Network, name: str, unknown: UnknownNames = "deny", widened: Widenings = NOT_WIDENED
) -> Enclave:
    """The enclave of this path (as written or as found); ValueError if the network has none of that path."""
    for enclave in enclaves(network, unknown, widened):
        if name in (enclave.path, enclave.found):
            return enclave
    raise ValueError(f"no enclave {name!r} in this network")


def _profiles(nodes: list[Node], unknown: UnknownNames, widened: Sequence[Widened]) -> Iterator[Profile]:
    members: dict[tuple[str, str, str], list[Node]] = {}
    for node in nodes:
        members.setdefault((node.namespace, node.name, node.label or ""), []).append(node)
    for namespace, name, label in sorted(members, key=lambda key: (key[0] + key[1], key[2])):
        same = members[namespace, name, label]
        entities = [entity for node in same for entity in node.entities]
        grants, omissions = _rights(entities, unknown)
        yield Profile(namespace, name, tuple(same), tuple(_in_order(_widen(grants, widened))), omissions)


def _rights(entities: Iterable[Entity], unknown: UnknownNames) -> tuple[tuple[Grant, ...], tuple[Omission, ...]]:
    needed: dict[tuple[int, str], list[Entity]] = {}
    omissions = []
    for entity in entities:
        why = why_not(entity, unknown)
        if why:
            omissions.append(Omission(entity, why, dds_name=why == OUTSIDE))
        else:
            needed.setdefault((KIND_ORDER[entity.kind], name_to_grant(entity)), []).append(entity)
    grants = tuple(Grant(needed[key][0].kind, key[1], tuple(needed[key])) for key in sorted(needed))
    return grants, tuple(
        sorted(omissions, key=lambda o: (KIND_ORDER[o.entity.kind], o.entity.name, o.entity.created_at))
    )


def _widen(grants: Iterable[Grant], widened: Sequence[Widened]) -> list[Grant]:
    """The rights with patterns in place of the names that they stand for; of an action, the parts that none does stay."""
    if not widened:
        return list(grants)
    by_member = {(each.kind, name): each for each in reversed(widened) for name in each.members}
    kept: dict[tuple[EntityKind, str], Grant] = {}
    for grant in grants:
        single = parts(Privilege(grant.kind, grant.name))
        if not any((part.kind, part.name) in by_member for part in single):
            _add(kept, grant)
            continue
        for part in single:
            pattern = by_member.get((part.kind, part.name))
            _add(kept, Grant(part.kind, pattern.name if pattern else part.name, grant.entities, pattern))
    return list(kept.values())


def _add(kept: dict[tuple[EntityKind, str], Grant], grant: Grant) -> None:
    known = kept.get((grant.kind, grant.name))
    entities = (*known.entities, *(e for e in grant.entities if e not in known.entities)) if known else grant.entities
    kept[grant.kind, grant.name] = grant._replace(entities=entities)


def _in_order(grants: Iterable[Grant]) -> list[Grant]:
    return sorted(grants, key=lambda grant: (KIND_ORDER[grant.kind], grant.name))
