# SPDX-License-Identifier: Apache-2.0
"""Everything that `rosward explain` tells of a name, as plain records; `explain.py` writes them down.

/porter/battery  ->  Answer(meetings=(MeetingTold("topic", "/porter/battery", ends=(EndTold("publisher", …), …)),), …)
"""

from __future__ import annotations

from pathlib import Path
from typing import Final, final

from rosward.explanation.content import Contents, ContentTold
from rosward.explanation.excerpts import Excerpt, Excerpts
from rosward.explanation.provenance import (
    EntityRules,
    NameSource,
    PolicyLine,
    Start,
    Starts,
    remap_rules,
    remedies,
    sources,
)
from rosward.explanation.subjects import MeetingPoint, Subjects, close_matches, is_at, subjects
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.checks import UnknownNames
from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.network.launch_tree import LaunchSystem
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Interface, Node, Qos, Resolution
from rosward.rules import RULES, Severity

__all__ = [
    "Answer",
    "DoubtTold",
    "EnclaveTold",
    "EndTold",
    "MeetingTold",
    "NodeTold",
    "RuleTold",
    "explained",
    "rule_alone",
]

_MOST: Final = 200
"""Subjects of one kind that are told of."""


_MEANINGS: Final = {
    Severity.ERROR: "something is, or may be, missing from the result; the exit status is 1",
    Severity.WARNING: "the result is complete, but it may include too much, or the system may not work as intended",
    Severity.NOTE: "informational; shown by extract -v",
}


class EndTold(NamedTuple):
    """One entity of one node: what it is, and the chain that leads to it."""

    kind: str
    name: str
    type: str | None
    node: str
    node_at: Place
    system: bool
    conditional: bool
    resolution: str
    qos: str
    callback: str | None
    via: str | None
    created: tuple[Excerpt, ...]
    calls: tuple[Place, ...]
    start: Start
    made_of: tuple[NameSource, ...]
    remaps: tuple[str, ...]
    missing: tuple[str, ...]
    remedies: tuple[str, ...]
    policy: PolicyLine | None


class MeetingTold(NamedTuple):
    """A topic, service or action; `content`: what it is made of, where that is asked for."""

    word: str
    name: str
    types: tuple[str, ...]
    ends: tuple[EndTold, ...]
    content: tuple[ContentTold, ...] | None = None


class ParameterTold(NamedTuple):
    """A parameter of a node."""

    name: str
    type: str | None
    default: object
    value: object
    declared_at: Place | None


class DoubtTold(NamedTuple):
    """A finding with its source."""

    code: str
    severity: str
    title: str
    message: str
    help: str
    excerpt: Excerpt


class RuleTold(NamedTuple):
    """A kind of finding; `searched`: whether sources were looked through for it."""

    code: str
    title: str
    severity: str
    meaning: str
    help: str
    searched: bool


class NodeTold(NamedTuple):
    """A node with all that it has."""

    name: str
    resolution: str
    created: Excerpt
    start: Start
    enclave: str
    ends: tuple[EndTold, ...]
    parameters: tuple[ParameterTold, ...]
    missing: tuple[str, ...]
    remedies: tuple[str, ...]
    doubts: tuple[DoubtTold, ...]
    interface: str = Interface.ANALYSED.value
    lacks: tuple[str, ...] = ()


class EnclaveTold(NamedTuple):
    """An enclave, who runs in it, and its rules."""

    path: str
    nodes: tuple[str, ...]
    rules: tuple[PolicyLine, ...]


class Answer(NamedTuple):
    """What a name means; where it means nothing, the names that come close."""

    query: str
    meetings: tuple[MeetingTold, ...] = ()
    nodes: tuple[NodeTold, ...] = ()
    enclaves: tuple[EnclaveTold, ...] = ()
    ends: tuple[EndTold, ...] = ()
    through: tuple[EndTold, ...] = ()
    doubts: tuple[DoubtTold, ...] = ()
    close: tuple[str, ...] = ()
    rule: RuleTold | None = None

    @property
    def empty(self) -> bool:
        """Whether the name means nothing here."""
        found = (self.meetings, self.nodes, self.enclaves, self.ends, self.through, self.doubts)
        return self.rule is None and not any(found)


def explained(
    network: Network,
    query: str,
    root: Path,
    systems: tuple[LaunchSystem, ...] = (),
    unknown: UnknownNames = "deny",
    contents: Contents | None = None,
) -> Answer:
    """What `query` means in a network whose places are relative to `root`; `systems` are the launched systems, if any.

    With the `contents` of the network, also what topics, services and actions are made of.
    """
    meant = subjects(network, query)
    rights, starts = EntityRules(network, unknown), Starts(systems)
    answer = _Teller(network, Excerpts(root), rights, starts, contents).answer(query, meant)
    return answer._replace(close=close_matches(network, query)) if answer.empty else answer


def rule_alone(query: str) -> Answer | None:
    """What a code means, without any sources; None where it is none."""
    code = query.upper()
    return Answer(query, rule=_rule(code, searched=False)) if code in RULES else None


def _rule(code: str, *, searched: bool) -> RuleTold:
    rule = RULES[code]
    return RuleTold(code, rule.title, rule.severity.value, _MEANINGS[rule.severity], rule.help, searched)


@final
class _Teller:
    """Turns the records of a network into those of an answer."""

    def __init__(
        self, network: Network, excerpts: Excerpts, rights: EntityRules, starts: Starts, contents: Contents | None
    ) -> None:
        self._network = network
        self._excerpts = excerpts
        self._rights = rights
        self._starts = starts
        self._contents = contents

    def answer(self, query: str, meant: Subjects) -> Answer:
        if meant.code is not None:
            doubts = self._doubts([f for f in self._network.findings if f.code == meant.code])
            return Answer(query, doubts=doubts, rule=_rule(meant.code, searched=True))
        if meant.place is not None:
            return self._place(query, meant.place)
        return Answer(
            query,
            meetings=tuple(self._meeting(m) for m in meant.meetings[:_MOST]),
            nodes=tuple(self._node(n) for n in meant.nodes[:_MOST]),
            enclaves=tuple(self._enclave(path) for path in meant.enclaves[:_MOST]),
        )

    def _place(self, query: str, place: tuple[str, int]) -> Answer:
        """What is created in a line, what is created through a call in it, and what is doubted there."""

        def here(at: Place | None) -> bool:
            return at is not None and is_at(at.file, at.line, place)

        own = [(n, e) for n in self._network.nodes for e in n.entities if not e.system]
        made = [(n, e) for n, e in own if any(map(here, e.created_at))]
        led = [(n, e) for n, e in own if not any(map(here, e.created_at)) and any(map(here, e.path))]
        nodes = [n for n in self._network.nodes if here(n.defined_at) or here(n.launched_by)]
        return Answer(
            query,
            nodes=tuple(self._node(n) for n in nodes[:_MOST]),
            ends=tuple(self._end(n, e) for n, e in made[:_MOST]),
            through=tuple(self._end(n, e) for n, e in led[:_MOST]),
            doubts=self._doubts([f for f in self._network.findings if here(f.place)]),
        )

    def _meeting(self, meeting: MeetingPoint) -> MeetingTold:
        ends = tuple(self._end(node, entity) for node, entity in meeting.ends)
        types = tuple(sorted({end.type for end in ends if end.type}))
        content = None
        if self._contents is not None:
            content = self._contents.of(meeting.word, meeting.name, self._excerpts)
        return MeetingTold(meeting.word, meeting.name, types, ends, content)

    def _end(self, node: Node, entity: Entity) -> EndTold:
        missing = () if _whole(entity.resolution) and entity.type is not None else entity.reasons
        entries = self._starts.entries(node)
        return EndTold(
            kind=entity.kind.value,
            name=entity.name,
            type=entity.type,
            node=node.display_name,
            node_at=node.defined_at,
            system=entity.system,
            conditional=entity.conditional,
            resolution=entity.resolution.value,
            qos=_qos(entity.qos),
            callback=entity.callback,
            via=entity.via,
            created=tuple(self._excerpts.around(place) for place in entity.created_at[:5]),
            calls=entity.path[:-1],
            start=self._starts.of(node),
            made_of=sources(node, entity, entries),
            remaps=remap_rules(entity, entries),
            missing=missing,
            remedies=remedies(missing),
            policy=self._rights.of(entity),
        )

    def _node(self, node: Node) -> NodeTold:
        places = {node.defined_at, *(p for e in node.entities for p in e.created_at)}
        places |= {node.launched_by} if node.launched_by else set()
        at = {(place.file, place.line) for place in places}
        return NodeTold(
            name=node.display_name,
            interface=node.interface.value,
            lacks=node.lacks,
            resolution=node.resolution.value,
            created=self._excerpts.around(node.defined_at),
            start=self._starts.of(node),
            enclave=enclave_paths(self._network.nodes)[node.enclave],
            ends=tuple(self._end(node, entity) for entity in node.entities),
            parameters=tuple(ParameterTold(p.name, p.type, p.default, p.value, p.declared_at) for p in node.parameters),
            missing=node.reasons,
            remedies=remedies(node.reasons),
            doubts=self._doubts(
                [
                    f
                    for f in self._network.findings
                    if (f.place.file, f.place.line) in at and (not f.nodes or node.fqn in f.nodes)
                ]
            ),
        )

    def _enclave(self, path: str) -> EnclaveTold:
        paths = enclave_paths(self._network.nodes)
        nodes = tuple(sorted({n.display_name for n in self._network.nodes if paths[n.enclave] == path}))
        return EnclaveTold(path, nodes, tuple(self._rights.by_enclave.get(path, ())))

    def _doubts(self, findings: list[Finding]) -> tuple[DoubtTold, ...]:
        return tuple(
            DoubtTold(
                f.code,
                f.rule.severity.value,
                f.rule.title,
                f.message.removesuffix(f": {f.remedy}") if f.remedy else f.message,
                _whole_sentence(f.remedy) or RULES[f.code].help,
                self._excerpts.around(f.place),
            )
            for f in findings[:_MOST]
        )


def _whole_sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _whole(resolution: Resolution) -> bool:
    return resolution.whole


def _qos(qos: Qos | None) -> str:
    if qos is None:
        return ""
    history = f"keep_last {qos.depth}" if qos.history == "keep_last" and qos.depth is not None else qos.history
    return ", ".join(part or "?" for part in (qos.reliability, qos.durability, history))
