# SPDX-License-Identifier: Apache-2.0
"""Nodes that were not analysed: each output may hold each input, unless its declaration says better (deployment/declared/flows.py).

Of a node of which nothing is known, any topic may hold any other. Of one of which something unknown got hold, that may send over what
nothing that is known sends over (`machine.userdata.out = self.publisher`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Final

from rosward.ros.entities import Interface, Node
from rosward.ros.flows import STRENGTHS, End, NodeCall, NodeFlows, NodeSink
from rosward.ros.roles import all_to_all

_ANYTHING: Final = End("topic", "/*")


def flows_of(node: Node) -> NodeFlows:
    """The flows of a node, assumed where nobody knows them."""
    if node.flows is not None:
        return _with_unknown_senders(node, node.flows) if node.interface is Interface.PARTIAL else node.flows
    if node.interface is Interface.UNKNOWN:
        anything = NodeSink(_ANYTHING, node.defined_at, data=(_ANYTHING,), assumed=(_ANYTHING,))
        return NodeFlows((anything,), complete=False)
    return NodeFlows(tuple(all_to_all(node, (node,))), complete=False)


def _with_unknown_senders(node: Node, flows: NodeFlows) -> NodeFlows:
    """With the outputs that nothing is known to send over, each of which may hold each input."""
    sent = {sink.sink for sink in flows.sinks}
    assumed = [sink for sink in all_to_all(node, (node,)) if sink.sink not in sent]
    return replace(flows, sinks=(*flows.sinks, *assumed)) if assumed else flows


def unreleased(sink: NodeSink, released: Iterable[NodeSink]) -> NodeSink:
    """An output with what its released sources are made of in their place: what it holds if no function released anything."""
    inner = {each.sink: each for each in released}
    if not inner:
        return sink
    data, control, trigger = _unreleased(sink, inner)
    calls = tuple(NodeCall(call.through, *_unreleased(call, inner)) for call in sink.calls)
    return replace(sink, data=data, control=control, trigger=trigger, calls=calls)


def _unreleased(sink: NodeSink | NodeCall, inner: Mapping[End, NodeSink]) -> tuple[tuple[End, ...], ...]:
    listed: dict[str, set[End]] = {strength: set() for strength in STRENGTHS}
    work = [(end, strength) for strength in STRENGTHS for end in sink.of(strength)]
    seen: set[tuple[End, str]] = set()
    while work:
        end, strength = work.pop()
        if (end, strength) in seen:
            continue
        seen.add((end, strength))
        if end in inner:
            work += [(e, max(strength, s, key=STRENGTHS.index)) for s in STRENGTHS for e in inner[end].of(s)]
        else:
            listed[strength].add(end)
    data, control = listed["data"], listed["control"] - listed["data"]
    trigger = listed["trigger"] - data - control
    return tuple(sorted(data)), tuple(sorted(control)), tuple(sorted(trigger))
