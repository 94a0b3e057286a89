# SPDX-License-Identifier: Apache-2.0
"""The flows of a system, for a program: `flow.json`, schema in `schemas/flow.schema.json`.

{"schema": 1, "nodes": [{"node": "/controller", "sinks": [{"sink": "topic:/cmd_vel", "data": ["topic:/plan"], …}]}], "links": […]}
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

from rosward._version import __version__
from rosward.findings import Finding
from rosward.influence.declared import flows_of, unreleased
from rosward.influence.graph import FlowGraph
from rosward.influence.links import links_of
from rosward.location import Place
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import finding_row
from rosward.ros.entities import Interface, Node
from rosward.ros.flows import STRENGTHS, End, NodeCall, NodeSink

__all__ = ["flow_json"]

_SCHEMA: Final = 1
_INTERFACES: Final = {
    Interface.ANALYSED: "known",
    Interface.DECLARED: "declared",
    Interface.PARTIAL: "partial",
    Interface.UNKNOWN: "unknown",
}


def flow_json(nodes: Sequence[Node], graph: FlowGraph, findings: Iterable[Finding]) -> str:
    """The text of the document."""
    document = {
        "schema": _SCHEMA,
        "rosward": __version__,
        "nodes": [_node(node) for node in nodes],
        "links": [
            {"from": f"{link.sender} {link.sink}", "to": f"{link.receiver} {link.source}"}
            for link in links_of(nodes, graph)
        ],
        "findings": [finding_row(f) for f in findings],
    }
    return json_text(document)


def _node(node: Node) -> dict[str, object]:
    flows = flows_of(node)
    return {
        "node": node.display_name,
        "interface": _INTERFACES[node.interface],
        "complete": flows.complete,
        "sinks": [_sink(unreleased(sink, flows.released)) for sink in flows.sinks],
    }


def _sink(sink: NodeSink) -> dict[str, object]:
    paths = dict(sink.paths)
    calls = [{"through": [_at(p) for p in call.through], **_lists(call)} for call in sink.calls]
    known = {end for strength in STRENGTHS for end in sink.of(strength)}
    return {
        "sink": str(sink.sink),
        "at": _at(sink.at),
        **_lists(sink),
        "assumed": _texts(sink.assumed),
        "paths": {
            str(end): [_at(place) for place in path] for end, path in sorted(paths.items()) if path and end in known
        },
        **({"calls": calls} if len(calls) > 1 else {}),
    }


def _lists(sent: NodeSink | NodeCall) -> dict[str, object]:
    return {strength: _texts(sent.of(strength)) for strength in STRENGTHS}


def _texts(ends: Iterable[End]) -> list[str]:
    return sorted(str(end) for end in ends)


def _at(place: Place) -> list[object]:
    return [place.file, place.line]
