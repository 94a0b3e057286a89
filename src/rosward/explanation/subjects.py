# SPDX-License-Identifier: Apache-2.0
"""What in a network does a name that somebody types mean?

    /porter/battery                        the topic of that name
    battery                                every topic, service, action and node whose full name ends in /battery
    RW101                                  the findings of that code
    delivery_base/base_driver              the nodes of that executable, whatever they are called
    base_driver.py:31                      what is created, started or doubted in that line

A full name is taken before an end of one. A full name also means the names with a hole that it may be: `/left/scan` that of `/*/scan`.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable
from typing import Final

from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.network.holes import may_be
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Node
from rosward.rules import RULES

__all__ = ["MeetingPoint", "Subjects", "close_matches", "is_at", "subjects"]

_PLACE: Final = re.compile(r"(.+?):(\d{1,9})(?::\d+)?")


class MeetingPoint(NamedTuple):
    """A topic, service or action, and who has an end of it."""

    word: str
    name: str
    ends: tuple[tuple[Node, Entity], ...]


class Subjects(NamedTuple):
    """All that a name means. `code` and `place` are set where the name is of that form."""

    meetings: tuple[MeetingPoint, ...] = ()
    nodes: tuple[Node, ...] = ()
    enclaves: tuple[str, ...] = ()
    code: str | None = None
    place: tuple[str, int] | None = None


def subjects(network: Network, query: str) -> Subjects:
    """What a name means; empty where it means nothing."""
    if query.upper() in RULES:
        return Subjects(code=query.upper())
    at = _PLACE.fullmatch(query)
    if at is not None:
        return Subjects(place=(at.group(1).removeprefix("./"), int(at.group(2))))
    if query.startswith("/"):
        found = _named(network, lambda name: name == query)
        holes = _named(network, lambda name: "*" in name and name != query and may_be(query, name)).meetings
        found = found._replace(meetings=(*found.meetings, *(m for m in holes if not _unknown(m))))
        if found != Subjects():
            return found
    end = "/" + query.strip("/")
    found = _named(network, lambda name: name.endswith(end)) if end != "/" else Subjects()
    return found if found != Subjects() else Subjects(nodes=tuple(n for n in network.nodes if _program(n) == end[1:]))


def is_at(file: str, line: int, place: tuple[str, int]) -> bool:
    """Whether a file and line are those of a place, which may name the end of the path only."""
    return line == place[1] and (file == place[0] or file.endswith("/" + place[0]))


def close_matches(network: Network, query: str) -> tuple[str, ...]:
    """Names that somebody may have meant, the closest first."""
    names = _all_names(network)
    whole = difflib.get_close_matches(query if query.startswith("/") else "/" + query, names, n=5, cutoff=0.6)
    last: dict[str, list[str]] = {}
    for name in names:
        last.setdefault(name.rpartition("/")[2], []).append(name)
    ends = difflib.get_close_matches(query.rpartition("/")[2], last, n=3, cutoff=0.6)
    return tuple(dict.fromkeys([*whole, *(name for end in ends for name in last[end])]))[:5]


def _all_names(network: Network) -> list[str]:
    own = {e.name for n in network.nodes for e in n.entities if not e.system}
    return sorted(own | {n.display_name for n in network.nodes} | {n.enclave for n in network.nodes})[:20_000]


def _named(network: Network, fits: Callable[[str], bool]) -> Subjects:
    ends = [(n, e) for n in network.nodes for e in n.entities if fits(e.name)]
    own = {(e.kind.meeting, e.name) for _, e in ends if not e.system}
    meetings = _meetings((n, e) for n, e in ends if not own or (e.kind.meeting, e.name) in own)
    nodes = tuple(n for n in network.nodes if fits(n.fqn) or (n.label is not None and fits(f"/{n.label}")))
    paths = enclave_paths(network.nodes)
    places = () if nodes else tuple(dict.fromkeys(p for f, p in sorted(paths.items()) if fits(f) or fits(p)))
    return Subjects(meetings, nodes, places)


def _program(node: Node) -> str:
    return f"{node.package}/{node.executable}"


def _meetings(ends: Iterable[tuple[Node, Entity]]) -> tuple[MeetingPoint, ...]:
    groups: dict[tuple[str, str], list[tuple[Node, Entity]]] = {}
    for node, entity in ends:
        groups.setdefault((entity.name, entity.kind.meeting), []).append((node, entity))
    return tuple(MeetingPoint(word, name, tuple(groups[name, word])) for name, word in sorted(groups))


def _unknown(meeting: MeetingPoint) -> bool:
    """Of such a name nothing is known but perhaps its namespace: it may be any name, so it answers no question."""
    return all(e.name.endswith("/*") for _, e in meeting.ends)
