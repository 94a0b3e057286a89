# SPDX-License-Identifier: Apache-2.0
"""Which literal does the name of an endpoint come from, if it is one?

    create_publisher(String, "chatter", 10)                 the literal in the call, if nothing remaps it
    remappings=[("chatter", "/news")]                       "/news" in the launch file
    create_publisher(String, get_parameter("topic")…)       the value in the parameter file, in the launch file, or the default

Nothing is guessed: where none of these has the name, or two have, a name is made of parts, and there is a reason in place of the literal.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple, final

from rosward.location import Place
from rosward.lsp.extents import Extent, Literal, column_of, extent, literals
from rosward.lsp.marks import Marks
from rosward.lsp.names import expanded, is_for, keys, parameter_of
from rosward.lsp.records import End, Given, Seen, Setting, Started
from rosward.lsp.state import Based, Folder, State

__all__ = ["Hindrance", "Origin", "Origins", "Spot"]


class Spot(NamedTuple):
    """A literal in a file."""

    path: str
    literal: Literal


class Hindrance(NamedTuple):
    """Why a name has no single literal, and where that is seen."""

    why: str
    place: Place


class Origin(NamedTuple):
    """An endpoint of a view, and what its name is written as."""

    marks: Marks
    node: Seen
    end: End
    spots: tuple[Spot, ...]
    hindrance: Hindrance | None
    remapped: tuple[tuple[Spot, Spot | None], ...] = ()
    """Literals in the code that a remapping gives this name, each with what the launch file calls it; None where that is no single literal."""


@final
class Origins:
    """The origins of the names of all endpoints of a folder."""

    def __init__(self, state: State, folder: Folder) -> None:
        self._state = state
        self._folder = folder
        self._literals: dict[tuple[str, Place], list[Literal]] = {}
        self.all = [origin for based in folder.based.values() for origin in self._of_view(based)]
        self.by_name: dict[tuple[int, str, str], list[Origin]] = {}
        self.by_spot: dict[Spot, list[Origin]] = {}
        self.by_code: dict[Spot, list[Origin]] = {}
        for origin in self.all:
            kind = origin.end.kind.partition(" ")[0]
            kind = kind if kind in ("service", "action") else "topic"
            self.by_name.setdefault((id(origin.marks), kind, origin.end.name), []).append(origin)
            for spot in origin.spots:
                self.by_spot.setdefault(spot, []).append(origin)
            for spot, _ in origin.remapped:
                self.by_code.setdefault(spot, []).append(origin)

    def _of_view(self, based: Based) -> Iterator[Origin]:
        for node in based.marks.view.nodes:
            started = based.marks.started(node)
            for end in node.ends:
                yield self._of_end(based, node, started, end)

    def _of_end(self, based: Based, node: Seen, started: Started | None, end: End) -> Origin:
        spots: dict[Spot, None] = {}
        hindrance = None
        if not end.whole:
            hindrance = Hindrance("a part of this name is not known", (end.places or (node.place,))[0])
        for place in end.places or (node.place,):
            found = self._spots(based, node, started, end, place)
            if len(found) == 1:
                spots[found[0]] = None
            elif hindrance is None:
                why = "two literals in this call are this name" if found else "this name is not written as one literal"
                hindrance = Hindrance(why, place)
        remapped = self._remapped(based, node, started, end) if started is not None else ()
        return Origin(based.marks, node, end, tuple(spots), hindrance, tuple(remapped))

    def _remapped(self, based: Based, node: Seen, started: Started, end: End) -> Iterator[tuple[Spot, Spot | None]]:
        launch = self._folder.path(started.place.file)
        for old, new in started.remaps:
            full = expanded(old, node)
            if full is None or full == end.name or expanded(new, node) != end.name:
                continue
            named = [Spot(launch, each) for each in self._in(based, started.place) if _is_from(each, full, node)]
            for place in end.places:
                for each in self._in(based, place):
                    if expanded(each.text, node) == full:
                        yield Spot(self._folder.path(place.file), each), named[0] if len(named) == 1 else None

    def _spots(self, based: Based, node: Seen, started: Started | None, end: End, place: Place) -> list[Spot]:
        def is_name(text: str) -> bool:
            return expanded(text, node) == end.name

        path = self._folder.path(place.file)
        written = [Spot(path, each) for each in self._in(based, place) if is_name(each.text)]
        if written:
            return written
        if started is not None and any(is_name(new) for _, new in started.remaps):
            launch = self._folder.path(started.place.file)
            inside = self._in(based, started.place)
            given = [Spot(launch, each) for each in inside if is_name(each.text) and each.name in ("", "to")]
            if given:
                return given
        return [
            spot
            for setting in node.settings
            if is_name(setting.value)
            for spot in self._set(based, node, started, setting)
        ]

    def _set(self, based: Based, node: Seen, started: Started | None, setting: Setting) -> Iterator[Spot]:
        """Where the value of a parameter is written: by the last that sets it, else as its default."""
        for given in reversed(started.given if started is not None else ()):
            found = list(self._given(based, node, given, setting))
            if found:
                yield from found
                return
        if setting.place is not None and setting.value == setting.default:
            path = self._folder.path(setting.place.file)
            yield from (Spot(path, each) for each in self._in(based, setting.place) if each.text == setting.value)

    def _given(self, based: Based, node: Seen, given: Given, setting: Setting) -> Iterator[Spot]:
        if given.file:
            path = self._folder.path(given.file)
            lines = self._state.lines(path)
            for key in keys(lines):
                about = parameter_of(key)
                if about is not None and about[1] == setting.name and is_for(about[0], node):
                    line = key.extent.line
                    rest = Extent(line, key.extent.end_column, line, len(lines[line]))
                    yield from (Spot(path, each) for each in literals(lines, path, rest) if each.text == setting.value)
        elif given.name == setting.name and given.place is not None:
            path = self._folder.path(given.place.file)
            yield from (Spot(path, each) for each in self._in(based, given.place) if each.text == setting.value)

    def _in(self, based: Based, place: Place) -> list[Literal]:
        """The literals of what begins at a place, in the text as it is now."""
        path = self._folder.path(place.file)
        now = self._state.now(based.texts, path, place)
        if now is None or not now.line:
            return []
        key = path, now
        if key not in self._literals:
            lines = self._state.lines(path)
            where = extent(lines, path, now.line - 1, column_of(lines, path, now))
            self._literals[key] = literals(lines, path, where)
        return self._literals[key]


def _is_from(literal: Literal, full: str, node: Seen) -> bool:
    return literal.name in ("", "from") and expanded(literal.text, node) == full
