# SPDX-License-Identifier: Apache-2.0
"""What do texts of `ros2 node info` say, of one node or of several, one after another?

    /talker
      Subscribers:

      Publishers:
        /chatter: std_msgs/msg/String     ->  LiveNode("/talker", (publisher /chatter of that type,), known={subscription, publisher})

The lines are told apart by what they say, not by their indentation, which is easily lost. A section that is not there is not known, and
hidden names are known only where the text shows one (`--include-hidden`). What stands there beside is told, and nothing is made of it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final, final

from rosward.audit.graph import LiveEntity, LiveGraph, LiveNode, is_hidden, with_actions
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.entities import EntityKind
from rosward.source import limits
from rosward.source.json_fields import UnreadableError

__all__ = ["read_node_info"]

_MOST_ENTITIES: Final = 200_000
_MOST_TOLD: Final = 20

_SECTIONS: Final = {
    "Subscribers": EntityKind.SUBSCRIPTION,
    "Publishers": EntityKind.PUBLISHER,
    "Service Servers": EntityKind.SERVICE_SERVER,
    "Services": EntityKind.SERVICE_SERVER,
    "Service Clients": EntityKind.SERVICE_CLIENT,
    "Action Servers": EntityKind.ACTION_SERVER,
    "Action Clients": EntityKind.ACTION_CLIENT,
}
_NAME: Final = re.compile(r"(?:/\w+)+")
_TYPE: Final = re.compile(r"[\w/]+")
_LONGEST_LINE: Final = 20_000
_SEVERAL: Final = re.compile(r'There are (\d{1,6}) nodes in the graph with the exact name "([\w/]+)"\..*')
_ABSENT: Final = re.compile(r"Unable to find node '(.*)'")


def read_node_info(texts: Mapping[str, str]) -> LiveGraph:
    """What texts say, each by the name of its file. Raises UnreadableError where none of them names a node."""
    reading = _Reading()
    for file, text in texts.items():
        if len(text) > limits.NODE_INFO_TEXT:
            raise UnreadableError(f"{file}: more than {limits.NODE_INFO_TEXT:,} characters")
        reading.read(file, text)
    if not reading.known:
        raise UnreadableError(f"{', '.join(texts)}: not output of ros2 node info: no line is the full name of a node")
    entities = {name: tuple(found) for name, found in reading.entities.items()}
    hidden = any(is_hidden(e.name) for found in entities.values() for e in found)
    nodes = tuple(
        LiveNode(name, with_actions(entities[name]), reading.counts.get(name, 1), 0, frozenset(known), hidden)
        for name, known in sorted(reading.known.items())
    )
    return LiveGraph(nodes, whole=False, source=next(iter(texts)), findings=tuple(reading.findings[:_MOST_TOLD]))


@final
class _Reading:
    """Reads line after line."""

    def __init__(self) -> None:
        self.entities: dict[str, dict[LiveEntity, None]] = {}
        self.known: dict[str, set[EntityKind]] = {}
        self.counts: dict[str, int] = {}
        self.findings: list[Finding] = []
        self._left = _MOST_ENTITIES

    def read(self, file: str, text: str) -> None:
        """Read one text."""
        node: str | None = None
        kind: EntityKind | None = None
        for number, raw in enumerate(text.splitlines(), 1):
            line = raw.strip()
            section = _SECTIONS.get(line.removesuffix(":")) if line.endswith(":") else None
            if not line:
                continue
            if section is not None and node is not None:
                kind = section
                self.known[node].add(section)
            elif len(line) > _LONGEST_LINE:
                self._tell(line, Place(file, number))
            elif _NAME.fullmatch(line):
                node, kind = line, None
                self.known.setdefault(node, set())
                self.entities.setdefault(node, {})
            elif node is not None and kind is not None and (entry := _entry(line)) is not None:
                self._add(node, kind, *entry)
            elif several := _SEVERAL.fullmatch(line):
                self.counts[several[2]] = int(several[1])
            else:
                self._tell(line, Place(file, number))

    def _add(self, node: str, kind: EntityKind, name: str, types: list[str]) -> None:
        for type_ in types:
            self._left -= 1
            if self._left < 0:
                raise UnreadableError(f"there are more than {_MOST_ENTITIES:,} entities")
            self.entities[node][LiveEntity(kind, name, type_)] = None

    def _tell(self, line: str, place: Place) -> None:
        if len(self.findings) == _MOST_TOLD:
            self.findings[-1] = Finding("RW505", "Further lines could not be parsed.", self.findings[-1].place)
        elif len(self.findings) < _MOST_TOLD:
            absent = _ABSENT.fullmatch(line)
            said = f"There was no node {absent[1]}." if absent else f"The line could not be parsed: {line[:100]}"
            self.findings.append(Finding("RW505", said, place))


def _entry(line: str) -> tuple[str, list[str]] | None:
    """Name and types of `/chatter: std_msgs/msg/String, std_msgs/msg/Int32`."""
    name, colon, rest = line.partition(":")
    types = [word for word in rest.strip().split(", ") if word]
    if not colon or not _NAME.fullmatch(name) or not all(map(_TYPE.fullmatch, types)):
        return None
    return name, types
