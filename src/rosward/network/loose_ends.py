# SPDX-License-Identifier: Apache-2.0
"""What has only one end? Topics that nobody publishes (RW331) or subscribes to (RW332), services and actions without a server (RW333, RW334).

    mapper: subscription /scan, and no publisher of /scan anywhere   ->   RW331 topic /scan: subscription in /mapper, and no publisher

It need not be a mistake: the other end may be a tool, or a program that is not analysed. So these are notes, for who asks for them.
Where a partly known name (`/robot_*/scan`) may be the other end, there is no finding. Where a name that is not known at all, or a node of
unknown interface, may be it, the message says so. What the client library makes needs no other end, and can be one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.findings import Finding
from rosward.network.ends import End, Meeting, listed_names, meetings
from rosward.network.graph import Network
from rosward.network.holes import NameIndex
from rosward.records import NamedTuple
from rosward.ros.entities import Node, Resolution

__all__ = ["LOOSE_ENDS", "loose_ends"]

LOOSE_ENDS: Final = frozenset({"RW331", "RW332", "RW333", "RW334"})
"""The codes of loose ends."""

_FROM_OUTSIDE: Final = frozenset({"/clock"})
"""Topics that a simulator or the player of a recording publishes."""

_TO_OUTSIDE: Final = frozenset(
    {"/tf", "/tf_static", "/diagnostics", "/diagnostics_agg", "/rosout", "/parameter_events"}
)
"""Topics that are there for the tools of ROS: rviz, rqt, recorders."""

_WITHOUT_SOURCE: Final = {
    "topic": ("RW331", "publisher"),
    "service": ("RW333", "server"),
    "action": ("RW334", "server"),
}


class _Side(NamedTuple):
    """All ends on one side of the topics, services or actions: their names, and those whose name is not known."""

    names: NameIndex
    nameless: tuple[End, ...]


def loose_ends(network: Network) -> list[Finding]:
    """The findings, in the order of the network."""
    unknown = _of_unknown_interface(network)
    found: list[Finding] = []
    for word in ("topic", "service", "action"):
        all_of = meetings(network.nodes, (word,))
        sources = _side(m.sources for m in all_of)
        sinks = _side(m.sinks for m in all_of)
        for meeting in all_of:
            found += _lacking_source(meeting, sources, unknown)
            found += _lacking_sink(meeting, sinks, unknown) if word == "topic" else ()
    return found


def _lacking_source(meeting: Meeting, sources: _Side, unknown: list[Node]) -> Iterator[Finding]:
    if not meeting.sources and meeting.name not in _FROM_OUTSIDE:
        code, other = _WITHOUT_SOURCE[meeting.word]
        yield from _finding(code, meeting, meeting.sinks, other, sources, unknown)


def _lacking_sink(meeting: Meeting, sinks: _Side, unknown: list[Node]) -> Iterator[Finding]:
    if not meeting.sinks and meeting.name not in _TO_OUTSIDE:
        yield from _finding("RW332", meeting, meeting.sources, "subscription", sinks, unknown)


def _finding(
    code: str, meeting: Meeting, ends: tuple[End, ...], other: str, side: _Side, unknown: list[Node]
) -> Iterator[Finding]:
    own = [e for e in ends if not e.entity.system and e.entity.resolution is not Resolution.UNKNOWN]
    if not own or side.names.meet(meeting.name):
        return
    types = {e.entity.type for e in own}
    nameless = [e.node.fqn for e in side.nameless if None in types or e.entity.type is None or e.entity.type in types]
    kind = own[0].entity.kind.value
    message = f"{meeting.word} {meeting.name}: {kind} in {listed_names(e.node.fqn for e in own)}, but no {other}"
    maybe = [f"one of unknown name in {listed_names(nameless)} may match"] if nameless else []
    maybe += [f"{listed_names(n.fqn for n in unknown)}, whose interface is unknown, may have it"] if unknown else []
    message += f" that is known; {'; '.join(maybe)}" if maybe else ""
    yield Finding(code, message, own[0].place)


def _side(ends: Iterable[tuple[End, ...]]) -> _Side:
    everything = [end for some in ends for end in some]
    nameless = tuple(e for e in everything if e.entity.resolution is Resolution.UNKNOWN and not e.entity.system)
    names = (e.entity.name for e in everything if e.entity.system or e.entity.resolution is not Resolution.UNKNOWN)
    return _Side(NameIndex(names), nameless)


def _of_unknown_interface(network: Network) -> list[Node]:
    places = {finding.place for finding in network.findings if finding.code == "RW314"}
    return [node for node in network.nodes if node.defined_at in places or node.launched_by in places]
