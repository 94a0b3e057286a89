# SPDX-License-Identifier: Apache-2.0
"""The graph in the language of Mermaid, which GitHub, GitLab and many editors draw where a README or a pull request holds it.

    talker publishes /chatter, listener subscribes  ->  n0(["talker"]) --> t0["/chatter"] --> n1(["listener"])

Nodes are rounded, topics boxes, services hexagons, actions slanted, in the colours of `dot.py`; namespaces of nodes are subgraphs. A dashed
edge exists in some executions only, a dashed outline is a node that is assumed,
and a red one a name that is not completely known. A node of unknown interface is grey. Shapes have numbers for their identity and
names stand in quoted labels as entities, so that no name is read as part of the drawing. Viewers refuse a text of more than 50 000
characters or 500 edges: what is more than that is left out, and the drawing says so.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.network.graph import Network
from rosward.outputs.writing import File, Material
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, EntityKind, Interface, Node, Resolution
from rosward.safe import encodable, printable

__all__ = ["fenced", "files", "graph_mermaid"]

_MOST_EDGES: Final = 400
_MOST_NODES: Final = 150
_LONGEST_NAME: Final = 100
_LARGEST: Final = 45_000

_LOOKS: Final = {
    "node": ('(["', '"])', "fill:#d9ecf8,stroke:#0072b2,color:#111"),
    "topic": ('["', '"]', "fill:#fcefd2,stroke:#b07800,color:#111"),
    "service": ('{{"', '"}}', "fill:#d5f0e6,stroke:#00805c,color:#111"),
    "action": ('[/"', '"/]', "fill:#f6e2ee,stroke:#a8457e,color:#111"),
}
_DOUBT: Final = "stroke:#c44200,stroke-width:2px,stroke-dasharray:5 3"
_UNKNOWN: Final = "fill:#e4e4e0,stroke:#6b6b65,stroke-dasharray:2 2"
_ASSUMED: Final = "stroke-dasharray:5 3"
_TOWARDS_NODE: Final = (EntityKind.SUBSCRIPTION, EntityKind.SERVICE_SERVER, EntityKind.ACTION_SERVER)
_PLAIN: Final = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/ .")


class _Shape(NamedTuple):
    """What is drawn once: its look, its name, the namespace in which it stands."""

    look: str
    name: str
    space: str


class _Key(NamedTuple):
    """What tells one shape from another; names of which nothing is known are apart for each node (`of`)."""

    look: str
    name: str
    of: str = ""


def files(material: Material) -> Iterator[File]:
    """The files of the format `mermaid`."""
    flowchart = graph_mermaid(material.network, system=material.system)
    yield "graph.mmd", flowchart
    yield "graph.md", fenced(flowchart)


def graph_mermaid(network: Network, system: bool = False) -> str:
    """The graph as a flowchart. `system` shows what the client library makes as well."""
    most_nodes, most_edges = _MOST_NODES, _MOST_EDGES
    while True:
        text = _drawn(network, most_nodes, most_edges, system=system)
        if len(text) <= _LARGEST or most_edges == 0:
            return text
        most_nodes, most_edges = most_nodes // 2, most_edges // 2


def fenced(text: str) -> str:
    """A drawing as a block of Markdown."""
    return f"```mermaid\n{text}```\n"


def _drawn(network: Network, most_nodes: int, most_edges: int, *, system: bool) -> str:
    nodes = {node.display_name: node for node in network.nodes}
    chosen = dict(sorted(nodes.items())[:most_nodes])
    every = _edges((node for node in network.nodes if node.display_name in chosen), system=system)
    edges = dict(sorted(every.items())[:most_edges])
    spaces = {node.namespace for node in chosen.values()} | {"/"}
    shapes = {_Key("node", name): _Shape("node", name, node.namespace) for name, node in chosen.items()}
    for pair in edges:
        for key in pair:
            shapes.setdefault(key, _Shape(key.look, key.name, _innermost(key.name, spaces)))
    ids = {key: f"{key.look[0]}{number}" for number, key in enumerate(sorted(shapes))}
    lines = ["flowchart LR"]
    lines += _size_comment(len(nodes) - len(chosen), len(every) - len(edges))
    lines += _subgraphs("/", shapes, ids, spaces)
    lines += _arrows(edges, ids)
    started = {node.display_name for node in network.nodes if not node.assumed}
    unknown = {name for name, node in chosen.items() if node.interface is Interface.UNKNOWN}
    lines += _styles(shapes, ids, started, unknown)
    return "\n".join(lines) + "\n"


def _size_comment(nodes: int, edges: int) -> Iterator[str]:
    if nodes or edges:
        parts = [f"{nodes} nodes"] if nodes else []
        parts += [f"{edges} edges"] if edges else []
        yield f'  cut["omitted from this drawing: {" and ".join(parts)}"]'


def _edges(nodes: Iterable[Node], *, system: bool) -> dict[tuple[_Key, _Key], bool]:
    """From tail and head to whether the edge is there in some executions only."""
    edges: dict[tuple[_Key, _Key], bool] = {}
    for node in nodes:
        for entity in node.entities:
            if system or not entity.system:
                own, other = _Key("node", node.display_name), _meeting(node, entity)
                pair = (other, own) if entity.kind in _TOWARDS_NODE else (own, other)
                edges[pair] = edges.get(pair, True) and entity.conditional
    return edges


def _meeting(node: Node, entity: Entity) -> _Key:
    apart = node.display_name if entity.resolution is Resolution.UNKNOWN else ""
    return _Key(entity.kind.meeting, entity.name, apart)


def _innermost(name: str, spaces: set[str]) -> str:
    while name:
        name = name.rpartition("/")[0]
        if name in spaces:
            return name
    return "/"


def _subgraphs(top: str, shapes: dict[_Key, _Shape], ids: dict[_Key, str], spaces: set[str]) -> Iterator[str]:
    """The shapes of each namespace; a namespace stands in the innermost one above it. Not recursive: names may be deep."""
    inside: dict[str, list[_Key]] = {}
    for key in sorted(shapes):
        inside.setdefault(shapes[key].space, []).append(key)
    below: dict[str, list[str]] = {}
    for space in sorted(spaces - {top}, reverse=True):
        below.setdefault(_innermost(space, spaces), []).append(space)
    numbers = {space: number for number, space in enumerate(sorted(spaces))}
    waiting: list[tuple[str, str, int]] = [("open", top, 1)]
    while waiting:
        step, space, depth = waiting.pop()
        indent = "  " * min(depth, 20)
        if step == "close":
            yield f"{indent}end"
            continue
        if space != top:
            yield f'{indent}subgraph g{numbers[space]}["{_label(space)}"]'
            waiting.append(("close", space, depth))
        inner = "  " * min(depth + (space != top), 20)
        for key in inside.get(space, ()):
            first, last, _ = _LOOKS[key.look]
            doubt = " ?" if "*" in key.name else ""
            yield f"{inner}{ids[key]}{first}{_label(_relative(key.name, space))}{doubt}{last}"
        waiting += [("open", each, depth + (space != top)) for each in below.get(space, ())]


def _relative(name: str, space: str) -> str:
    """The name below its namespace; the whole of it where nothing would be left, for Mermaid refuses an empty label."""
    below = name[len(space) + 1 :] if space != "/" and name.startswith(space + "/") else name
    return below or name


def _arrows(edges: dict[tuple[_Key, _Key], bool], ids: dict[_Key, str]) -> Iterator[str]:
    for (tail, head), conditional in sorted(edges.items()):
        yield f"  {ids[tail]} {'-.->' if conditional else '-->'} {ids[head]}"


def _styles(shapes: dict[_Key, _Shape], ids: dict[_Key, str], started: set[str], unknown: set[str]) -> Iterator[str]:
    for look, (_, _, style) in _LOOKS.items():
        members = [ids[key] for key in sorted(shapes) if key.look == look]
        if members:
            yield f"  classDef ros{look.title()} {style}"
            yield f"  class {','.join(members)} ros{look.title()}"
    assumed = [ids[key] for key in sorted(shapes) if key.look == "node" and key.name not in started]
    if assumed:
        yield f"  classDef rosAssumed {_ASSUMED}"
        yield f"  class {','.join(assumed)} rosAssumed"
    of_unknown = [ids[key] for key in sorted(shapes) if key.look == "node" and key.name in unknown]
    if of_unknown:
        yield f"  classDef rosUnknown {_UNKNOWN}"
        yield f"  class {','.join(of_unknown)} rosUnknown"
    doubtful = [ids[key] for key in sorted(shapes) if "*" in key.name]
    if doubtful:
        yield f"  classDef rosDoubt {_DOUBT}"
        yield f"  class {','.join(doubtful)} rosDoubt"


def _label(name: str) -> str:
    """A name as the inside of a quoted label: all but letters, digits and a few signs as `#N;`, Mermaid's form of a character by its code."""
    text = encodable(printable(name))
    if len(text) > _LONGEST_NAME:
        text = text[:_LONGEST_NAME] + "…"
    return "".join(c if c in _PLAIN else f"#{ord(c)};" for c in text)
