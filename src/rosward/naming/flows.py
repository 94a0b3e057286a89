# SPDX-License-Identifier: Apache-2.0
"""From the flows of one process to those of its nodes: the same rules that give its entities their names give them to sources and sinks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.values import Value
from rosward.effects.flows import RELEASED, Callback, Flow, ProcessFlows, Source
from rosward.findings import Findings
from rosward.location import Place
from rosward.naming.implicit import Identity
from rosward.naming.options import name_options
from rosward.naming.resolved import resolved
from rosward.records import replace
from rosward.ros.distro import Distro
from rosward.ros.entities import EntityKind, Node
from rosward.ros.flows import EXECUTING, STRENGTHS, End, NodeCall, NodeCallback, NodeFlows, NodeSink
from rosward.ros.roles import all_to_all

_NAMED: Final = {
    "topic": EntityKind.PUBLISHER,
    "service": EntityKind.SERVICE_SERVER,
    "request": EntityKind.SERVICE_CLIENT,
    "response": EntityKind.SERVICE_CLIENT,
    "goal": EntityKind.ACTION_CLIENT,
    "cancel": EntityKind.ACTION_SERVER,
    "feedback": EntityKind.ACTION_CLIENT,
    "result": EntityKind.ACTION_CLIENT,
}
"""The kinds of sources and sinks that have ROS names, and by the rules of which entities these are completed."""
_ANY_NAME: Final = "/*"
Identities = Iterable[tuple[int, Identity]]
"""The address of each node of a process, with each full name that it may have."""


def with_flows(nodes: list[Node], identities: Identities, flows: ProcessFlows, distro: Distro) -> list[Node]:
    """The nodes of a process (one for each identity, in their order), each with what its outputs are made of."""
    known = list(identities)
    addresses = {address for address, _ in known}
    result = []
    for node, (address, identity) in zip(nodes, known, strict=True):
        names = _Names(known, address, identity, distro)
        sinks = [
            sink
            for flow in flows.flows
            if flow.sink.node == address or flow.sink.node not in addresses
            for sink in _sinks(flow, names)
        ]
        if not flows.complete:
            sinks += all_to_all(node, nodes)
        callbacks = tuple(
            _callback(each, names) for each in flows.callbacks if each.node == address or each.node not in addresses
        )
        result.append(replace(node, flows=replace(_flows(sinks, complete=flows.complete), callbacks=callbacks)))
    return result


def _callback(callback: Callback, names: _Names) -> NodeCallback:
    sends: dict[End, set[End]] = {}
    for sink, sources in callback.sinks:
        for end in names.of(sink.kind, sink.node, sink.given):
            sends.setdefault(end, set()).update(_ends(sources, names))
    return NodeCallback(
        _ends(callback.events, names),
        callback.function,
        callback.place,
        tuple((end, tuple(sorted(sources))) for end, sources in sends.items()),
        callback.period,
    )


def _flows(sinks: Iterable[NodeSink], *, complete: bool) -> NodeFlows:
    joined = _joined(sinks)
    outputs = tuple(s for s in joined if s.sink.kind not in (*EXECUTING, RELEASED))
    executed = tuple(s for s in joined if s.sink.kind in EXECUTING)
    return NodeFlows(outputs, complete, executed, tuple(s for s in joined if s.sink.kind == RELEASED))


class _Names:
    """The names of sources and sinks as one node of a process has them; those of other nodes by all names that they may have."""

    def __init__(self, known: list[tuple[int, Identity]], address: int, identity: Identity, distro: Distro) -> None:
        self._known, self._address, self._identity, self._distro = known, address, identity, distro
        self._found: dict[tuple[str, int | None, Value | None, str], tuple[End, ...]] = {}

    def of(self, kind: str, node: int | None, given: Value | None, name: str = "") -> tuple[End, ...]:
        """What a source or sink is called."""
        key = (kind, node, given, name)
        found = self._found.get(key)
        if found is None:
            found = self._found[key] = tuple(dict.fromkeys(self._of(*key)))
        return found

    def _of(self, kind: str, node: int | None, given: Value | None, name: str) -> Iterator[End]:
        entity = _NAMED.get(kind)
        if entity is None or given is None:
            yield End(kind, name or (given is not None and text_of(given)) or "")
            return
        identities = [i for address, i in self._known if address == node]
        any_ = False
        for identity in [self._identity] if node == self._address or not identities else identities:
            for option in name_options(given):
                for text, _ in resolved(entity, option, identity, self._distro, Place("", 0), Findings()):
                    any_ = True
                    yield End(kind, text)
        if not any_:  # no node can have this name: only a parameter that is set makes it one
            yield End(kind, _ANY_NAME)


def _sinks(flow: Flow, names: _Names) -> Iterator[NodeSink]:
    sink = flow.sink
    data, control, trigger = (_ends(each, names) for each in (flow.data, flow.control, flow.trigger))
    paths: dict[End, tuple[Place, ...]] = {}
    for source, path in flow.paths.items():
        for end in names.of(source.kind, source.node, source.given, source.name):
            paths.setdefault(end, path)
    calls = tuple(
        NodeCall(call.through, *(_ends(each, names) for each in (call.data, call.control, call.trigger)))
        for call in flow.calls
    )
    for end in names.of(sink.kind, sink.node, sink.given):
        assumed = _ends(flow.assumed, names)
        yield NodeSink(end, sink.place, data, control, trigger, assumed, tuple(sorted(paths.items())), calls)


def _ends(sources: Iterable[Source], names: _Names) -> tuple[End, ...]:
    return tuple(sorted({end for s in sources for end in names.of(s.kind, s.node, s.given, s.name)}))


def _joined(sinks: Iterable[NodeSink]) -> tuple[NodeSink, ...]:
    """One for each name and statement, with each source in the strongest list that holds."""
    found: dict[tuple[End, Place], list[NodeSink]] = {}
    for sink in sinks:
        found.setdefault((sink.sink, sink.at), []).append(sink)
    return tuple(_one(several) for _, several in sorted(found.items(), key=lambda item: item[0]))


def _one(several: list[NodeSink]) -> NodeSink:
    listed = _strongest(several)
    seen = {end for ends in listed.values() for end in ends}
    sure = {end for sink in several for s in STRENGTHS for end in sink.of(s) if end not in sink.assumed}
    paths: dict[End, tuple[Place, ...]] = {}
    for sink in several:
        paths = {**dict(sink.paths), **paths}
    first = several[0]
    kept = tuple(sorted((end, path) for end, path in paths.items() if end in seen))
    return NodeSink(
        first.sink, first.at, **listed, assumed=tuple(sorted(seen - sure)), paths=kept, calls=_calls(several)
    )


def _strongest(several: Iterable[NodeSink | NodeCall]) -> dict[str, tuple[End, ...]]:
    """The sources of all of them by strength, each in the strongest only."""
    known = list(several)
    listed: dict[str, tuple[End, ...]] = {}
    seen: set[End] = set()
    for strength in STRENGTHS:
        ends = {end for each in known for end in each.of(strength)} - seen
        seen |= ends
        listed[strength] = tuple(sorted(ends))
    return listed


def _calls(several: list[NodeSink]) -> tuple[NodeCall, ...]:
    """By callers, where all of them are told by callers."""
    if not all(sink.calls for sink in several):
        return ()
    found: dict[tuple[Place, ...], list[NodeCall]] = {}
    for sink in several:
        for call in sink.calls:
            found.setdefault(call.through, []).append(call)
    return tuple(NodeCall(through, **_strongest(calls)) for through, calls in sorted(found.items()))


def both(ours: NodeFlows | None, theirs: NodeFlows | None) -> NodeFlows | None:
    """The flows of a node that is known twice."""
    if ours is None or theirs is None:
        return ours or theirs
    sinks = (*ours.sinks, *theirs.sinks, *ours.executed, *theirs.executed, *ours.released, *theirs.released)
    callbacks = tuple(dict.fromkeys((*ours.callbacks, *theirs.callbacks)))
    return replace(_flows(sinks, complete=ours.complete and theirs.complete), callbacks=callbacks)
