# SPDX-License-Identifier: Apache-2.0
"""What reaches what, and how: the strongest way first, then the surest, then the shortest.

A way is as strong as its weakest step: what only decides the content of a topic decides all that is made of it.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Collection, Iterable, Iterator

from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.records import NamedTuple
from rosward.ros.flows import STRENGTHS

Passing = Callable[[Edge], bool]
"""Whether information may take an edge."""


class Reached(NamedTuple):
    """How a vertex is reached from, or reaches, the others: the strength of the best way, whether it is assumed, and its first edge."""

    strength: str
    assumed: bool
    by: Edge | None
    steps: int


def downstream(graph: FlowGraph, starts: Iterable[Vertex], passing: Passing) -> dict[Vertex, Reached]:
    """All that these reach; `by` is the edge by which each is reached."""
    return _search(starts, lambda v: graph.out.get(v, ()), lambda e: e.target, passing)


def upstream(graph: FlowGraph, ends: Iterable[Vertex], passing: Passing) -> dict[Vertex, Reached]:
    """All that reaches these; `by` is the edge by which each begins."""
    return _search(ends, lambda v: graph.into.get(v, ()), lambda e: e.source, passing)


def _search(
    starts: Iterable[Vertex],
    edges: Callable[[Vertex], Collection[Edge]],
    further: Callable[[Edge], Vertex],
    passing: Passing,
) -> dict[Vertex, Reached]:
    found: dict[Vertex, Reached] = {}
    queue: list[tuple[int, bool, int, Vertex, int]] = []
    entering: list[Edge | None] = [None]
    for start in sorted(set(starts)):
        heapq.heappush(queue, (0, False, 0, start, 0))
    while queue:
        rank, assumed, steps, vertex, number = heapq.heappop(queue)
        if vertex in found:
            continue
        found[vertex] = Reached(STRENGTHS[rank], assumed, entering[number], steps)
        for edge in edges(vertex):
            target = further(edge)
            if target not in found and passing(edge):
                entering.append(edge)
                weaker = max(rank, STRENGTHS.index(edge.strength))
                heapq.heappush(queue, (weaker, assumed or edge.assumed, steps + 1, target, len(entering) - 1))
    return found


def way_to(found: dict[Vertex, Reached], vertex: Vertex) -> list[Edge]:
    """The edges of the best way to a vertex, from its beginning, as `downstream` found it."""
    way: list[Edge] = []
    edge = found[vertex].by
    while edge is not None:
        way.append(edge)
        edge = found[edge.source].by
    return way[::-1]


def way_from(found: dict[Vertex, Reached], vertex: Vertex) -> list[Edge]:
    """The edges of the best way from a vertex to its end, as `upstream` found it."""
    way: list[Edge] = []
    edge = found[vertex].by
    while edge is not None:
        way.append(edge)
        edge = found[edge.target].by
    return way


def at_least(strength: str) -> Passing:
    """Edges that are so strong, or stronger."""
    wanted = STRENGTHS[: STRENGTHS.index(strength) + 1]
    return lambda edge: edge.strength in wanted


def in_order(found: dict[Vertex, Reached]) -> Iterator[tuple[Vertex, Reached]]:
    """The strongest first."""
    yield from sorted(found.items(), key=lambda item: (STRENGTHS.index(item[1].strength), item[1].assumed, item[0]))
