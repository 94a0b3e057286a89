# SPDX-License-Identifier: Apache-2.0
"""network.json as the benches read it: flat lists of nodes, entities and findings."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

KINDS = {
    "publisher": "publishers",
    "subscription": "subscriptions",
    "service": "service_servers",
    "client": "service_clients",
    "action_server": "action_servers",
    "action_client": "action_clients",
}
"""The kinds of entities, and the key of each in a node of network.json."""

Spot = tuple[str, int]
"""A file and a line in it."""


@dataclass(frozen=True, slots=True)
class Entity:
    """One entity of one node; `spots` are the places in the source that create it."""

    node: str
    kind: str
    name: str
    type: str | None
    system: bool
    resolution: str
    conditional: bool
    spots: tuple[Spot, ...]


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter that a node declares."""

    name: str
    type: str | None
    default: object


@dataclass(frozen=True, slots=True)
class Node:
    """One node; `name` is the fully qualified one, `launched` where a launch file starts it."""

    name: str
    resolution: str
    process: str
    spot: Spot
    program: str = ""
    launched: Spot | None = None
    interface: str | None = None
    parameters: tuple[Parameter, ...] = ()


@dataclass(frozen=True, slots=True)
class Finding:
    """One diagnostic."""

    code: str
    severity: str
    message: str
    spot: Spot


@dataclass(frozen=True, slots=True)
class Graph:
    """One network.json. The names are those of topics, services and actions, with whether each is of the system."""

    nodes: tuple[Node, ...]
    entities: tuple[Entity, ...]
    findings: tuple[Finding, ...]
    topics: dict[str, bool]
    services: dict[str, bool]
    actions: dict[str, bool]


def load(path: Path) -> Graph:
    """Read a network.json."""
    data = json.loads(path.read_text(encoding="utf-8"))
    return Graph(
        nodes=tuple(map(_node, data["nodes"])),
        entities=tuple(entity for node in data["nodes"] for entity in _entities(node)),
        findings=tuple(Finding(d["code"], d["severity"], d["message"], _spot(d)) for d in data["diagnostics"]),
        topics={t["name"]: t["system"] for t in data["topics"]},
        services={s["name"]: s["system"] for s in data["services"]},
        actions={a["name"]: a["system"] for a in data["actions"]},
    )


def _node(node: dict[str, Any]) -> Node:
    return Node(
        name=node["fqn"],
        resolution=node["resolution"],
        process=node["process"],
        spot=_spot(node["defined_at"]),
        program="/".join(filter(None, (node["package"], node["executable"]))),
        launched=_spot(node["launched_by"]) if node.get("launched_by") else None,
        interface=node.get("interface"),
        parameters=tuple(Parameter(p["name"], p["type"], p["default"]) for p in node.get("parameters", ())),
    )


def _entities(node: dict[str, Any]) -> Iterator[Entity]:
    for kind, key in KINDS.items():
        for e in node[key]:
            spots = tuple(_spot(place) for place in e["created_at"])
            yield Entity(node["fqn"], kind, e["name"], e["type"], e["system"], e["resolution"], e["conditional"], spots)


def _spot(place: dict[str, Any]) -> Spot:
    return place["file"], place["line"]
