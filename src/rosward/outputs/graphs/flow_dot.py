# SPDX-License-Identifier: Apache-2.0
"""The flows of a system for Graphviz: what each node takes in and what it makes of it, as one graph.

Solid: the content is in it. Dashed: the content decides it. Dotted: its arrival triggers it. Grey: assumed, since a node was not analysed.
"""

from __future__ import annotations

from typing import Final

from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.influence.search import Passing
from rosward.outputs.graphs.dot_language import HEADER, LOOKS, label_of, quoted

__all__ = ["flow_dot"]

_STYLES: Final = {"data": "solid", "control": "dashed", "trigger": "dotted"}
_WORDS: Final = {
    "request": "service",
    "response": "service",
    "goal": "action",
    "feedback": "action",
    "result": "action",
}


def flow_dot(graph: FlowGraph, passing: Passing) -> str:
    """The text of the graph, with the edges that pass."""
    edges = sorted({e for several in graph.out.values() for e in several if passing(e)}, key=_order)
    vertices = sorted({_name(v) for e in edges for v in (e.source, e.target)})
    looks = {_name(v): _look(v) for e in edges for v in (e.source, e.target)}
    lines = ["digraph flow {", *(f"  {line};" for line in HEADER)]
    lines += [f"  {quoted(name)} [{looks[name]}];" for name in vertices]
    drawn: dict[tuple[str, str, str], Edge] = {}
    for edge in edges:
        if _name(edge.source) != _name(edge.target):
            drawn.setdefault((_name(edge.source), _name(edge.target), edge.node), edge)
    for (source, target, node), edge in drawn.items():
        color = "#9a9a94" if edge.assumed else "#333333"
        lines.append(
            f"  {quoted(source)} -> {quoted(target)} [label={label_of([node])}, style={_STYLES[edge.strength]}, color={quoted(color)}];"
        )
    return "\n".join([*lines, "}"]) + "\n"


def _order(edge: Edge) -> tuple[str, str, str, str]:
    return _name(edge.source), _name(edge.target), edge.node, edge.strength


def _name(vertex: Vertex) -> str:
    """Both sides of one name are one vertex."""
    return str(vertex)


def _look(vertex: Vertex) -> str:
    word = "topic" if vertex.end.kind == "topic" else _WORDS.get(vertex.end.kind, "node")
    look = LOOKS[word]
    return f'shape={look.shape}, fillcolor="{look.fill}", color="{look.line}"'
