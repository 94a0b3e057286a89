# SPDX-License-Identifier: Apache-2.0
"""What something is made of, and that again, as a tree: each thing's own parts stand once, below the first that is made of it.

/cmd_vel
├─ /plan by /planner
│  └─ /map by /maps
└─ /stop by /planner
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple, final

from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.influence.search import Passing
from rosward.ros.flows import STRENGTHS, End


class Step(NamedTuple):
    """A part of something, by the flow in the node that makes it so. `last`: of its siblings. `above`: its own parts stand there already."""

    edge: Edge
    depth: int
    last: bool
    above: bool


@final
class Tree:
    """What several things are made of; what is told of one is not told again of the next."""

    def __init__(self, graph: FlowGraph, passing: Passing) -> None:
        self._graph = graph
        self._passing = passing
        self._done: set[tuple[End, str]] = set()
        self._known: dict[tuple[End, str], list[Edge]] = {}

    def roots(self, targets: Iterable[Vertex]) -> Iterator[Vertex]:
        """These, each once, whichever sides of it are among them, and without those that stand in the tree by then."""
        for target in sorted(targets, key=lambda v: (v.end, v.node, v.side != "sent")):
            if (target.end, target.node) not in self._done:
                yield target

    def steps(self, target: Vertex) -> Iterator[Step]:
        """Depth first, without recursion, since a system may be as deep as it likes."""
        self._done.add((target.end, target.node))
        work = [iter(_numbered(self._parts(target)))]
        while work:
            left, edge = next(work[-1], (0, None))
            if edge is None:
                work.pop()
                continue
            source = edge.source
            parts = self._parts(source)
            again = (source.end, source.node) in self._done
            yield Step(edge, len(work), not left, above=again and bool(parts))
            if not again:
                self._done.add((source.end, source.node))
                work.append(iter(_numbered(parts)))

    def _parts(self, vertex: Vertex) -> list[Edge]:
        """The flows in nodes that make what is sent or arrives under this name, the strongest of each node and source."""
        found = self._known.get((vertex.end, vertex.node))
        if found is None:
            found = self._known[vertex.end, vertex.node] = self._made_of(vertex)
        return found

    def _made_of(self, vertex: Vertex) -> list[Edge]:
        made: list[Edge] = []
        for side in ("sent", "in"):
            for edge in self._graph.into.get(vertex._replace(side=side), ()):
                made += [edge] if edge.node else [e for e in self._graph.into.get(edge.source, ()) if e.node]
        best: dict[tuple[str, Vertex], Edge] = {}
        for edge in sorted(filter(self._passing, made), key=lambda e: (STRENGTHS.index(e.strength), e.assumed)):
            best.setdefault((edge.node, edge.source), edge)
        return list(best.values())


def _numbered(edges: list[Edge]) -> Iterator[tuple[int, Edge]]:
    """Each with how many follow."""
    yield from ((len(edges) - at, edge) for at, edge in enumerate(edges, 1))
