# SPDX-License-Identifier: Apache-2.0
"""The graph in the language of Graphviz.

    talker publishes /chatter, listener subscribes  ->  (talker) --> [/chatter] --> (listener)

Nodes are ellipses, topics boxes, services hexagons, actions tabbed folders; each has a colour that stays apart from the
others for colour-blind eyes. Namespaces of nodes are clusters, and a name in a cluster is written without the
namespace. A dashed edge exists in some executions only; a dashed, red outline is a name that is not completely known. What
nearly everyone talks to (`/tf`) would pull all of the drawing into one knot: it gets a double outline and is drawn
beside each of its nodes. What only the client library makes is hidden unless asked for. `class` attributes let a page
restyle the drawing. A dashed outline in the colour of nodes is a node that is assumed: nothing starts it. A node of
unknown interface is grey, and hatched in SVG, and says what it is: it is no node that does nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.network.graph import Network
from rosward.outputs.graphs.dot_language import HEADER, LOOKS, TOWARDS_NODE, UNKNOWN, Drawing, label_of, quoted
from rosward.outputs.graphs.layers import steps_between_layers
from rosward.outputs.writing import File, Material
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Interface, Node, Resolution

__all__ = ["drawing", "files", "graph_dot"]


_DOUBT: Final = "#c44200"
_HUB: Final = 12
"""Used by more nodes than this, a topic, service or action is drawn once for each of them."""

_IN_SHORT: Final = "graph [splines=line, nslimit=1, nslimit1=1, mclimit=0.1]"
_MOST_STEPS: Final = 4000
"""Beyond them (about half a second of drawing) lines are straight, and Graphviz looks less long for a better order."""


class _Vertex(NamedTuple):
    """What is drawn as one shape; `home` is the name that decides in which cluster."""

    key: str
    look: str
    name: str
    home: str
    types: tuple[str, ...]
    doubtful: bool
    hub: bool
    tooltip: str
    link: str | None
    assumed: bool = False
    unknown: str = ""
    """What is said of a node of unknown interface."""


def files(material: Material) -> Iterator[File]:
    """The files of the format `dot`."""
    yield "graph.dot", graph_dot(material.network, system=material.system, types=material.types)


def graph_dot(network: Network, system: bool = False, types: bool = False) -> str:
    """The graph as DOT. `system` shows what the client library makes as well, `types` the interface types."""
    return drawing(network, system, types).text


def drawing(network: Network, system: bool = False, types: bool = False, links: bool = False) -> Drawing:
    """The same with its size; `links` makes each node a link to `#node-N`, N its place in the network."""
    ends = _ends(network, system)
    vertices = _vertices(network, ends, links)
    edges = _edges(ends)
    body = [
        *_cluster("/", "/", _tree(network, vertices), types),
        *(_edge(*ends, look, conditional) for (ends, (look, conditional)) in sorted(edges.items())),
    ]
    steps = steps_between_layers(edges)
    header = (*HEADER, _IN_SHORT) if steps > _MOST_STEPS else HEADER
    lines = ["digraph rosward {", *(f"  {line};" for line in header), *(f"  {line}" for line in body), "}"]
    text = "\n".join(lines) + "\n"
    return Drawing(text, len(vertices), len(edges), steps, text)


class _DrawnEnd(NamedTuple):
    """An entity that is drawn, the node that it is of, and the key of the shape that both meet at."""

    node: Node
    entity: Entity
    key: str
    hub: bool


def _ends(network: Network, system: bool) -> list[_DrawnEnd]:
    shown = [(node, entity) for node in network.nodes for entity in node.entities if system or not entity.system]
    users: dict[str, set[str]] = {}
    for node, entity in shown:
        users.setdefault(_meeting_key(node, entity), set()).add(node.display_name)
    ends = []
    for node, entity in shown:
        key = _meeting_key(node, entity)
        hub = len(users[key]) > _HUB
        ends.append(_DrawnEnd(node, entity, f"{key} at {node.display_name}" if hub else key, hub))
    return ends


def _vertices(network: Network, ends: Iterable[_DrawnEnd], links: bool) -> list[_Vertex]:
    drawn: dict[str, _Vertex] = {}
    for number, node in enumerate(network.nodes):
        link = f"#node-{number}" if links else None
        tooltip = _tooltip(node.display_name, node.lacks if node.interface is Interface.UNKNOWN else node.reasons)
        key = _node_key(node)
        if node.assumed:
            tooltip += " (assumed: nothing starts it)"
        known = drawn.get(key)
        if known is None or (
            known.assumed and not node.assumed
        ):  # where something starts a node of the name, that counts
            wild = "*" in node.display_name
            unknown = _unknown(node)
            drawn[key] = _Vertex(
                *(key, "node", node.display_name, node.fqn, (), wild, False, tooltip, link, node.assumed),
                unknown=unknown,
            )
    types: dict[str, set[str]] = {}
    for node, entity, key, hub in ends:
        types.setdefault(key, set()).update({entity.type} if entity.type else ())
        look, tooltip = entity.kind.meeting, _tooltip(entity.name, entity.reasons)
        home = node.fqn if hub else entity.name
        drawn.setdefault(key, _Vertex(key, look, entity.name, home, (), "*" in entity.name, hub, tooltip, None))
    return [drawn[key]._replace(types=tuple(sorted(types.get(key, ())))) for key in sorted(drawn)]


def _unknown(node: Node) -> str:
    """What stands in a node of unknown interface, ''  in any other."""
    if node.interface is not Interface.UNKNOWN:
        return ""
    return "C++, unknown" if any("C++" in reason for reason in node.lacks) else "unknown"


def _edges(ends: Iterable[_DrawnEnd]) -> dict[tuple[str, str], tuple[str, bool]]:
    """From tail and head to the look and whether the edge is there in some executions only."""
    edges: dict[tuple[str, str], tuple[str, bool]] = {}
    for node, entity, key, _ in ends:
        pair = (key, _node_key(node)) if entity.kind in TOWARDS_NODE else (_node_key(node), key)
        _, sometimes = edges.get(pair, ("", True))
        edges[pair] = (entity.kind.meeting, entity.conditional and sometimes)
    return edges


def _node_key(node: Node) -> str:
    return f"node {node.display_name}"


def _meeting_key(node: Node, entity: Entity) -> str:
    """Two names of which nothing is known are not one name, so each node has its own."""
    word = entity.kind.meeting
    return (
        f"{word} {entity.name} of {node.display_name}"
        if entity.resolution is Resolution.UNKNOWN
        else f"{word} {entity.name}"
    )


def _cluster(space: str, parent: str, tree: _NamespaceTree, types: bool) -> Iterator[str]:
    """The shapes of one namespace, and the clusters of those right below it."""
    inside = [_vertex(vertex, space, types) for vertex in tree.vertices.get(space, ())]
    for one in tree.spaces.get(space, ()):
        inside += _cluster(one, space, tree, types)
    if space == "/":
        yield from inside
        return
    style = 'style="rounded,filled", fillcolor="#f6f6f4", color="#b9b9b2", fontcolor="#55554f", class="namespace"'
    yield f"subgraph {quoted('cluster ' + space)} {{"
    yield f"  graph [label={quoted(_relative(space, parent))}, labeljust=l, {style}];"
    yield from (f"  {line}" for line in inside)
    yield "}"


class _NamespaceTree(NamedTuple):
    """By namespace: the shapes right in it, and the namespaces right below it."""

    vertices: dict[str, list[_Vertex]]
    spaces: dict[str, list[str]]


def _tree(network: Network, vertices: Iterable[_Vertex]) -> _NamespaceTree:
    spaces = {node.namespace for node in network.nodes} | {"/"}
    tree = _NamespaceTree({}, {})
    for vertex in vertices:
        tree.vertices.setdefault(_innermost(vertex.home, spaces), []).append(vertex)
    for space in sorted(spaces - {"/"}):
        tree.spaces.setdefault(_innermost(space, spaces), []).append(space)
    return tree


def _innermost(name: str, spaces: set[str]) -> str:
    """The nearest of these namespaces above a name."""
    while name:
        name = name.rpartition("/")[0]
        if name in spaces:
            return name
    return "/"


def _relative(name: str, space: str) -> str:
    return name[len(space) + 1 :] if space != "/" and name.startswith(space + "/") else name


def _vertex(vertex: _Vertex, space: str, types: bool) -> str:
    look = UNKNOWN if vertex.unknown else LOOKS[vertex.look]
    label = [_relative(vertex.name, space)]
    if vertex.doubtful:
        label[0] += " ?"
    if types:
        label += vertex.types
    if vertex.unknown:
        label.append(vertex.unknown)
    attributes = [
        f"label={label_of(label)}",
        f"shape={look.shape}",
        f'fillcolor="{look.fill}"',
        f'color="{_DOUBT if vertex.doubtful else look.line}"',
        f"tooltip={quoted(vertex.tooltip)}",
        f'class="ros-{vertex.look}{" doubtful" if vertex.doubtful else ""}{" assumed" if vertex.assumed else ""}'
        f'{" unknown-interface" if vertex.unknown else ""}"',
    ]
    if vertex.hub:
        attributes.append("peripheries=2")
    if vertex.doubtful:
        attributes.append('style="filled,dashed", penwidth=1.6')
    elif vertex.assumed:
        attributes.append('style="filled,dashed"')
    if vertex.link:
        attributes.append(f'href="{vertex.link}"')
    return f"{quoted(vertex.key)} [{', '.join(attributes)}];"


def _edge(tail: str, head: str, look: str, conditional: bool) -> str:
    style = ", style=dashed" if conditional else ""
    return f'{quoted(tail)} -> {quoted(head)} [color="{LOOKS[look].line}", class="of-{look}"{style}];'


def _tooltip(name: str, reasons: tuple[str, ...]) -> str:
    return ": ".join([name, "; ".join(reasons)]) if reasons else name
