# SPDX-License-Identifier: Apache-2.0
"""What are the outputs of a declared program made of, as far as its declaration says so?

An output of which nothing is said may hold each input of the process, and so may all where the interface has more than is declared. Of a
program with one node and no word about flows, `influence/declared.py` assumes the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Final, NamedTuple, final

from rosward.deployment.declared.shapes import EndpointGroup, EndTemplate, Program
from rosward.domain.choice import options
from rosward.domain.text import readable
from rosward.domain.values import Value
from rosward.effects.flows import Flow, ProcessFlows, Sink, Source
from rosward.effects.log import EffectLog
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.entities import EntityKind
from rosward.ros.flows import STRENGTHS
from rosward.ros.roles import ARRIVING, SENT

__all__ = ["FoundEnd", "FoundFlow", "process_flows"]

Key = tuple[str, int | None, str]
_NAMED: Final = frozenset(("parameter", *(k for roles in (ARRIVING, SENT) for kinds in roles.values() for k in kinds)))
_NONE: Final[frozenset[Source]] = frozenset()


class FoundEnd(NamedTuple):
    """An input or output for one start; `name` is what its template stands for."""

    template: EndTemplate
    name: Value


class FoundFlow(NamedTuple):
    """An entry of a declaration that holds for the node at `address`."""

    address: int
    to: FoundEnd
    sources: tuple[tuple[str, FoundEnd], ...]


Interfaces = Callable[[str, str], EndpointGroup | None]
"""The group of a package and a name."""


def process_flows(
    log: EffectLog, found: Sequence[FoundFlow], program: Program, interface: Interfaces, place: Place
) -> ProcessFlows | None:
    """The flows of a process with these effects, started at `place`; None for one node of which the declaration says nothing.

    An entry that names what no endpoint of the program has is a finding of the log.
    """
    if not found:
        return ProcessFlows((), complete=False) if len(log.nodes) > 1 else None
    ports = _Ports(log)
    flows: list[Flow] = []
    said: set[Key] = set()
    missing: list[tuple[str, FoundEnd]] = []
    for entry in found:
        sinks = ports.find("output", entry.to, entry.address)
        if not sinks:
            missing.append(("output", entry.to))
        sources: dict[str, set[Source]] = {strength: set() for strength in STRENGTHS}
        for strength, end in entry.sources:
            arriving = ports.find("input", end, entry.address)
            if not arriving:
                missing.append(("input", end))
            sources[strength].update(arriving.values())
        data, control, trigger = (frozenset(sources[strength]) for strength in STRENGTHS)
        flows += [Flow(Sink(s.kind, s.node, s.given, place), data, control, trigger) for s in sinks.values()]
        said.update(sinks)
    every = frozenset(ports.input.values())
    for key, port in ports.output.items():
        if key not in said:
            flows.append(Flow(Sink(port.kind, port.node, port.given, place), every, _NONE, _NONE, assumed=every))
    if missing:
        spoken = frozenset(_spoken_of(program, interface))
        log.findings.update(_told(role, end) for role, end in missing if (role, *end.template[:2]) not in spoken)
    complete = not (log.open or any(f.code in ("RW201", "RW314", "RW324") for f in log.findings))
    return ProcessFlows(tuple(flows), complete)


def _told(role: str, end: FoundEnd) -> Finding:
    message = f"The declared flows name {end.template.kind}:{readable(end.name)}, which is no declared {role}."
    return Finding("RW324", message, end.template.place)


def _spoken_of(program: Program, interface: Interfaces) -> Iterator[tuple[str, str, str]]:
    """Role, kind and template of all that could be an input or output, whether or not it exists in this start."""
    work = [(program.package, node.group) for node in program.nodes]
    seen: set[tuple[str, str]] = set()
    while work:
        package, group = work.pop()
        for endpoint in group.endpoints:
            for role, kind in _roles(endpoint.kind):
                yield role, kind, endpoint.name
        yield from (("input", "parameter", parameter.name) for parameter in group.parameters)
        work += [(package, g) for g in (*group.groups, *(g for _, g in group.cases))]
        work += [(package, group.otherwise)] if group.otherwise is not None else []
        for include in group.includes:
            home, _, name = include.name.rpartition("/")
            key = (home or package, name)
            included = interface(*key) if key not in seen else None
            seen.add(key)
            work += [(key[0], included)] if included is not None else []


def _roles(kind: str) -> Iterator[tuple[str, str]]:
    """What an endpoint is: ("input", "topic") for a subscription."""
    entity = EntityKind(kind.replace("_", " "))
    yield from (("input", each) for each in ARRIVING.get(entity, ()))
    yield from (("output", each) for each in SENT.get(entity, ()))


@final
class _Ports:
    """The inputs and outputs of a process, by kind, node and name."""

    def __init__(self, log: EffectLog) -> None:
        self.input: dict[Key, Source] = {}
        self.output: dict[Key, Source] = {}
        for effect in log.entities:
            for role, kind in _roles(effect.kind):
                source = Source(kind, node=effect.address, given=effect.name)
                self._of(role).update({(kind, effect.address, readable(n)): source for n in options(effect.name)})
        for parameter in log.parameters:
            for name in map(readable, options(parameter.name)):
                self.input["parameter", parameter.address, name] = Source("parameter", name)
        self._anywhere: dict[tuple[str, str, str], list[Key]] = {}
        for role in ("input", "output"):
            for key in self._of(role):
                self._anywhere.setdefault((role, key[0], key[2]), []).append(key)

    def _of(self, role: str) -> dict[Key, Source]:
        return self.input if role == "input" else self.output

    def find(self, role: str, end: FoundEnd, address: int) -> dict[Key, Source]:
        """Those that an entry of a node means: its own of that name, else those of other nodes of the process."""
        kind, ports = end.template.kind, self._of(role)
        if kind not in _NAMED:
            name = readable(end.name)
            return {(kind, address, name): Source(kind, name, address, end.name if name else None)}
        found: dict[Key, Source] = {}
        for name in map(readable, options(end.name)):
            own = (kind, address, name)
            keys = [own] if own in ports else self._anywhere.get((role, kind, name), ())
            if kind == "parameter" and "*" in name:  # one of those that a file may give that is not known
                found[own] = Source(kind, name)
            found.update((key, ports[key]) for key in keys)
        return found
