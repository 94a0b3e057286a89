# SPDX-License-Identifier: Apache-2.0
"""What does the report know of information flow? What each output of each node is made of, and which content is the same under two names.

    /relay   topic:/scan -> topic:/out   relay.py:12 to relay.py:20
      ->  {"contents": [{"kind": "topic", "name": "/out", "side": "sent", …}, …], "places": [["relay.py", 12], …],
           "nodes": [{"node": "n0", …, "outputs": [{"content": 0, "place": 1, "sources": [[1, 0, 0, [0, 1]]]}]}], "meets": [[0, 2]]}

Everything that is told more than once is a number: of a content, of a place, of a strength (0 data, 1 control, 2 trigger). Steps across the system
are not in it: the page follows the sources of each output, and `meets`, as far as somebody asks.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple, final

from rosward.influence.declared import flows_of
from rosward.influence.graph import FlowGraph, Vertex, arrived, graph_of, sent
from rosward.location import Place
from rosward.outputs.report.numbered import Member, Numbered
from rosward.ros.flows import STRENGTHS, End, NodeSink

__all__ = ["NO_FLOWS", "Flows", "flows"]

_MEETING: Final = {
    "topic": "topic",
    "request": "service",
    "response": "service",
    "goal": "action",
    "feedback": "action",
    "result": "action",
}
"""Where content that nodes share is drawn."""
_TOPICS: Final = {"tf": ("/tf", "/tf_static"), "log": ("/rosout",)}
"""Content that is drawn as topics of other names."""


class Flows(NamedTuple):
    """The rows of the document, and the places that they name."""

    rows: dict[str, object]
    places: tuple[Place, ...]


NO_FLOWS: Final = Flows({}, ())


def flows(numbers: Numbered) -> Flows:
    """The flows of all nodes of a network."""
    table = _Table(numbers)
    nodes = [_node(member, table) for member in numbers.members]
    graph = graph_of(member.node for member in numbers.members)
    meets = sorted(_meets(graph, table))
    rows: dict[str, object] = {
        "contents": table.contents,
        "places": [[place.file, place.line] for place in table.places],
        "nodes": [node for node in nodes if node["outputs"] or not node["complete"]],
        "meets": meets,
    }
    return Flows(rows, tuple(table.places))


@final
class _Table:
    """The numbers of contents and places, in the order in which they are first named."""

    def __init__(self, numbers: Numbered) -> None:
        self.contents: list[dict[str, object]] = []
        self.places: dict[Place, int] = {}
        self.vertices: dict[Vertex, int] = {}
        self._endpoints = {(endpoint.word, endpoint.name): endpoint.id for endpoint in numbers.endpoints}
        self._nodes: dict[str, str] = {}
        for member in numbers.members:
            self._nodes.setdefault(member.node.display_name, member.id)

    def content(self, vertex: Vertex) -> int:
        """The number of a content."""
        number = self.vertices.get(vertex)
        if number is None:
            number = self.vertices[vertex] = len(self.contents)
            self.contents.append(
                {
                    "kind": vertex.end.kind,
                    "name": vertex.end.name,
                    "side": vertex.side,
                    "node": self._nodes.get(vertex.node),
                    "endpoints": self._drawn(vertex.end),
                }
            )
        return number

    def place(self, place: Place) -> int:
        """The number of a file and line."""
        return self.places.setdefault(Place(place.file, place.line), len(self.places))

    def _drawn(self, end: End) -> list[str]:
        names = _TOPICS.get(end.kind, (end.name,))
        word = _MEETING.get(end.kind, "topic" if end.kind in _TOPICS else "")
        return [self._endpoints[word, name] for name in names if (word, name) in self._endpoints]


def _node(member: Member, table: _Table) -> dict[str, object]:
    found, name = flows_of(member.node), member.node.display_name
    outputs = [_output(sink, sent(sink.sink, name), name, table) for sink in found.sinks]
    released = [_output(sink, arrived(sink.sink, name), name, table) for sink in found.released]
    return {
        "node": member.id,
        "followed": member.node.flows is not None,
        "complete": found.complete,
        "outputs": [*outputs, *released],
    }


def _output(sink: NodeSink, content: Vertex, node: str, table: _Table) -> dict[str, object]:
    paths, assumed = dict(sink.paths), frozenset(sink.assumed)
    return {
        "content": table.content(content),
        "place": table.place(sink.at),
        "sources": [
            [
                table.content(arrived(source, node)),
                strength,
                int(source in assumed),
                _lines(paths.get(source, ()), table),
            ]
            for strength, word in enumerate(STRENGTHS)
            for source in sink.of(word)
        ],
    }


def _lines(path: Iterable[Place], table: _Table) -> list[int]:
    return list(dict.fromkeys(table.place(place) for place in path if place.file))


def _meets(graph: FlowGraph, table: _Table) -> Iterator[list[int]]:
    """What some node sends, and as what it arrives where some node reads it."""
    for vertex, number in list(table.vertices.items()):
        for edge in graph.out.get(vertex, ()):
            if not edge.node and edge.target in table.vertices:
                yield [number, table.vertices[edge.target]]
