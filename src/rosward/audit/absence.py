# SPDX-License-Identifier: Apache-2.0
"""What is expected, and does not run?

    expected subscription /cmd of /talker, which runs without it   ->  RW503, at the line that creates it
    expected publisher /late, created in a callback                ->  unseen: only some executions have it

Of what is not known, nothing is missed: kinds of which a text says nothing, hidden names where none is shown, nodes where not all are told.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import final

from rosward.audit.expected import Candidates, ExpectedNode, ExpectedNodes, Work
from rosward.audit.graph import LiveGraph, LiveNode, is_hidden, part_of_action
from rosward.audit.result import Difference, Unseen
from rosward.findings import Finding
from rosward.location import Place
from rosward.policies.match import Pattern
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["Absence", "place_of"]


@final
class Absence:
    """Collects what is absent, and what was not seen and need not be there."""

    def __init__(self, expected: ExpectedNodes, graph: LiveGraph, work: Work) -> None:
        self._expected = expected
        self._graph = graph
        self._work = work
        self.differences: list[Difference] = []
        self.unseen: dict[Unseen, None] = {}

    def of_node(self, node: LiveNode, candidates: Candidates) -> None:
        """What a node that runs is expected to have, and does not."""
        names: dict[EntityKind, list[str]] = {}
        for live in node.entities:
            names.setdefault(live.kind, []).append(live.name)
        there = {(live.kind, live.name) for live in node.entities}
        for expected in candidates.nodes:
            self._work.spend(len(expected.node.entities))
            for entity in expected.node.entities:
                if entity.kind not in node.known or (entity.system and expected.open):
                    continue
                if not node.hidden and (is_hidden(entity.name) or not entity.ros_prefix):
                    continue
                whole = part_of_action(entity.kind, entity.name)
                if (entity.kind, entity.name) in there or whole in there:
                    continue
                if not self._matched(entity, names.get(entity.kind, ())):
                    self._missing(node, entity, expected, candidates)

    def _matched(self, entity: Entity, names: Sequence[str]) -> bool:
        if "*" not in entity.name:
            return False
        pattern = Pattern(entity.name)
        return any(self._work.matches(pattern, name) for name in names)

    def _missing(self, node: LiveNode, entity: Entity, expected: ExpectedNode, candidates: Candidates) -> None:
        place = place_of(entity, expected.node)
        what = f"{entity.kind.value} {entity.name}"
        self._work.spend(sum(len(e.node.entities) for e in candidates.nodes))
        if entity.conditional or entity.resolution is Resolution.UNKNOWN or not _in_all(entity, candidates.nodes):
            self.unseen[Unseen(node.name, what, place)] = None
            return
        typed = f"{what} ({entity.type})" if entity.type else what
        message = f"{typed} of {node.name} is expected but was not found{_depends(entity.depends_on)}"
        if node.seen < self._graph.looks:
            message += f"; the node was seen in {node.seen} of {self._graph.looks} looks"
        self._tell(node.name, what, message, place)

    def of_nodes(self, met: Collection[int]) -> None:
        """Which expected nodes do not run; `met` are the numbers of those that do."""
        if not self._graph.whole:
            return
        counts = {node.name: node.count for node in self._graph.nodes}
        names: dict[str, list[Node]] = {}
        for expected in self._expected.nodes:
            names.setdefault(expected.node.fqn, []).append(expected.node)
            if expected.number not in met:
                self._node_missing(expected.node)
        for name, nodes in names.items():
            sure = [n for n in nodes if not n.conditional]
            if 0 < counts.get(name, 0) < len(sure):
                message = f"{len(sure)} nodes named {name} are expected, but {counts[name]} run"
                self._tell(name, "", message, _origin(sure[-1]))

    def _node_missing(self, node: Node) -> None:
        if node.conditional or node.resolution is Resolution.UNKNOWN:
            self.unseen[Unseen(node.fqn, "", _origin(node))] = None
        else:
            self._tell(node.fqn, "", f"node {node.fqn} is expected but does not run", _origin(node))

    def _tell(self, node: str, entity: str, message: str, place: Place) -> None:
        self.differences.append(Difference(node, entity, Finding("RW503", message, place)))


def place_of(entity: Entity, node: Node | None) -> Place:
    """Where an entity is created, else where its node is."""
    return entity.created_at[0] if entity.created_at else node.defined_at if node is not None else Place("")


def _origin(node: Node) -> Place:
    return node.launched_by or node.defined_at


def _in_all(entity: Entity, nodes: Sequence[ExpectedNode]) -> bool:
    """Whether every node of the name has it: which of them runs is not known."""
    if len(nodes) == 1:
        return True
    return all(
        any(e.kind is entity.kind and e.name == entity.name and not e.conditional for e in expected.node.entities)
        for expected in nodes
    )


def _depends(names: Sequence[str]) -> str:
    return f" (its name depends on {', '.join(names)})" if names else ""
