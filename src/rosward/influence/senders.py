# SPDX-License-Identifier: Apache-2.0
"""Who may send what, whatever its code sends, and so: which enclaves can influence something?

A policy permits a node to send under the names of its publishers, clients and servers, and DDS knows enclaves only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple, final

from rosward.influence.graph import Arrivals, FlowGraph, Vertex, sent
from rosward.influence.search import Reached
from rosward.network.enclaves import enclave_paths
from rosward.ros.entities import Node
from rosward.ros.flows import STRENGTHS, End
from rosward.ros.roles import SENT

__all__ = ["Influencing", "Senders", "influencing"]


class Influencing(NamedTuple):
    """An enclave that can influence something, how strongly at most, and whether that is only assumed."""

    enclave: str
    strength: str
    assumed: bool


@final
class Senders:
    """At which vertices of a graph is what a node may send?"""

    def __init__(self, graph: FlowGraph) -> None:
        vertices = graph.vertices
        self._arrivals = Arrivals(vertices)
        self._own: dict[str, list[Vertex]] = {}
        for vertex in vertices:
            if vertex.side == "sent":
                self._own.setdefault(vertex.node, []).append(vertex)

    def may_send(self, node: Node) -> Iterator[Vertex]:
        """Under its own names, where these are in the graph or not, and where that arrives; and what it gives to the outside."""
        for entity in node.entities:
            if not entity.system:
                for kind in SENT.get(entity.kind, ()):
                    end = End(kind, entity.name)
                    yield sent(end, node.display_name)
                    yield from self._arrivals.of(end)
        yield from self._own.get(node.display_name, ())


def influencing(nodes: Iterable[Node], graph: FlowGraph, found: Mapping[Vertex, Reached]) -> list[Influencing]:
    """The enclaves that may send some of what `found` reached upstream, sorted."""
    known = list(nodes)
    paths, senders = enclave_paths(known), Senders(graph)
    best: dict[str, tuple[int, bool]] = {}
    for node in known:
        ways = [(STRENGTHS.index(r.strength), r.assumed) for v in senders.may_send(node) if (r := found.get(v))]
        if ways:
            path = paths[node.enclave]
            best[path] = min(best.get(path, ways[0]), *ways)
    return [Influencing(path, STRENGTHS[rank], assumed) for path, (rank, assumed) in sorted(best.items())]
