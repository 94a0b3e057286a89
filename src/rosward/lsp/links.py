# SPDX-License-Identifier: Apache-2.0
"""Who is at the other end of what stands at a position, and where else is the same meant?

publisher      ->  its subscriptions, and back; clients and servers likewise
launch file    ->  the nodes that it starts; a remapping: the endpoints of that name
parameter      ->  the line of the parameter file that sets it, and back
policy         ->  the endpoints that a rule is about
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple

from rosward.location import Place
from rosward.lsp.extents import Extent, column_of, extent
from rosward.lsp.marks import Mark, Marks, meeting
from rosward.lsp.names import is_for, keys, literal_at, parameter_of, policy_name
from rosward.lsp.records import End, Seen, Setting, Started
from rosward.lsp.state import Folder, Found, State

__all__ = ["Aim", "aims", "everywhere", "place_aim"]

_MOST: Final = 500


class Aim(NamedTuple):
    """Somewhere to go to: a whole path and what of the file is meant."""

    path: str
    extent: Extent


def aims(state: State, path: str, line: int, column: int) -> list[Aim]:
    """The other ends."""
    folder = state.folder_of(path)
    if folder is None:
        return []
    named = _named(state, folder, path, line, column)
    if named is not None:
        return _each_once(named)
    return _each_once(aim for found in state.at(path, line, column) for aim in _of(state, folder, found))


def everywhere(state: State, path: str, line: int, column: int) -> list[Aim]:
    """All that bears the same name, this end included."""
    folder = state.folder_of(path)
    if folder is None:
        return []
    named = _named(state, folder, path, line, column)
    if named is not None:
        return _each_once(named)
    found = state.at(path, line, column)

    def each() -> Iterator[Aim]:
        for one in found:
            if isinstance(one.mark.what, End):
                end = one.mark.what
                for mark in one.marks.meeting(end.name, meeting(end)):
                    yield from _places(state, folder, mark)
            else:
                yield place_aim(state, folder, one.mark.place)
                yield from _of(state, folder, one)

    return _each_once(each())


def place_aim(state: State, folder: Folder, place: Place) -> Aim:
    """A place that was found, in the text as it is now."""
    path = folder.path(place.file)
    lines = state.lines(path)
    line = max(0, place.line - 1)
    if line >= len(lines):
        return Aim(path, Extent(line, 0, line, 0))
    column = column_of(lines, path, place)
    whole = extent(lines, path, line, column)
    if whole.end_line > line:  # the first line is enough to see where it is
        whole = Extent(line, column, line, len(lines[line].rstrip()))
    return Aim(path, whole)


def _of(state: State, folder: Folder, found: Found) -> Iterator[Aim]:
    what, marks = found.mark.what, found.marks
    if isinstance(what, End):
        for mark in marks.others(what):
            yield from _places(state, folder, mark)
    elif isinstance(what, Setting) and found.mark.node is not None:
        yield from _given(state, folder, marks, found.mark.node, what)
    elif isinstance(what, Started):
        for node in marks.nodes_at(what.place):
            yield place_aim(state, folder, node.place)
    elif isinstance(what, Seen) and what.launched_by is not None:
        yield place_aim(state, folder, what.launched_by)


def _places(state: State, folder: Folder, mark: Mark) -> Iterator[Aim]:
    if isinstance(mark.what, End):
        for place in mark.what.places or (mark.place,):
            yield place_aim(state, folder, place)


def _given(state: State, folder: Folder, marks: Marks, node: Seen, setting: Setting) -> Iterator[Aim]:
    """Where a launch file or a parameter file sets a parameter."""
    started = marks.started(node)
    if started is None:
        return
    for given in started.given:
        if given.kind != "file" and given.name == setting.name and given.place is not None:
            yield place_aim(state, folder, given.place)
        if given.file:
            path = folder.path(given.file)
            for key in keys(state.lines(path)):
                about = parameter_of(key)
                if about is not None and about[1] == setting.name and is_for(about[0], node):
                    yield Aim(path, key.extent)


def _named(state: State, folder: Folder, path: str, line: int, column: int) -> list[Aim] | None:
    """What a name means that no analysis has a place for; None where there is none here."""
    lines = state.lines(path)
    if path.endswith((".yaml", ".yml")):
        at = next((key for key in keys(lines) if key.extent.holds(line, column)), None)
        about = parameter_of(at) if at is not None else None
        if about is not None:
            return list(_declared(state, folder, path, about))
    if path.endswith(".xml"):
        ruled = policy_name(lines, line, column)
        if ruled is not None:
            return [
                aim
                for marks in folder.views()
                for m in marks.meeting(ruled[1], ruled[0])
                for aim in _places(state, folder, m)
            ]
    literal = literal_at(lines, path, line, column)
    if literal is None:
        return None
    found: list[Aim] = []
    for one in state.at(path, line, column):
        if isinstance(one.mark.what, Started) and any(literal.text in remap for remap in one.mark.what.remaps):
            for node in one.marks.nodes_at(one.mark.what.place):
                new = {new for old, new in one.mark.what.remaps if literal.text in (old, new)}
                for end in node.ends:
                    if any(end.name == each or end.name.endswith(f"/{each.lstrip('~/')}") for each in new):
                        for mark in one.marks.meeting(end.name, meeting(end)):
                            found += _places(state, folder, mark)
    return found or None


def _declared(state: State, folder: Folder, path: str, about: tuple[str, str]) -> Iterator[Aim]:
    """Where the parameters are declared that a key of a parameter file sets."""
    file = folder.file(path)
    for marks in folder.views():
        for node in marks.view.nodes:
            started = marks.started(node)
            if started is not None and any(given.file == file for given in started.given) and is_for(about[0], node):
                for setting in node.settings:
                    if setting.name == about[1] and setting.place is not None:
                        yield place_aim(state, folder, setting.place)


def _each_once(found: Iterable[Aim]) -> list[Aim]:
    return sorted(dict.fromkeys(found), key=lambda aim: (aim.path, aim.extent))[:_MOST]
