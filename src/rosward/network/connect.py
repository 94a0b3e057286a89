# SPDX-License-Identifier: Apache-2.0
"""How nodes become the graph of the whole: equal entities merged, ends that meet joined, everything sorted.

    talker: publisher /chatter       ->    topic /chatter: talker -> listener
    listener: subscription /chatter

The result does not depend on the order in which nodes and findings come in.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import TypeVar

from rosward.findings import Finding, each_once
from rosward.location import Place
from rosward.network.checks import UnknownNames, check
from rosward.network.graph import Action, Network, Service, Topic
from rosward.records import NamedTuple, replace
from rosward.ros.entities import KIND_ORDER, Entity, EntityKind, Node, Parameter, Qos, surest

__all__ = ["apart", "connect", "with_findings"]

_T = TypeVar("_T")
_Item = TypeVar("_Item", str, Place)


def connect(
    distro: str,
    nodes: Iterable[Node],
    findings: Iterable[Finding] = (),
    *,
    files: int = 0,
    lines: int = 0,
    processes: int = 0,
    unknown: UnknownNames = "deny",
    net: bool = True,
) -> Network:
    """The graph of these nodes, with the findings given and those of the whole (`network/checks.py`).

    `unknown` is what the policy will say for an unknown name: it decides which wildcards there are to warn of. Without `net`, faults are raised.
    """
    sorted_nodes = tuple(_in_order(_settled(node) for node in nodes))
    kind = EntityKind
    network = Network(
        distro=distro,
        nodes=sorted_nodes,
        topics=tuple(Topic(*m) for m in _meetings(sorted_nodes, kind.PUBLISHER, kind.SUBSCRIPTION)),
        services=tuple(Service(*m) for m in _meetings(sorted_nodes, kind.SERVICE_SERVER, kind.SERVICE_CLIENT)),
        actions=tuple(Action(*m) for m in _meetings(sorted_nodes, kind.ACTION_SERVER, kind.ACTION_CLIENT)),
        findings=(),
        files=files,
        lines=lines,
        processes=processes,
    )
    return with_findings(network, [*findings, *check(network, unknown, net=net)])


def apart(distro: str, nodes: Iterable[Node], *, files: int = 0, lines: int = 0, processes: int = 0) -> Network:
    """What stands in for a graph that cannot be made: the nodes as they are, without what they meet at."""
    return Network(distro, tuple(sorted(nodes, key=_node_order)), (), (), (), (), files, lines, processes)


def with_findings(network: Network, findings: Iterable[Finding]) -> Network:
    """The same network with these findings too: sorted by place, each once."""
    return replace(network, findings=each_once((*network.findings, *findings)))


def _settled(node: Node) -> Node:
    groups: dict[tuple[int, str, str, bool], list[Entity]] = {}
    for entity in node.entities:
        key = (KIND_ORDER[entity.kind], entity.name, entity.type or "", entity.ros_prefix)
        groups.setdefault(key, []).append(entity)
    entities = tuple(_merged(groups[key]) for key in sorted(groups))
    return replace(node, entities=entities, parameters=_parameters(node.parameters))


def _merged(entities: list[Entity]) -> Entity:
    """One entity for several that are the same to the outside: it is surely there if one of them is."""
    first = entities[0]
    if len(entities) == 1 and all(
        len(part) < 2 for part in (first.depends_on, first.created_at, first.reasons, first.causes)
    ):
        return first
    callbacks = _union((e.callback,) for e in entities if e.callback is not None)
    vias = {e.via for e in entities}
    return replace(
        first,
        system=all(e.system for e in entities),
        resolution=surest(e.resolution for e in entities),
        conditional=all(e.conditional for e in entities),
        callback=", ".join(callbacks) or None,
        qos=_common_qos([e.qos for e in entities]),
        depends_on=_union(e.depends_on for e in entities),
        created_at=_union(e.created_at for e in entities),
        reasons=_union(e.reasons for e in entities),
        causes=_union(e.causes for e in entities),
        via=None if None in vias else min(via for via in vias if via is not None),
        path=min((e.path for e in entities if e.path), default=()),
    )


def _common_qos(profiles: list[Qos | None]) -> Qos | None:
    """What all of them agree on."""
    first = profiles[0]
    if first is None or any(qos is None for qos in profiles):
        return None
    return Qos(
        reliability=_agreed([qos.reliability for qos in profiles if qos]),
        durability=_agreed([qos.durability for qos in profiles if qos]),
        history=_agreed([qos.history for qos in profiles if qos]),
        depth=_agreed([qos.depth for qos in profiles if qos]),
    )


def _agreed(values: list[_T | None]) -> _T | None:
    return values[0] if all(value == values[0] for value in values) else None


def _union(parts: Iterable[tuple[_Item, ...]]) -> tuple[_Item, ...]:
    return tuple(sorted({item for part in parts for item in part}))


def _parameters(parameters: Iterable[Parameter]) -> tuple[Parameter, ...]:
    unique = {_parameter_order(parameter): parameter for parameter in parameters}
    return tuple(unique[key] for key in sorted(unique))


def _parameter_order(parameter: Parameter) -> tuple[str, str, str, str, Place]:
    return (
        parameter.name,
        parameter.type or "",
        repr(parameter.default),
        repr(parameter.value),
        parameter.declared_at or Place(""),
    )


def _in_order(nodes: Iterable[Node]) -> Iterator[Node]:
    """By name, process and place; where these are the same, by all that they are, which takes long to write down."""
    for _, same in groupby(sorted(nodes, key=_node_order), key=_node_order):
        several = list(same)
        yield from sorted(several, key=repr) if len(several) > 1 else several


def _node_order(node: Node) -> tuple[str, str, Place]:
    return (node.fqn, node.process, node.defined_at)


class _Joined(NamedTuple):
    """Fields in the order of `Topic`, `Service` and `Action`."""

    name: str
    types: tuple[str, ...]
    senders: tuple[str, ...]
    receivers: tuple[str, ...]
    system: bool


def _meetings(nodes: tuple[Node, ...], sender: EntityKind, receiver: EntityKind) -> list[_Joined]:
    ends: dict[str, list[tuple[Node, Entity]]] = {}
    for node in nodes:
        for entity in node.entities:
            if entity.kind is sender or entity.kind is receiver:
                ends.setdefault(entity.name, []).append((node, entity))
    return [
        _Joined(
            name,
            tuple(sorted({e.type for _, e in ends[name] if e.type is not None})),
            tuple(sorted({node.display_name for node, e in ends[name] if e.kind is sender})),
            tuple(sorted({node.display_name for node, e in ends[name] if e.kind is receiver})),
            all(e.system for _, e in ends[name]),
        )
        for name in sorted(ends)
    ]
