# SPDX-License-Identifier: Apache-2.0
"""The network as JSON, for programs and for `git diff`: version 2, schema in `schemas/network.schema.json`.

    {"schema_version": 2, "generator": {…}, "distro": "jazzy", "asked": {…}, "nodes": [{"fqn": "/talker", …}], "topics": […], …}

Keys have a fixed order, lists are sorted, and nothing depends on machine, time or the order of the file system.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Final

from rosward.location import Place
from rosward.network.asked import Asked
from rosward.network.graph import Action, Network, Service, Topic
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import finding_row, header, place_row
from rosward.outputs.writing import File, Material
from rosward.ros.entities import ENTITY_LISTS, Entity, Node, Parameter

__all__ = ["SCHEMA_VERSION", "files", "network_json"]

SCHEMA_VERSION: Final = 2


def files(material: Material) -> Iterator[File]:
    """The files of the format `json`."""
    yield "network.json", network_json(material.network)


def network_json(network: Network) -> str:
    """The text of `network.json`."""
    document = {
        **header(SCHEMA_VERSION),
        "distro": network.distro,
        "asked": _asked(network.asked),
        "nodes": [_node(node) for node in network.nodes],
        "topics": [_topic(topic) for topic in network.topics],
        "services": [_offer(service) for service in network.services],
        "actions": [_offer(action) for action in network.actions],
        "diagnostics": _diagnostics(network),
    }
    return json_text(document)


def _asked(asked: Asked) -> dict[str, object]:
    return {
        "paths": list(asked.paths),
        "launch": [{"file": launch.file, "arguments": dict(launch.arguments)} for launch in asked.launch],
        "all_launch": asked.all_launch,
        "arguments": dict(asked.arguments),
        "nodes": list(asked.nodes),
        "parameter_files": list(asked.parameter_files),
        "environment": dict(asked.environment),
        "options": {name: list(value) if isinstance(value, tuple) else value for name, value in asked.options},
        "models": asked.models,
    }


def _node(node: Node) -> dict[str, object]:
    return {
        "fqn": node.fqn,
        "label": node.display_name,
        "namespace": node.namespace,
        "name": node.name,
        "resolution": node.resolution.value,
        "interface": node.interface.value,
        "lacks": list(node.lacks),
        "enclave": node.enclave,
        "package": node.package,
        "executable": node.executable,
        "process": node.process,
        "launched_by": place_row(node.launched_by) if node.launched_by else None,
        "defined_at": place_row(node.defined_at),
        **{key: _entities(node.of_kind(kind)) for key, kind in ENTITY_LISTS.items()},
        "parameters": [_parameter(parameter) for parameter in node.parameters],
    }


def _entities(entities: Iterable[Entity]) -> list[dict[str, object]]:
    return [_entity(entity) for entity in sorted(entities, key=lambda e: (e.name, e.type or ""))]


def _entity(entity: Entity) -> dict[str, object]:
    qos = entity.qos
    return {
        "name": entity.name,
        "type": entity.type,
        "system": entity.system,
        "resolution": entity.resolution.value,
        "conditional": entity.conditional,
        "callback": entity.callback,
        "qos": qos
        and {"reliability": qos.reliability, "durability": qos.durability, "history": qos.history, "depth": qos.depth},
        "depends_on": sorted(entity.depends_on),
        "created_at": _places(entity.created_at),
    }


def _parameter(parameter: Parameter) -> dict[str, object]:
    return {
        "name": parameter.name,
        "type": parameter.type,
        "default": _plain(parameter.default),
        "value": _plain(parameter.value),
        "declared_at": place_row(parameter.declared_at) if parameter.declared_at else None,
    }


def _topic(topic: Topic) -> dict[str, object]:
    return {
        "name": topic.name,
        "types": list(topic.types),
        "publishers": list(topic.publishers),
        "subscriptions": list(topic.subscriptions),
        "system": topic.system,
    }


def _offer(offer: Service | Action) -> dict[str, object]:
    return {
        "name": offer.name,
        "types": list(offer.types),
        "servers": list(offer.servers),
        "clients": list(offer.clients),
        "system": offer.system,
    }


def _diagnostics(network: Network) -> list[dict[str, object]]:
    ordered = sorted(network.findings, key=lambda f: (f.place, f.code, f.message))
    return [
        {
            **finding_row(finding),
            "column": finding.place.column,
            "causes": list(finding.causes),
            "nodes": list(finding.nodes),
        }
        for finding in ordered
    ]


def _places(places: Iterable[Place]) -> list[dict[str, object]]:
    return [{"file": file, "line": line} for file, line in sorted({(place.file, place.line) for place in places})]


def _plain(value: object) -> object:
    """A parameter's value in JSON. Infinity and not-a-number, which JSON lacks, are written as YAML writes them."""
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else _not_finite(value)
    if isinstance(value, (list, tuple, bytes, bytearray)):
        return [_plain(item) for item in value]
    return None


def _not_finite(value: float) -> str:
    if math.isnan(value):
        return ".nan"
    return ".inf" if value > 0 else "-.inf"
