# SPDX-License-Identifier: Apache-2.0
"""Running systems made from networks: what would be seen if a system did just what its source says."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from rosward.audit.accepted import Accepted
from rosward.audit.compare import audit
from rosward.audit.document import snapshot_of
from rosward.audit.graph import LiveGraph
from rosward.findings import Finding
from rosward.ros.entities import ENTITY_LISTS, Entity, EntityKind, Node

PARTS = {
    EntityKind.ACTION_SERVER: ("publishers", "service_servers"),
    EntityKind.ACTION_CLIENT: ("subscriptions", "service_clients"),
}


def snapshot(
    *nodes: Node, loose: Sequence[dict[str, Any]] = (), counts: dict[str, int] | None = None
) -> dict[str, Any]:
    """The document that a snapshot of these nodes would be, with the topics and services of their actions."""
    rows = [_node(node, (counts or {}).get(node.fqn, 1)) for node in {node.fqn: node for node in nodes}.values()]
    return {
        "schema_version": 1,
        "generator": {"name": "rosward snapshot", "version": "1"},
        "ros_distro": "kilted",
        "looks": 10,
        "nodes": rows,
        "without_node": list(loose),
        "problems": [],
    }


def _node(node: Node, count: int) -> dict[str, Any]:
    lists: dict[str, list[dict[str, Any]]] = {key: [] for key in ENTITY_LISTS}
    for key, kind in ENTITY_LISTS.items():
        for entity in node.of_kind(kind):
            lists[key].append(seen(entity.name, entity.type or "std_msgs/msg/String", entity))
            if kind in PARTS:
                topics, services = PARTS[kind]
                parts = (("feedback", "status"), ("send_goal", "cancel_goal", "get_result"))
                for where, names in zip((topics, services), parts, strict=True):
                    lists[where] += [seen(f"{entity.name}/_action/{n}", f"{entity.type}_X") for n in names]
    space, _, name = node.fqn.rpartition("/")
    return {
        "name": name,
        "namespace": space or "/",
        "enclaves": ["/"],
        "seen": 10,
        "asked": 10,
        "count": count,
        **lists,
    }


def seen(name: str, type_: str, entity: Entity | None = None, **more: Any) -> dict[str, Any]:
    qos = entity.qos if entity is not None else None
    policies = ("reliability", "durability", "history", "depth")
    profiles = [{policy: getattr(qos, policy) for policy in policies}] if qos else []
    return {"name": name, "type": type_, "seen": 10, "qos": profiles, **more}


def running(*nodes: Node, **more: Any) -> LiveGraph:
    return snapshot_of(snapshot(*nodes, **more), "robot.json")


def told(
    expected: Iterable[Node], graph: LiveGraph, *allow: str, findings: Iterable[Finding] = ()
) -> list[tuple[str, str, str]]:
    """Code, node and entity of each difference."""
    found = audit(expected, findings, graph, Accepted(allow))
    return [(d.finding.code, d.node, d.entity) for d in found.differences]
