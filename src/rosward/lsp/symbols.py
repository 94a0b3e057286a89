# SPDX-License-Identifier: Apache-2.0
"""Which names of the graph stand in a file, which are there at all, and how many are at each?

symbols_in(state, "/ws/talker.py")       topic /chatter, publisher std_msgs/msg/String · node /talker · parameter rate
lenses(state, "/ws/talker.py")           above `create_publisher`: /chatter: 1 publisher, 2 subscriptions
"""

from __future__ import annotations

from typing import Final, NamedTuple

from rosward.location import Place
from rosward.lsp.extents import Extent, column_of, extent
from rosward.lsp.links import Aim, place_aim
from rosward.lsp.marks import Mark, Marks, meeting, plural
from rosward.lsp.records import End, Seen, Setting, Started
from rosward.lsp.state import State

__all__ = ["Lens", "Symbol", "lenses", "symbols_in", "symbols_named"]

_MOST: Final = 1_000
_MOST_NAMES: Final = 3


class Symbol(NamedTuple):
    """Something that has a name: node, topic, service, action or parameter, or `started` by a launch file."""

    kind: str
    name: str
    detail: str
    extent: Extent


class Lens(NamedTuple):
    """What is shown above a line, and where one can go from there."""

    title: str
    extent: Extent
    aims: tuple[Aim, ...]


def symbols_in(state: State, path: str) -> list[Symbol]:
    """The symbols of a file, as they stand in it."""
    lines = state.lines(path)
    found: dict[Symbol, None] = {}
    known: dict[Place, Extent] = {}
    for _, mark, place in state.in_file(path):
        if place not in known:
            known[place] = extent(lines, path, place.line - 1, column_of(lines, path, place))
        if 0 < place.line <= len(lines):
            found[_symbol(mark, known[place])] = None
    return sorted(found, key=lambda s: (s.extent, s.kind, s.name))[:_MOST]


def symbols_named(state: State, query: str) -> list[tuple[str, Symbol]]:
    """The symbols of all folders whose name holds a text, whatever its case, and the file of each."""
    wanted = query.casefold()
    found: dict[tuple[str, Symbol], None] = {}
    for folder in state.folders.values():
        for marks in folder.views():
            for file, inside in marks.at.items():
                for mark in inside:
                    symbol = _symbol(mark, _line(mark.place))
                    if wanted in symbol.name.casefold():
                        found[folder.path(file), symbol] = None
            if len(found) > _MOST:
                break
    return sorted(found, key=lambda each: (each[1].name, each[1].kind, each[0], each[1].extent))[:_MOST]


def _line(place: Place) -> Extent:
    line = max(0, place.line - 1)
    return Extent(line, 0, line, 0)


def _symbol(mark: Mark, where: Extent) -> Symbol:
    what = mark.what
    if isinstance(what, End):
        return Symbol(meeting(what), what.name, f"{what.kind} {what.type or ''}".rstrip(), where)
    if isinstance(what, Setting):
        return Symbol("parameter", what.name, what.type or "", where)
    if isinstance(what, Started):
        return Symbol("started", what.label, what.program, where)
    return Symbol("node", what.name, what.process, where)


def lenses(state: State, path: str) -> list[Lens]:
    """The counts above each call that makes an endpoint, and above what a launch file starts."""
    folder = state.folder_of(path)
    if folder is None:
        return []
    launched = {id(marks) for marks in folder.launched}
    by_line: dict[int, list[tuple[Marks, Mark]]] = {}
    apart: dict[int, list[tuple[Marks, Mark]]] = {}
    for based, mark, place in state.in_file(path):
        if isinstance(mark.what, (End, Started)) and place.line > 0:
            chosen = by_line if id(based.marks) in launched else apart
            chosen.setdefault(place.line - 1, []).append((based.marks, mark))
    found: list[Lens] = []
    for line in sorted({*by_line, *apart}):
        told = by_line.get(line) or apart[line]  # what no launch file starts is counted among the sources
        titles: list[str] = []
        targets: dict[Aim, None] = {}
        for name, kind in dict.fromkeys((m.what.name, meeting(m.what)) for _, m in told if isinstance(m.what, End)):
            ends = [e for marks in dict.fromkeys(m for m, _ in told) for e in marks.meeting(name, kind)]
            titles.append(f"{name}: {_counted(ends)}")
            targets.update(
                dict.fromkeys(
                    place_aim(state, folder, p) for e in ends if isinstance(e.what, End) for p in e.what.places
                )
            )
        if not titles:
            titles, starts = _of_started(told)
            targets.update(dict.fromkeys(place_aim(state, folder, node.place) for node in starts))
        if titles:
            more = f" · and {len(titles) - _MOST_NAMES} more" if len(titles) > _MOST_NAMES else ""
            found.append(Lens(" · ".join(titles[:_MOST_NAMES]) + more, Extent(line, 0, line, 0), tuple(targets)))
    return found


def _counted(ends: list[Mark]) -> str:
    """How many different endpoints there are of each kind."""
    found: dict[str, set[tuple[str, tuple[Place, ...]]]] = {}
    for mark in ends:
        if isinstance(mark.what, End) and mark.node is not None:
            found.setdefault(mark.what.kind, set()).add((mark.node.fqn, mark.what.places))
    return ", ".join(plural(len(each), kind) for kind, each in sorted(found.items()))


def _of_started(told: list[tuple[Marks, Mark]]) -> tuple[list[str], list[Seen]]:
    nodes = [n for marks, m in told if isinstance(m.what, Started) for n in marks.nodes_at(m.what.place)]
    titles = [f"{node.name}: {plural(len(node.ends), 'endpoint')}" for node in nodes]
    return list(dict.fromkeys(titles)), nodes
