# SPDX-License-Identifier: Apache-2.0
"""What has to be edited so that a topic, service or action has another name everywhere? Or what stands in the way, and where.

    talker.py    create_publisher(String, "chatter", 10)        "chatter" -> "news"
    ear.launch.py    remappings=[("input", "/chatter")]         "/chatter" -> "/news"

One literal may make several names (a program that is started twice), and one name has several ends: each literal that is edited renames all that come
from it, and each name that is renamed takes all its ends along, in every view. A name that is not written as a literal, or that two would rename
differently, is a reason to edit nothing at all.
"""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import NamedTuple, final

from rosward.holes import Holed
from rosward.location import Place
from rosward.lsp.extents import Extent
from rosward.lsp.marks import Marks, meeting
from rosward.lsp.names import expanded, literal_at, relative_to
from rosward.lsp.origins import Origin, Origins, Spot
from rosward.lsp.state import Folder, State
from rosward.ros.names import validate_name

__all__ = ["Edit", "RefusedError", "Target", "rename", "renamed_at"]


class RefusedError(Exception):
    """Nothing is renamed; the message says why, and where."""


class Edit(NamedTuple):
    """A piece of a file, and the text that is to stand there."""

    path: str
    extent: Extent
    text: str


class Target(NamedTuple):
    """What would be renamed: a literal."""

    name: str
    extent: Extent


def renamed_at(state: State, path: str, line: int, column: int) -> Target | None:
    """The literal at a position that names something; None where there is none."""
    folder = state.folder_of(path)
    spot = _spot(state, path, line, column)
    if folder is None or spot is None or spot not in Origins(state, folder).by_spot:
        return None
    return Target(spot.literal.text, _extent(spot))


def rename(state: State, path: str, line: int, column: int, new: str) -> list[Edit]:
    """The edits, sorted. Raises RefusedError."""
    folder = state.folder_of(path)
    if folder is None:
        raise RefusedError("this file is in no folder of the workspace")
    reason = validate_name(Holed(new)) if new and "*" not in new else "it is empty or has a *"
    if reason is not None:
        raise RefusedError(f"'{new}' is no name in ROS: {reason}")
    origins = Origins(state, folder)
    spot = _spot(state, path, line, column)
    if spot is None or spot not in origins.by_spot:
        raise RefusedError(_why_not(state, path, line, column))
    return _Renaming(folder, origins).edits(spot, new)


def _why_not(state: State, path: str, line: int, column: int) -> str:
    folder = state.folder_of(path)
    for found in state.at(path, line, column) if folder is not None else ():
        return f"{found.mark.place}: what stands here is no literal that is a name by itself"
    return "no topic, service or action is named here"


def _spot(state: State, path: str, line: int, column: int) -> Spot | None:
    literal = literal_at(state.lines(path), path, line, column)
    return None if literal is None else Spot(path, literal)


def _extent(spot: Spot) -> Extent:
    return Extent(spot.literal.line, spot.literal.column, spot.literal.line, spot.literal.end)


@final
class _Renaming:
    """One renaming: the literals that it edits and the names that it changes grow together until nothing is added."""

    def __init__(self, folder: Folder, origins: Origins) -> None:
        self._folder = folder
        self._origins = origins
        self._texts: dict[Spot, str] = {}
        self._names: dict[tuple[int, str, str], str] = {}
        self._spots: list[Spot] = []
        self._open: list[tuple[Marks, str, str]] = []

    def edits(self, spot: Spot, new: str) -> list[Edit]:
        """All edits that belong to that of one literal."""
        self._edit(spot, new, None)
        while self._spots or self._open:
            if self._spots:
                self._rename_what_comes_from(self._spots.pop())
            else:
                self._take_ends_along(*self._open.pop())
        if all(text == spot.literal.text for spot, text in self._texts.items()):
            raise RefusedError("it has this name already")
        return sorted(Edit(s.path, _extent(s), text) for s, text in self._texts.items() if text != s.literal.text)

    def _edit(self, spot: Spot, text: str, place: Place | None) -> None:
        known = self._texts.setdefault(spot, text)
        if known != text:
            where = place or Place(self._folder.file(spot.path), spot.literal.line + 1)
            raise RefusedError(f"{where}: '{spot.literal.text}' would have to be '{known}' and '{text}' at once")
        if spot not in self._spots and known is text:
            self._spots.append(spot)

    def _rename_what_comes_from(self, spot: Spot) -> None:
        for origin in self._origins.by_spot.get(spot, ()):
            name = expanded(self._texts[spot], origin.node)
            if name is None:
                raise RefusedError(f"{_first(origin)}: '{self._texts[spot]}' is no name for {origin.node.name}")
            self._check(origin, name)
            key = id(origin.marks), meeting(origin.end), origin.end.name
            known = self._names.get(key)
            if known is None:
                self._names[key] = name
                self._open.append((origin.marks, meeting(origin.end), origin.end.name))
            elif known != name:
                raise RefusedError(f"{_first(origin)}: {origin.end.name} would be {known} and {name} at once")

        for origin in self._origins.by_code.get(spot, ()):
            name, started = expanded(self._texts[spot], origin.node), origin.marks.started(origin.node)
            named = next(found for code, found in origin.remapped if code == spot)
            if name is None or named is None:
                place = started.place if started is not None else _first(origin)
                raise RefusedError(f"{place}: '{spot.literal.text}' is remapped here, and not by one literal")
            self._edit(named, relative_to(named.literal.text, name, origin.node), _first(origin))

    def _check(self, origin: Origin, name: str) -> None:
        """Whether the new name would be remapped, or would meet another one that is there."""
        started = origin.marks.started(origin.node)
        for old, _ in started.remaps if started is not None else ():
            if started is not None and expanded(old, origin.node) == name:
                raise RefusedError(f"{started.place}: {name} is remapped here for {origin.node.name}")
        there = self._origins.by_name.get((id(origin.marks), meeting(origin.end), name), ())
        if name != origin.end.name and there:
            raise RefusedError(f"{_first(there[0])}: there is a {meeting(origin.end)} {name} already")

    def _take_ends_along(self, marks: Marks, kind: str, name: str) -> None:
        new = self._names[id(marks), kind, name]
        for other in marks.open:
            if other.node is not None and fnmatchcase(name, other.what.name) and meeting(other.what) == kind:  # type: ignore[union-attr, arg-type]
                raise RefusedError(f"{other.place}: a part of this name is not known, and it may be {name}")
        for origin in self._origins.by_name.get((id(marks), kind, name), ()):
            if origin.hindrance is not None:
                place, why = origin.hindrance.place, origin.hindrance.why
                raise RefusedError(f"{place}: {why} ({origin.end.kind} {name} of {origin.node.name})")
            for spot in origin.spots:
                text = self._texts.get(spot)
                if text is None or expanded(text, origin.node) != new:
                    self._edit(spot, relative_to(spot.literal.text, new, origin.node), _first(origin))


def _first(origin: Origin) -> Place:
    return (origin.end.places or (origin.node.place,))[0]
