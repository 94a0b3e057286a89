# SPDX-License-Identifier: Apache-2.0
"""Does the source explain what runs, and does all run that it says?

    running /rogue, in no source                        ->  RW501
    running publisher /debug of /talker, in no source   ->  RW502, at the line where /talker is made
    expected subscription /cmd of /talker, not there    ->  RW503, at the line that creates it; apart where only some executions do

A doubt is no explanation: what only a name that is not known may explain is told (RW506), with the place that settles it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final, final

from rosward.audit.absence import Absence, place_of
from rosward.audit.accepted import Accepted
from rosward.audit.expected import Candidates, ExpectedEntities, ExpectedNodes, How, Work, fits
from rosward.audit.graph import LiveEntity, LiveGraph, LiveNode
from rosward.audit.result import Audit, AuditCounts, Difference, Tool, Unjudged
from rosward.audit.tools import tool_of
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.counts import listed
from rosward.ros.entities import Entity, Node, Qos

__all__ = ["audit"]

_POLICIES: Final = ("reliability", "durability", "history", "depth")
_LEFT_OPEN: Final = (None, "system_default", "best_available")
_NO_NODE: Final = ""
_OF_LIBRARY: Final = frozenset({"rcl_interfaces", "type_description_interfaces", "lifecycle_msgs"})
"""Packages whose types say little of what a node does, since the client library uses them."""


def audit(nodes: Iterable[Node], findings: Iterable[Finding], graph: LiveGraph, accepted: Accepted) -> Audit:
    """Compare the nodes of the source, with the findings about it, with what runs. Raises UnreadableError where that is too much work."""
    work = Work()
    comparison = _Comparison(ExpectedNodes(nodes, findings, work), graph, accepted, work)
    comparison.running()
    return comparison.result()


@final
class _Comparison:
    """Goes through what runs."""

    def __init__(self, expected: ExpectedNodes, graph: LiveGraph, accepted: Accepted, work: Work) -> None:
        self._expected = expected
        self._graph = graph
        self._accepts = accepted
        self._work = work
        self._entities: dict[tuple[int, ...], ExpectedEntities] = {}
        self._met: set[int] = set()
        self._differences: list[Difference] = []
        self._absence = Absence(expected, graph, work)
        self._tools: list[Tool] = []
        self._unjudged: list[Unjudged] = []
        self._nodes = dict.fromkeys(How, 0)
        self._found = dict.fromkeys(How, 0)
        self._running = 0
        self._accepted = 0

    def result(self) -> Audit:
        """What was found."""
        untold = 0 if self._graph.whole else sum(e.number not in self._met for e in self._expected.nodes)
        return Audit(
            source=self._graph.source,
            looks=self._graph.looks,
            differences=tuple(sorted(dict.fromkeys((*self._differences, *self._absence.differences)), key=_order)),
            unseen=tuple(sorted(self._absence.unseen)),
            tools=tuple(self._tools),
            unjudged=tuple(self._unjudged),
            findings=self._graph.findings,
            nodes=AuditCounts(len(self._graph.nodes), self._nodes[How.NAME], self._nodes[How.PATTERN]),
            entities=AuditCounts(self._running, self._found[How.NAME], self._found[How.PATTERN]),
            accepted=self._accepted,
            untold=untold,
        )

    def running(self) -> None:
        """Go through what runs, then through what does not."""
        for node in self._graph.nodes:
            candidates = self._expected.candidates(node.name)
            if candidates is not None and candidates.how is not How.UNKNOWN:
                self._explained(node, candidates)
            elif self._accepts.node(node.name):
                self._accepted += 1
            elif (tool := tool_of(node.name)) is not None:
                self._tools.append(Tool(node.name, tool, len(node.entities)))
            elif candidates is not None:
                self._explained(node, candidates)
            else:
                has = f"; it has {_listed(node.entities)}" if node.entities else ""
                message = f"node {node.name} runs but is not explained by the source{has}"
                self._tell(node.name, "", "RW501", message, Place(self._graph.source), node.seen)
        for entity in self._graph.loose:
            if self._accepts.entity(_NO_NODE, entity.name):
                self._accepted += 1
            else:
                message = f"{_typed(entity)} belongs to no ROS node, so the source does not explain it"
                self._tell(_NO_NODE, str(entity), "RW502", message, Place(self._graph.source), entity.seen)

        self._absence.of_nodes(self._met)

    def _explained(self, node: LiveNode, candidates: Candidates) -> None:
        self._nodes[candidates.how] += 1
        self._met.update(e.number for e in candidates.nodes)
        first = candidates.nodes[0].node
        number = len(candidates.nodes)
        if candidates.how is How.UNKNOWN:
            message = f"node {node.name} is explained only by a node with an unknown name{_why(first.reasons)}"
            self._tell(node.name, "", "RW506", message, first.defined_at, node.seen)
        elif candidates.how is How.NAME and node.count > number and not self._accepts.node(node.name):
            message = f"{node.count} nodes named {node.name} run, but the source explains only {number}"
            self._tell(node.name, "", "RW501", message, first.defined_at, node.seen)
        unjudged: list[str] = []
        for entity in node.entities:
            self._running += 1
            if not self._entity(node, entity, candidates):
                unjudged.append(str(entity))
        if unjudged:
            self._unjudged.append(Unjudged(node.name, tuple(unjudged), first.launched_by or first.defined_at))
        if candidates.how is not How.UNKNOWN:
            self._absence.of_node(node, candidates)

    def _of(self, candidates: Candidates) -> ExpectedEntities:
        key = tuple(e.number for e in candidates.nodes)
        if key not in self._entities:
            self._entities[key] = ExpectedEntities(candidates.nodes, self._work)
        return self._entities[key]

    def _entity(self, node: LiveNode, live: LiveEntity, candidates: Candidates) -> bool:
        """Judge one entity; False where only the name of its node explains it."""
        expected = self._of(candidates)
        named = expected.named(live)
        if any(fits(entity, live) for entity in named):
            self._found[How.NAME] += 1
            self._qos(node, live, [e for e in named if fits(e, live)])
        elif expected.through(live, How.PATTERN):
            self._found[How.PATTERN] += 1
        elif self._accepts.entity(node.name, live.name):
            self._accepted += 1
        elif named:
            types = " or ".join(sorted({str(e.type) for e in named}))
            message = f"{live} of {node.name} has type {live.type}, but the source says {types}"
            self._tell(node.name, str(live), "RW504", message, place_of(named[0], candidates.nodes[0].node), live.seen)
        elif candidates.open:
            return False
        elif unknown := expected.through(live, How.UNKNOWN):
            message = f"{_typed(live)} of {node.name} is explained only by an unknown name{_why(unknown[0].reasons)}"
            self._tell(
                node.name, str(live), "RW506", message, place_of(unknown[0], candidates.nodes[0].node), live.seen
            )
        else:
            message = f"{_typed(live)} of {node.name} is not explained by the source"
            self._tell(node.name, str(live), "RW502", message, candidates.nodes[0].node.defined_at, live.seen)
        return True

    def _qos(self, node: LiveNode, live: LiveEntity, entities: Sequence[Entity]) -> None:
        """A profile that none of the expected ones is, as far as both are known."""
        for profile in live.qos:
            differing = [_differs(profile, entity.qos) for entity in entities]
            if differing and all(differing):
                message = f"{live} of {node.name} has {differing[0]}"
                self._tell(node.name, str(live), "RW504", message, place_of(entities[0], None), live.seen)
                return

    def _tell(self, node: str, entity: str, code: str, message: str, place: Place, seen: int) -> None:
        self._differences.append(Difference(node, entity, Finding(code, message, place), seen))


def _order(one: Difference) -> tuple[str, str, str, str]:
    return one.node, one.finding.code, one.entity, one.finding.message


def _differs(live: Qos, expected: Qos | None) -> str:
    """The first policy in which the profiles differ, in words; '' where they may be the same."""
    for policy in _POLICIES:
        runs, said = getattr(live, policy), getattr(expected, policy, None)
        if runs not in _LEFT_OPEN and said not in _LEFT_OPEN and runs != said:
            return f"{policy} {runs}, but the source says {said}"
    return ""


def _typed(entity: LiveEntity) -> str:
    return f"{entity} ({entity.type})" if entity.type else str(entity)


def _listed(entities: Sequence[LiveEntity]) -> str:
    own_first = sorted(entities, key=lambda e: e.type.partition("/")[0] in _OF_LIBRARY)
    return listed([str(e) for e in own_first], 3)


def _why(reasons: Sequence[str]) -> str:
    return f": {reasons[0]}" if reasons else ""
