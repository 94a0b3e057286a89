# SPDX-License-Identifier: Apache-2.0
"""What does a snapshot say? The reader of what `snapshot.py` writes.

    {"schema_version": 1, "nodes": [{"name": "talker", "namespace": "/", …, "publishers": [{"name": "/chatter", …}]}]}  ->  LiveGraph

A snapshot comes from elsewhere, so the reader is strict: what is not of that form is refused with the place of it, and size is bounded.
"""

from __future__ import annotations

from typing import Final

from rosward.audit.graph import LiveEntity, LiveGraph, LiveNode, with_actions
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.network_file import qos_of
from rosward.ros.entities import ENTITY_LISTS, EntityKind
from rosward.source.json_fields import Fields, UnreadableError, json_document

__all__ = ["read_snapshot", "snapshot_of"]

_MOST_ENTITIES: Final = 200_000
_MOST_NODES: Final = 20_000
_MOST_PROFILES: Final = 50
_MOST_PROBLEMS: Final = 100


def read_snapshot(path: str) -> LiveGraph:
    """What a file says. Raises UnreadableError."""
    return snapshot_of(json_document(path), path)


def snapshot_of(document: object, source: str = "") -> LiveGraph:
    """What a document says; `source` is where it comes from. Raises UnreadableError."""
    try:
        return _graph(Fields(document, "the document"), source)
    except UnreadableError as error:
        raise UnreadableError(f"{source or 'the snapshot'}: not a rosward snapshot: {error}") from error


def _graph(top: Fields, source: str) -> LiveGraph:
    top.version()
    nodes: dict[str, LiveNode] = {}
    left = _MOST_ENTITIES
    for fields in top.objects("nodes", _MOST_NODES):
        node = _node(fields)
        left -= len(node.entities)
        if left < 0:
            raise UnreadableError(f"there are more than {_MOST_ENTITIES:,} entities")
        if node.name in nodes:
            raise UnreadableError(f"{fields.where}: {node.name} is listed twice")
        nodes[node.name] = node
    return LiveGraph(
        nodes=tuple(nodes[name] for name in sorted(nodes)),
        loose=tuple(_entity(f, f.one_of("kind", ENTITY_LISTS)) for f in top.objects("without_node", _MOST_ENTITIES)),
        looks=top.number("looks"),
        distro=top.text_or_none("ros_distro"),
        source=source,
        findings=tuple(Finding("RW505", text, Place(source)) for text in _problems(top, nodes)),
    )


def _problems(top: Fields, nodes: dict[str, LiveNode]) -> list[str]:
    if not nodes:
        return ["No node was seen. Check the domain, and whether the snapshot may join the graph."]
    told = [f"The middleware did not list the entities of {node.name}." for node in nodes.values() if not node.known]
    problems = top.texts("problems", _MOST_PROBLEMS)
    return [*told, *(f"The snapshot could not query {problem}." for problem in problems)][:_MOST_PROBLEMS]


def _node(fields: Fields) -> LiveNode:
    name, namespace = fields.text("name"), fields.text("namespace")
    if not namespace.startswith("/") or not name or "/" in name:
        raise UnreadableError(f"{fields.where} has no name or no namespace")
    asked = fields.number("asked") > 0
    entities: list[LiveEntity] = []
    for key, kind in ENTITY_LISTS.items():
        entities += (_entity(f, kind) for f in fields.objects(key, _MOST_ENTITIES))
    return LiveNode(
        name=f"{namespace.rstrip('/')}/{name}",
        entities=with_actions(entities),
        count=max(fields.number("count"), 1),
        seen=fields.number("seen"),
        known=frozenset(ENTITY_LISTS.values()) if asked else frozenset(),
        enclaves=tuple(fields.texts("enclaves", _MOST_PROFILES)),
    )


def _entity(fields: Fields, kind: EntityKind) -> LiveEntity:
    return LiveEntity(
        kind=kind,
        name=fields.text("name"),
        type=fields.text("type"),
        seen=fields.number("seen"),
        qos=tuple(qos_of(f) for f in fields.objects("qos", _MOST_PROFILES)),
        ros_prefix=fields.flag("ros_prefix", True),
    )
