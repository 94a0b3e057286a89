# SPDX-License-Identifier: Apache-2.0
"""How do nodes, topics, services and actions look in a graph of Graphviz, and how is a text written in it?"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind
from rosward.safe import encodable, printable

__all__ = ["HEADER", "LOOKS", "TOWARDS_NODE", "UNKNOWN", "Drawing", "Look", "escaped", "label_of", "quoted"]


class Look(NamedTuple):
    """How a kind of thing looks."""

    shape: str
    fill: str
    line: str


LOOKS: Final = {
    "node": Look("ellipse", "#d9ecf8", "#0072b2"),
    "topic": Look("box", "#fcefd2", "#b07800"),
    "service": Look("hexagon", "#d5f0e6", "#00805c"),
    "action": Look("folder", "#f6e2ee", "#a8457e"),
}
UNKNOWN: Final = Look("ellipse", "#e4e4e0", "#6b6b65")
"""A node of unknown interface."""
HEADER: Final = (
    "graph [rankdir=LR, ranksep=0.7, nodesep=0.16, fontname=Arial, fontsize=12, compound=true, bgcolor=white, pad=0.2]",
    'node [fontname=Arial, fontsize=11, style=filled, penwidth=1.2, margin="0.1,0.04", height=0.3]',
    "edge [fontname=Arial, fontsize=9, arrowsize=0.6, penwidth=1.1]",
)
TOWARDS_NODE: Final = (EntityKind.SUBSCRIPTION, EntityKind.SERVICE_SERVER, EntityKind.ACTION_SERVER)
"""What data or requests flow to."""


class Drawing(NamedTuple):
    """The text of a graph, and how large it is; `steps` are the layers that its edges cross (`layers.py`).

    `shapes` is the text without its caption: no caption makes a drawing smaller.
    """

    text: str
    vertices: int
    edges: int
    steps: int
    shapes: str


def label_of(lines: Iterable[str]) -> str:
    """A label of these lines."""
    return '"' + r"\n".join(escaped(line) for line in lines) + '"'


def quoted(text: str) -> str:
    """A quoted string."""
    return f'"{escaped(text)}"'


def escaped(text: str) -> str:
    """As the inside of a quoted string: Graphviz reads backslashes, and entities of HTML, in all that it shows."""
    return encodable(printable(text)).replace("\\", "\\\\").replace("&", "&amp;").replace('"', '\\"')
