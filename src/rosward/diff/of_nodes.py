# SPDX-License-Identifier: Apache-2.0
"""What of the nodes of a network is compared?

node /talker with its publisher of /chatter
  ->  ComparedState: node /talker, its publisher, and the right to publish rt/chatter in enclave /talker
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.diff.snapshot import ComparedState, EntityLine
from rosward.location import Place
from rosward.policies.granted import name_to_grant
from rosward.policies.match import LONGEST_NAME, is_pattern
from rosward.policies.records import EnclavePolicy, Policy, PolicyRule
from rosward.policies.rights import rights_of
from rosward.ros.entities import Entity, Node
from rosward.source.json_fields import UnreadableError

__all__ = ["snapshot_of"]

_MOST_PATTERNS: Final = 1_000
"""In one enclave, so that comparing them stays a matter of seconds."""


def snapshot_of(nodes: Iterable[Node], source: str) -> ComparedState:
    """The snapshot of a network; `source` is what messages call it. Raises UnreadableError where it cannot be compared."""
    names: set[str] = set()
    lines: set[EntityLine] = set()
    rules: dict[str, dict[tuple[str, str], PolicyRule]] = {}
    place = Place(source)
    for node in nodes:
        names.add(node.display_name)
        granted = rules.setdefault(node.enclave, {})
        for entity in node.entities:
            _check(node, entity, source)
            rule = _rule(entity, place)
            lines.add(EntityLine(node.display_name, entity.kind.value, entity.name, entity.type or ""))
            granted.setdefault((rule.words, rule.name), rule)
    for enclave, granted in rules.items():
        if sum(is_pattern(name) for _, name in granted) > _MOST_PATTERNS:
            raise UnreadableError(f"{source}: enclave {enclave} has more than {_MOST_PATTERNS:,} names with a wildcard")
    enclaves = tuple(EnclavePolicy(enclave, place, tuple(rules[enclave].values())) for enclave in sorted(rules))
    return ComparedState("network", frozenset(names), frozenset(lines), Policy(enclaves))


def _check(node: Node, entity: Entity, source: str) -> None:
    name = entity.name
    if not name.startswith("/") or "[" in name or "?" in name or len(name) > LONGEST_NAME:
        raise UnreadableError(
            f"{source}: {entity.kind.value} of {node.fqn}: {name[:LONGEST_NAME]!r} is not a full name"
        )


def _rule(entity: Entity, place: Place) -> PolicyRule:
    """The right that an entity needs, at the line that creates it first."""
    right = name_to_grant(entity)
    created = entity.created_at[0] if entity.created_at else place
    return PolicyRule(True, entity.kind.value, right, rights_of(entity.kind, right), created)
