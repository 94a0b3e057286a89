# SPDX-License-Identifier: Apache-2.0
"""What does the server know? The open documents, and of each folder the last views; where something stands now that was found in an older text.

state.open("/ws/talker.py", "…")
state.folder("/ws").take(view, texts)          texts: of the open files, as they were when the view was made
state.at("/ws/talker.py", 12, 30)              the marks whose call is at a position
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from typing import Final, NamedTuple, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.lsp.extents import Extent, column_of, extent
from rosward.lsp.marks import Mark, Marks
from rosward.lsp.records import LAUNCH, SOURCES, Told, View
from rosward.source import limits
from rosward.source.text import place_name, read_bytes

_UNREAD: Final = frozenset({"RW001", "RW005", "RW006"})
"""Findings that say that a file is not read as it is."""

__all__ = ["Document", "Folder", "Found", "Shift", "State"]


@final
class Document:
    """An open file: its text, and the lines of it."""

    def __init__(self, path: str, text: str) -> None:
        self.path = path
        self.text = text
        self._lines: list[str] | None = None

    @property
    def lines(self) -> list[str]:
        """Without line ends."""
        if self._lines is None:
            self._lines = lines_of(self.text)
        return self._lines


def lines_of(text: str) -> list[str]:
    """The lines of a text, as an editor counts them."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


@final
class Shift:
    """Where the lines of an older text are now: those before and behind what has changed."""

    def __init__(self, old: list[str], new: list[str]) -> None:
        most = min(len(old), len(new))
        same = 0
        while same < most and old[same] == new[same]:
            same += 1
        behind = 0
        while behind < most - same and old[-1 - behind] == new[-1 - behind]:
            behind += 1
        self._same, self._tail, self._by = same, len(old) - behind, len(new) - len(old)

    def line(self, line: int) -> int | None:
        """The line, counted from 1; None where it has changed."""
        if line <= self._same:
            return line
        return line + self._by if line > self._tail else None


class Based(NamedTuple):
    """A view with the texts of the files that were open when it was made, by whole path; and what was told last, of which texts.

    These are of one time, unless a file could not be read then: its marks are those from when it could.
    """

    marks: Marks
    texts: Mapping[str, str]
    told: Mapping[str, tuple[Told, ...]]
    """By file."""
    told_of: Mapping[str, str]


class Found(NamedTuple):
    """A mark at a position: in which view, and how far it reaches in the text as it is now."""

    marks: Marks
    mark: Mark
    extent: Extent


def _by_file(view: View) -> dict[str, tuple[Told, ...]]:
    """The findings of a view that have a place."""
    found: dict[str, list[Told]] = {}
    for told in view.findings:
        if told.place.file:
            found.setdefault(told.place.file, []).append(told)
    return {file: tuple(inside) for file, inside in found.items()}


@final
class Folder:
    """One folder of the workspace, and what was found in it."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.based: dict[tuple[int, str], Based] = {}
        """By who sent it, and by the name of the view."""

    def take(self, view: View, texts: Mapping[str, str], sender: int = 0) -> set[str]:
        """A view was made again; returns the files of which something else may be told now.

        While a file is half written, what was there before is better than nothing.
        """
        before = self.based.get((sender, view.name))
        unread = {told.place.file for told in view.findings if told.code in _UNREAD}
        if before is not None and any(file in before.marks.at for file in unread):
            found = before._replace(told=_by_file(view), told_of=texts)
        else:
            found = Based(Marks(view), texts, _by_file(view), texts)
        self.based[sender, view.name] = found
        return {*found.told, *(before.told if before is not None else ())}

    def keep_only(self, names: Iterable[str], sender: int = 0) -> set[str]:
        """What a sender told of before and does not any more, is gone; returns the files of which less is told now."""
        kept = set(names)
        gone = [key for key in self.based if key[0] == sender and key[1] not in kept]
        return {file for key in gone for file in self.based.pop(key).told}

    def file(self, path: str) -> str:
        """A path as places name it."""
        return place_name(path, self.root)

    def path(self, file: str) -> str:
        """The whole path of a file of a place."""
        return os.path.normpath(os.path.join(self.root, file))  # noqa: PTH118

    @property
    def launched(self) -> list[Marks]:
        """The launched systems; the sources as they are where there is none."""
        every = [each.marks for each in self.based.values()]
        return [m for m in every if m.view.kind == LAUNCH] or every

    def views(self) -> list[Marks]:
        """All views, launched systems first."""
        every = [each.marks for each in self.based.values()]
        return sorted(every, key=lambda marks: (marks.view.kind == SOURCES, marks.view.name))


@final
class State:
    """Everything that the server knows."""

    def __init__(self) -> None:
        self.folders: dict[str, Folder] = {}
        self.documents: dict[str, Document] = {}

    def folder_of(self, path: str) -> Folder | None:
        """The innermost folder in which a file is."""
        inside = [
            f for root, f in self.folders.items() if path == root or path.startswith(root.rstrip(os.sep) + os.sep)
        ]
        return max(inside, key=lambda folder: len(folder.root), default=None)

    def add_folder(self, root: str) -> Folder:
        """A folder of the workspace."""
        return self.folders.setdefault(root, Folder(root))

    def open(self, path: str, text: str) -> None:
        """A file is open, or has another text."""
        self.documents[path] = Document(path, text)

    def close(self, path: str) -> None:
        """It is no longer open."""
        self.documents.pop(path, None)

    def lines(self, path: str) -> list[str]:
        """The lines of a file, as the editor shows them, or as they are on the disk; none where it cannot be read."""
        document = self.documents.get(path)
        if document is not None:
            return document.lines
        data = read_bytes(path, path, limits.PYTHON_FILE)
        return [] if isinstance(data, Finding) else lines_of(data.decode("utf-8-sig", "replace"))

    def _shift(self, old: str | None, path: str, known: dict[int, Shift]) -> Shift | None:
        """How the lines of a file have moved since it had an older text; None where they have not."""
        document = self.documents.get(path)
        if old is None or document is None or old is document.text or old == document.text:
            return None
        if id(old) not in known:
            known[id(old)] = Shift(lines_of(old), document.lines)
        return known[id(old)]

    def now(self, texts: Mapping[str, str], path: str, place: Place) -> Place | None:
        """Where a place in these texts is now; None where its line was changed or is gone."""
        shift = self._shift(texts.get(path), path, {})
        line = place.line if shift is None else shift.line(place.line)
        return None if line is None else place._replace(line=line)

    def in_file(self, path: str) -> Iterator[tuple[Based, Mark, Place]]:
        """All marks in a file, with their place now."""
        folder = self.folder_of(path)
        if folder is None:
            return
        file = folder.file(path)
        known: dict[int, Shift] = {}
        for based in folder.based.values():
            marks = based.marks.at.get(file, ())
            shift = self._shift(based.texts.get(path), path, known) if marks else None
            for mark in marks:
                line = mark.place.line if shift is None else shift.line(mark.place.line)
                if line is not None:
                    yield based, mark, mark.place._replace(line=line)

    def at(self, path: str, line: int, column: int) -> list[Found]:
        """The marks of the innermost call, element or item at a position (counted from 0), launched systems first."""
        lines = self.lines(path)
        found: list[Found] = []
        known: dict[Place, Extent] = {}
        for based, mark, place in self.in_file(path):
            if place.line - 1 > line:
                continue
            if place not in known:
                known[place] = extent(lines, path, place.line - 1, column_of(lines, path, place))
            if known[place].holds(line, column):
                found.append(Found(based.marks, mark, known[place]))
        inner = max(((f.extent.line, f.extent.column) for f in found), default=None)
        found = [f for f in found if (f.extent.line, f.extent.column) == inner]
        return sorted(found, key=lambda f: (f.marks.view.kind == SOURCES, f.marks.view.name))

    def findings(self, path: str) -> list[Told]:
        """What is to be told of a file, each once, where it is now."""
        folder = self.folder_of(path)
        if folder is None:
            return []
        file = folder.file(path)
        found: dict[tuple[str, str, int], Told] = {}
        known: dict[int, Shift] = {}
        for based in folder.based.values():
            inside = based.told.get(file, ())
            shift = self._shift(based.told_of.get(path), path, known) if inside else None
            for told in inside:
                line = told.place.line if shift is None else shift.line(told.place.line)
                if line is not None:
                    place = told.place._replace(line=line)
                    found.setdefault((told.code, told.message, line), told._replace(place=place))
        return sorted(found.values(), key=lambda told: (told.place, told.code, told.message))
