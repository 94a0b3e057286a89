# SPDX-License-Identifier: Apache-2.0
"""Which expected nodes, and which of their entities, may a running one be?

    expected /robot_*/driver, running /robot_1/driver  ->  candidate, by its pattern

A name that is known explains before a pattern does, and a pattern before a name of which nothing is known.
"""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from typing import Final, final

from rosward.audit.graph import LiveEntity, part_of_action
from rosward.findings import Finding
from rosward.policies.granted import name_to_grant
from rosward.policies.match import Pattern
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, EntityKind, Node, Resolution
from rosward.source.json_fields import UnreadableError

__all__ = ["Candidates", "ExpectedEntities", "ExpectedNode", "ExpectedNodes", "How", "Work"]

_MOST_WORK: Final = 10_000_000


class How(enum.Enum):
    """By what something is explained."""

    NAME = "name"
    PATTERN = "pattern"
    UNKNOWN = "unknown name"


@final
class Work:
    """Bounds how long hostile input can keep a comparison busy. Raises UnreadableError where it is too long."""

    def __init__(self) -> None:
        self._left = _MOST_WORK

    def spend(self, steps: int) -> None:
        """Count steps of the comparison."""
        self._left -= steps
        if self._left < 0:
            raise UnreadableError("too many names and patterns to compare")

    def matches(self, pattern: Pattern, name: str) -> bool:
        """Whether a name is one that the pattern stands for."""
        self.spend(len(name) if name.startswith(pattern.prefix) else 1)
        return pattern.matches(name)


class ExpectedNode(NamedTuple):
    """A node of the source, and which one it is; `open`: its interface is not completely known (RW314)."""

    number: int
    node: Node
    open: bool


class Candidates(NamedTuple):
    """The expected nodes that a running one may be, and why."""

    how: How
    nodes: tuple[ExpectedNode, ...]

    @property
    def open(self) -> bool:
        """Whether it may have what nobody knows."""
        return any(expected.open for expected in self.nodes)


@final
class ExpectedNodes:
    """The nodes of the source, ready to be asked for."""

    def __init__(self, nodes: Iterable[Node], findings: Iterable[Finding], work: Work) -> None:
        open_at = {(f.place.file, f.place.line) for f in findings if f.code == "RW314"}
        self.nodes = tuple(
            ExpectedNode(number, n, (n.defined_at.file, n.defined_at.line) in open_at) for number, n in enumerate(nodes)
        )
        self._work = work
        self._exact: dict[str, list[ExpectedNode]] = {}
        self._wild: dict[How, list[tuple[Pattern, ExpectedNode]]] = {How.PATTERN: [], How.UNKNOWN: []}
        for expected in self.nodes:
            fqn = expected.node.fqn
            if "*" in fqn:
                how = How.UNKNOWN if expected.node.resolution is Resolution.UNKNOWN else How.PATTERN
                self._wild[how].append((Pattern(fqn), expected))
            else:
                self._exact.setdefault(fqn, []).append(expected)

    def candidates(self, name: str) -> Candidates | None:
        """The nodes that a running node of this name may be."""
        if name in self._exact:
            return Candidates(How.NAME, tuple(self._exact[name]))
        for how, rows in self._wild.items():
            found = tuple(expected for pattern, expected in rows if self._work.matches(pattern, name))
            if found:
                return Candidates(how, found)
        return None


@final
class ExpectedEntities:
    """What some nodes have together, ready to be asked for."""

    def __init__(self, nodes: Sequence[ExpectedNode], work: Work) -> None:
        self._work = work
        self._exact: dict[tuple[EntityKind, str], list[Entity]] = {}
        self._wild: dict[tuple[EntityKind, How], list[tuple[Pattern, Entity]]] = {}
        for expected in nodes:
            work.spend(len(expected.node.entities))
            for entity in expected.node.entities:
                if "*" in entity.name:
                    key = entity.kind, How.UNKNOWN if entity.resolution is Resolution.UNKNOWN else How.PATTERN
                    self._wild.setdefault(key, []).append((Pattern(name_to_grant(entity)), entity))
                else:
                    self._exact.setdefault((entity.kind, entity.name), []).append(entity)

    def named(self, live: LiveEntity) -> list[Entity]:
        """The expected entities of just this kind and name, whatever their type; also the action of which it is a part."""
        found = self._exact.get((live.kind, live.name), [])
        action = part_of_action(live.kind, live.name)
        return found or (self._exact.get(action, []) if action is not None else [])

    def through(self, live: LiveEntity, how: How) -> list[Entity]:
        """The expected entities that may have this name."""
        rows = self._wild.get((live.kind, how), [])
        action = part_of_action(live.kind, live.name)
        found = [e for pattern, e in rows if fits(e, live) and self._work.matches(pattern, live.name)]
        if action is not None:
            parts = self._wild.get((action[0], how), [])
            found += [e for pattern, e in parts if self._work.matches(pattern, action[1])]
        return found


def fits(entity: Entity, live: LiveEntity) -> bool:
    """Whether the type is the expected one, as far as both are known."""
    return entity.type is None or not live.type or entity.type == live.type or entity.kind is not live.kind
