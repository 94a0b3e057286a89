# SPDX-License-Identifier: Apache-2.0
"""Which sources and sinks does a word mean?

/cmd_vel              the topic, service or action of that name
/camera/**            all names below it; * stands for any text without a slash
service:/set_mode     of that kind only
network               all that goes to, or comes from, sockets and the like
device:*              any device
parameter:max_speed   of any node
node:/planner         all that this node sends or receives
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

from rosward.influence.graph import Vertex
from rosward.network.holes import may_be, may_meet

OUTSIDE: Final = (
    *("argv", "clock", "device", "env", "file", "log", "network", "process", "random", "stdin", "stdout", "tf"),
)
"""Kinds that have no names in the system."""
NAMED: Final = ("topic", "request", "response", "goal", "feedback", "result", "parameter")
_ALSO: Final = {
    "service": ("request", "response"),
    "action": ("goal", "feedback", "result"),
}
KINDS: Final = tuple(sorted((*OUTSIDE, *NAMED, *_ALSO, "node")))
"""The words that may stand before a colon."""


class Selection:
    """What one word of a rule, or of the command line, means."""

    def __init__(self, word: str) -> None:
        self.word = word
        kind, colon, name = word.partition(":")
        if not colon and word in OUTSIDE:
            kind, name = word, "**"
        elif not colon or kind not in KINDS:
            kind, name = "", word
        self.kind = kind
        self._name = name
        self._segments = re.sub(r"\*{3,}", "**", name).split("/")

    @property
    def node(self) -> bool:
        """Whether it means nodes."""
        return self.kind == "node"

    def means(self, vertex: Vertex) -> bool:
        """Whether it means this source or sink."""
        end = vertex.end
        if self.kind == "node":
            return vertex.node != "" and self.fits(vertex.node)
        if not self.kind:
            return end.kind in NAMED and end.kind != "parameter" and self.fits(end.name)
        if end.kind not in (self.kind, *_ALSO.get(self.kind, ())):
            return False
        return end.kind in OUTSIDE or self.fits(end.name)

    def fits(self, name: str) -> bool:
        """Whether a name, which may have holes, may be meant."""
        if "*" in name:
            return may_meet(name, re.sub(r"\*+", "*", self._name))
        return _fits(name.split("/"), self._segments)


def _fits(name: list[str], pattern: list[str]) -> bool:
    """Segment by segment; `**` takes any number of them."""
    reachable = {0}
    for part in pattern:
        if part == "**":
            reachable = set(range(min(reachable, default=len(name) + 1), len(name) + 1))
        else:
            wanted = part.replace("**", "*")
            reachable = {at + 1 for at in reachable if at < len(name) and may_be(name[at], wanted)}
    return len(name) in reachable


def beginnings(vertices: Iterable[Vertex]) -> list[Vertex]:
    """Those where a flow begins: what is sent under a name of which a part is not known begins where it arrives, under each name by itself."""
    return [v for v in vertices if v.side == "in" or "*" not in v.end.name]


def meant(selections: Iterable[Selection], vertices: Iterable[Vertex]) -> list[Vertex]:
    """All vertices that one of them means."""
    wanted = list(selections)
    return [v for v in vertices if any(s.means(v) for s in wanted)]
