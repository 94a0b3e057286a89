# SPDX-License-Identifier: Apache-2.0
"""Which output of which node arrives at which input of which other one?"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.influence.declared import flows_of
from rosward.influence.graph import FlowGraph, Vertex, arrived, sent
from rosward.records import NamedTuple
from rosward.ros.entities import Node
from rosward.ros.flows import STRENGTHS, End


class Link(NamedTuple):
    """What a node sends, and as what it arrives."""

    sender: str
    sink: End
    receiver: str
    source: End


def links_of(nodes: Iterable[Node], graph: FlowGraph) -> list[Link]:
    """All links, sorted."""
    known = list(nodes)
    receivers: dict[Vertex, dict[tuple[str, End], None]] = {}
    senders: dict[Vertex, dict[tuple[str, End], None]] = {}
    for node in known:
        for sink in flows_of(node).sinks:
            senders.setdefault(sent(sink.sink, node.display_name), {})[(node.display_name, sink.sink)] = None
            for strength in STRENGTHS:
                for source in sink.of(strength):
                    vertex = arrived(source, node.display_name)
                    receivers.setdefault(vertex, {})[(node.display_name, source)] = None
    return sorted(
        Link(sender, sink, receiver, source)
        for vertex, sending in senders.items()
        for edge in graph.out.get(vertex, ())
        for sender, sink in sending
        for receiver, source in receivers.get(edge.target, ())
    )
