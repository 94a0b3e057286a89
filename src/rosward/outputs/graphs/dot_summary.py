# SPDX-License-Identifier: Apache-2.0
"""What is there to draw of a system whose every topic would make a picture that nobody can read? The same from further and further away.

nodes alone  ->  one shape for each namespace, the innermost first  ->  /robot1, /robot2 as /robot*  ->  one for each package

Between two shapes there is one edge, for all that goes between them. What joins many with many (`/tf`) is counted in the caption instead.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Final

from rosward.network.graph import Network
from rosward.outputs.graphs.dot_language import HEADER, LOOKS, TOWARDS_NODE, UNKNOWN, Drawing, label_of, quoted
from rosward.outputs.graphs.layers import steps_between_layers
from rosward.ros.entities import Interface, Node, Resolution

__all__ = ["summaries"]

_MOST_EDGES: Final = 3
"""Edges for each shape that takes part in a topic, service or action: what needs more joins everyone with everyone."""

_LONGEST: Final = 60
_NUMBER: Final = re.compile(r"\d+")
_GREY: Final = "#59616b"


def summaries(network: Network, system: bool = False) -> Iterator[Drawing]:
    """Pictures of the network with ever fewer shapes, each from left to right and from top to bottom."""
    for how, group_of in _views(network):
        for direction in ("LR", "TB"):
            yield _drawing(network, group_of, how, direction, system)


def _views(network: Network) -> Iterator[tuple[str, Callable[[Node], str]]]:
    yield "without topics, services and actions", _one_each
    depth = max((node.namespace.count("/") for node in network.nodes if node.namespace != "/"), default=0)
    for most in range(depth, 0, -1):
        yield "by namespace", partial(_namespace, depth=most)
    yield "by namespace, similar ones grouped", lambda node: _NUMBER.sub("*", _namespace(node, 1))
    yield "by package", lambda node: node.package or "unknown package"


def _one_each(node: Node) -> str:
    return node.display_name


def _namespace(node: Node, depth: int) -> str:
    """The first parts of its namespace; what is in none stands for itself."""
    return node.display_name if node.namespace == "/" else "/".join(node.namespace.split("/")[: depth + 1]) + "/"


def _drawing(network: Network, group_of: Callable[[Node], str], how: str, direction: str, system: bool) -> Drawing:
    groups = Counter(group_of(node) for node in network.nodes)
    alone = {group_of(node): node for node in network.nodes if groups[group_of(node)] == 1}
    edges, crowds = _edges(network, group_of, system)
    lines = [_shape(group, number, alone) for group, number in sorted(groups.items())]
    lines += [_edge(*ends, looks) for ends, looks in sorted(edges.items())]
    caption = [f"{len(network.nodes)} nodes, {how}. See graph.dot, report.html or network.json for everything."]
    if crowds:
        caption.append(f"Omitted: {crowds} that connect{'s' if crowds == 1 else ''} many nodes with many.")
    header = (*HEADER, f"graph [label={label_of(caption)}, labelloc=b, rankdir={direction}]")
    text = "\n".join(["digraph rosward {", *(f"  {line};" for line in (*header, *lines)), "}"]) + "\n"
    shapes = "\n".join((direction, str(len(caption)), *lines))
    return Drawing(text, len(groups), len(edges), steps_between_layers(edges), shapes)


def _edges(
    network: Network, group_of: Callable[[Node], str], system: bool
) -> tuple[Mapping[tuple[str, str], set[str]], int]:
    """From tail and head to the kinds of what goes between them, and how many join too many."""
    sides: dict[tuple[str, str], tuple[set[str], set[str]]] = {}
    for node in network.nodes:
        for entity in node.entities:
            if (system or not entity.system) and entity.resolution is not Resolution.UNKNOWN:
                both = sides.setdefault((entity.kind.meeting, entity.name), (set(), set()))
                both[entity.kind in TOWARDS_NODE].add(group_of(node))
    edges: dict[tuple[str, str], set[str]] = {}
    crowds = 0
    for (look, _), (tails, heads) in sides.items():
        if len(tails) * len(heads) > _MOST_EDGES * (len(tails) + len(heads)):
            crowds += 1
            continue
        for tail in tails:
            for head in heads - {tail}:
                edges.setdefault((tail, head), set()).add(look)
    return edges, crowds


def _shape(group: str, number: int, alone: Mapping[str, Node]) -> str:
    if number == 1:
        node = alone[group]
        known = node.interface is not Interface.UNKNOWN
        look = LOOKS["node"] if known else UNKNOWN
        looks = f'shape={look.shape}, fillcolor="{look.fill}", color="{look.line}", class="ros-node"'
        label = [_shortened(node.display_name), *([] if known else ["unknown"])]
        return f"{quoted(group)} [label={label_of(label)}, {looks}]"
    box = 'shape=box, style="rounded,filled", peripheries=2, margin="0.2,0.04"'  # a wider font still stays inside
    looks = f'{box}, fillcolor="#e8ebef", color="{_GREY}", class="ros-group"'
    return f"{quoted(group)} [label={label_of([_shortened(group), f'{number} nodes'])}, {looks}]"


def _shortened(name: str) -> str:
    """The beginning and the end of a long name tell more than its middle."""
    return name if len(name) <= _LONGEST else f"{name[: _LONGEST // 3]}…{name[-_LONGEST * 2 // 3 :]}"


def _edge(tail: str, head: str, looks: set[str]) -> str:
    (look, *more) = sorted(looks)
    colour, kind = (_GREY, "mixed") if more else (LOOKS[look].line, look)
    return f'{quoted(tail)} -> {quoted(head)} [color="{colour}", class="of-{kind}"]'
