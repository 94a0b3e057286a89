# SPDX-License-Identifier: Apache-2.0
"""The flows of all nodes as one graph: publications meet subscriptions, requests meet services, log calls meet /rosout.

    /planner   topic:/map -> topic:/plan          planner.py:40 to planner.py:61
    /control   topic:/plan -> topic:/cmd_vel      control.py:64 to control.py:85

What stands at a vertex is content: of a topic, a request, a parameter of one node, or what one node gets from or sends to the outside.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final, final

from rosward.influence.declared import flows_of
from rosward.location import Place
from rosward.network.holes import may_meet
from rosward.records import NamedTuple
from rosward.ros.entities import Node
from rosward.ros.flows import STRENGTHS, End

SHARED: Final = ("topic", "request", "response", "goal", "cancel", "feedback", "result", "tf", "log")
"""Kinds of content that nodes share by its name."""
_ROSOUT: Final = "/rosout"
_TF: Final = ("/tf", "/tf_static")
_PARAMETER_EVENTS: Final = "/parameter_events"
_SETTERS: Final = ("set_parameters", "set_parameters_atomically")


class Vertex(NamedTuple):
    """Content: what it is, of which node ('' where nodes share it), and on which side: `sent` by nodes, or `in` where it has arrived."""

    end: End
    node: str = ""
    side: str = "in"

    def __str__(self) -> str:
        shown = self.end.name if self.end.kind == "topic" else str(self.end)
        return f"{shown} of {self.node}" if self.node else shown


class Edge(NamedTuple):
    """Content of one vertex stands in another one, or decides it. `node` is '' where two names meet."""

    source: Vertex
    target: Vertex
    strength: str
    node: str = ""
    path: tuple[Place, ...] = ()
    assumed: bool = False


@final
class FlowGraph:
    """All vertices (each once, sorted) with the edges that leave and reach them, in the order of the nodes."""

    def __init__(self, edges: Iterable[Edge]) -> None:
        self.out: dict[Vertex, list[Edge]] = {}
        self.into: dict[Vertex, list[Edge]] = {}
        for edge in edges:
            self.out.setdefault(edge.source, []).append(edge)
            self.into.setdefault(edge.target, []).append(edge)
        self.vertices: Final = tuple(sorted({*self.out, *self.into}))


def graph_of(nodes: Iterable[Node]) -> FlowGraph:
    """The graph of these nodes; of one whose flows are not known, each output may hold each input."""
    edges = dict.fromkeys(edge for node in nodes for edge in _inside(node))
    vertices = dict.fromkeys(v for e in edges for v in (e.source, e.target))
    told = dict.fromkeys(edge for vertex in vertices for edge in _told(vertex))
    vertices |= dict.fromkeys(edge.target for edge in told)
    return FlowGraph([*edges, *told, *_meetings(list(vertices))])


def _inside(node: Node) -> Iterator[Edge]:
    flows = flows_of(node)
    for sink in (*flows.sinks, *flows.released):
        inner = sink in flows.released
        target = (arrived if inner else sent)(sink.sink, node.display_name)
        paths = dict(sink.paths)
        for strength in STRENGTHS:
            for source in sink.of(strength):
                path = paths.get(source, ()) or (sink.at,)
                assumed = source in sink.assumed
                yield Edge(arrived(source, node.display_name), target, strength, node.display_name, path, assumed)


def sent(end: End, node: str) -> Vertex:
    """What a sink of a node is in the graph."""
    return Vertex(end, "" if end.kind in SHARED else node, "sent")


def arrived(end: End, node: str) -> Vertex:
    """What a source of a node is in the graph."""
    if end.kind == "service":
        return Vertex(End("request", end.name))
    return Vertex(end, "" if end.kind in SHARED else node)


def _told(vertex: Vertex) -> Iterator[Edge]:
    """The client library publishes the parameters of a node when they change, and answers who asks for them."""
    if vertex.end.kind == "parameter" and vertex.side == "in":
        for end in (End("topic", _PARAMETER_EVENTS), End("response", f"{vertex.node}/get_parameters")):
            yield Edge(vertex, Vertex(end, "", "sent"), "data", vertex.node)


@final
class Arrivals:
    """Where content arrives, by its kind and name."""

    def __init__(self, vertices: Iterable[Vertex]) -> None:
        self._arriving: dict[str, dict[str, Vertex]] = {}
        for vertex in vertices:
            if vertex.side == "in" and vertex.end.kind in SHARED:
                self._arriving.setdefault(vertex.end.kind, {})[vertex.end.name] = vertex

    def of(self, end: End) -> Iterator[Vertex]:
        """What is sent arrives under each name that may be the same; log calls at /rosout."""
        for kind, name in _as(end):
            yield from _meeting(name, self._arriving.get(kind, {}))


def _meetings(vertices: list[Vertex]) -> Iterator[Edge]:
    """What is sent arrives; parameters where somebody may set them."""
    arrivals = Arrivals(vertices)
    for vertex in vertices:
        if vertex.side == "sent":
            yield from (Edge(vertex, other, "data") for other in arrivals.of(vertex.end))
        elif vertex.end.kind == "parameter":
            for setter in _SETTERS:
                request = Vertex(End("request", f"{vertex.node}/{setter}"), "", "sent")
                yield Edge(request, vertex, "data")


def _as(end: End) -> Iterator[tuple[str, str]]:
    """The kinds and names under which something that is sent may arrive."""
    if end.kind == "log":
        yield "topic", _ROSOUT
    elif end.kind == "tf":
        yield "tf", ""
        yield from (("topic", name) for name in _TF)
    elif end.kind in SHARED:
        yield end.kind, end.name
        if end.kind == "topic" and any(may_meet(end.name, name) for name in _TF):
            yield "tf", ""


def _meeting(name: str, arriving: dict[str, Vertex]) -> Iterator[Vertex]:
    if name in arriving:
        yield arriving[name]
    for other, vertex in arriving.items():
        if other != name and ("*" in name or "*" in other) and may_meet(name, other):
            yield vertex
