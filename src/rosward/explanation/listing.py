# SPDX-License-Identifier: Apache-2.0
"""Which nodes, topics, services, actions, packages and parameters are there? One row each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Final

from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Action, Network, Service, Topic
from rosward.ros.entities import Parameter

__all__ = ["KINDS", "Row", "rows_of"]

Row = Mapping[str, object]


def rows_of(network: Network, kind: str, *, system: bool = False) -> list[Row]:
    """The rows of one of KINDS, sorted; `system`: with what the client library creates by itself."""
    return KINDS[kind](network, system)


def _nodes(network: Network, system: bool) -> list[Row]:
    paths = enclave_paths(network.nodes)
    return [
        {
            "node": node.display_name,
            "package": node.package,
            "executable": node.executable,
            "interface": node.interface.value,
            "assumed": node.assumed,
            "enclave": paths[node.enclave],
            "entities": sum(system or not e.system for e in node.entities),
            "defined": str(node.defined_at),
        }
        for node in sorted(network.nodes, key=lambda n: (n.display_name, n.package or "", n.process))
    ]


def _topics(network: Network, system: bool) -> list[Row]:
    return [
        {"topic": t.name, "types": t.types, "publishers": t.publishers, "subscriptions": t.subscriptions}
        for t in _listed(network.topics, system)
        if isinstance(t, Topic)
    ]


def _offers(word: str, offers: Sequence[Service | Action], system: bool) -> list[Row]:
    return [
        {word: o.name, "types": o.types, "servers": o.servers, "clients": o.clients}
        for o in _listed(offers, system)
        if not isinstance(o, Topic)
    ]


def _listed(meetings: Iterable[Topic | Service | Action], system: bool) -> list[Topic | Service | Action]:
    return sorted((m for m in meetings if system or not m.system), key=lambda m: m.name)


def _packages(network: Network, system: bool) -> list[Row]:
    """By what is found in them: a package without a node is not here."""
    nodes = Counter(node.package for node in network.nodes)
    return [
        {
            "package": package,
            "nodes": nodes[package],
            "executables": sorted({n.executable for n in network.nodes if n.package == package and n.executable}),
            "entities": sum(system or not e.system for n in network.nodes if n.package == package for e in n.entities),
        }
        for package in sorted(nodes, key=lambda p: p or "")
    ]


def _parameters(network: Network, _system: bool) -> list[Row]:
    return [
        {"parameter": p.name, "node": n.display_name, "type": p.type, "value": _plain(p), "declared": _declared(p)}
        for n in sorted(network.nodes, key=lambda n: n.fqn)
        for p in sorted(n.parameters, key=lambda p: p.name)
    ]


def _plain(parameter: Parameter) -> str | None:
    return None if parameter.value is None else repr(parameter.value)


def _declared(parameter: Parameter) -> str | None:
    return None if parameter.declared_at is None else str(parameter.declared_at)


KINDS: Final[Mapping[str, Callable[[Network, bool], list[Row]]]] = {
    "nodes": _nodes,
    "topics": _topics,
    "services": lambda network, system: _offers("service", network.services, system),
    "actions": lambda network, system: _offers("action", network.actions, system),
    "packages": _packages,
    "parameters": _parameters,
}
"""What can be listed."""
