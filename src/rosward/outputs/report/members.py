# SPDX-License-Identifier: Apache-2.0
"""What is there to say of a node, and of each thing that it has?

Node /a/talker  ->  {"id": "n0", "fqn": "/a/talker", …, "entities": ["e0"]}
                    {"id": "e0", "node": "n0", "endpoint": "t0", "kind": "publisher", …, "rule": "r0"}
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rosward.explanation.provenance import Start, remap_rules, remedies, sources
from rosward.network.launch_tree import LaunchEntry
from rosward.outputs.documents.rows import place_row
from rosward.outputs.report.numbered import Member, NumberedEnd
from rosward.outputs.report.plain import place_rows, value_row
from rosward.outputs.report.rights import NONE, DocumentRights
from rosward.ros.entities import Entity, Node, Parameter, Qos

__all__ = ["entity_rows", "node_row"]


def node_row(
    member: Member, start: Start, rights: DocumentRights, findings: Mapping[str, list[str]]
) -> dict[str, object]:
    """A node of the document, and how it is started; `findings` are those of each id."""
    node = member.node
    return {
        "id": member.id,
        "fqn": node.display_name,
        "namespace": node.namespace,
        "name": node.name,
        "package": node.package,
        "executable": node.executable,
        "process": node.process,
        "enclave": rights.enclave_of[member.id],
        "resolution": node.resolution.value,
        "reasons": list(node.reasons),
        "conditional": node.conditional,
        "assumed": node.assumed,
        "interface": node.interface.value,
        "lacks": list(node.lacks),
        "place": place_row(node.defined_at),
        "launched_by": place_row(node.launched_by) if node.launched_by is not None else None,
        "includes": place_rows(start.includes),
        "entities": [end.id for end in member.ends],
        "parameters": [_parameter(parameter) for parameter in node.parameters],
        "findings": findings.get(member.id, []),
    }


def entity_rows(
    member: Member, entries: Sequence[LaunchEntry], rights: DocumentRights, findings: Mapping[str, list[str]]
) -> list[object]:
    """The entities of a node that these entries of launch files may start."""
    return [_entity(end, entries, rights, findings.get(end.id, [])) for end in member.ends]


def _entity(
    end: NumberedEnd, entries: Sequence[LaunchEntry], rights: DocumentRights, findings: list[str]
) -> dict[str, object]:
    entity = end.entity
    right = rights.right_of.get(end.id, NONE)
    return {
        "id": end.id,
        "node": end.node_id,
        "endpoint": end.endpoint_id,
        "kind": entity.kind.value,
        "name": entity.name,
        "type": entity.type,
        "system": entity.system,
        "resolution": entity.resolution.value,
        "reasons": list(entity.reasons),
        "remedies": list(remedies(entity.reasons)) if _lacks(entity) else [],
        "conditional": entity.conditional,
        "callback": entity.callback,
        "qos": _qos(entity.qos) if entity.qos is not None else None,
        "via": entity.via,
        "places": place_rows(entity.created_at),
        "path": place_rows(entity.path),
        "sources": _sources(end.node, entity, entries) if entity.depends_on else [],
        "remaps": list(remap_rules(entity, entries)) if not entity.system else [],
        "rule": right.rule,
        "why_not": right.why_not,
        "findings": findings,
    }


def _lacks(entity: Entity) -> bool:
    return not entity.resolution.whole or entity.type is None


def _qos(qos: Qos) -> dict[str, object]:
    return {"reliability": qos.reliability, "durability": qos.durability, "history": qos.history, "depth": qos.depth}


def _sources(node: Node, entity: Entity, entries: Sequence[LaunchEntry]) -> list[object]:
    return [
        {
            "name": source.name,
            "what": source.what,
            "value": value_row(source.value),
            "origin": source.origin,
            "places": place_rows(source.places),
        }
        for source in sources(node, entity, entries)
    ]


def _parameter(parameter: Parameter) -> dict[str, object]:
    return {
        "name": parameter.name,
        "type": parameter.type,
        "default": value_row(parameter.default),
        "value": value_row(parameter.value),
        "place": place_row(parameter.declared_at) if parameter.declared_at is not None else None,
    }
