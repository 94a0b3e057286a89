# SPDX-License-Identifier: Apache-2.0
"""What stands in the source at a place?

    Place("demo/talker.py", 12)  ->  11 │ def __init__(self):
                                     12 │     self.create_publisher(String, "chatter", 10)
                                     13 │     self.create_timer(1.0, self._tick)

Only files below the root of the analysis are opened, links out of it are not followed, and the size of a file, the length of a line and the
number of files have a bound: where a line cannot be shown, the excerpt has no lines.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.safe import printable
from rosward.source import disk, limits
from rosward.source.text import decode, read_bytes

__all__ = ["Excerpt", "Excerpts", "SourceLine"]

_LONGEST: Final = 140
_MOST_FILES: Final = 200


class SourceLine(NamedTuple):
    """One line of a file, made harmless for a terminal."""

    line: int
    text: str


class Excerpt(NamedTuple):
    """A place with its line and those around it."""

    place: Place
    lines: tuple[SourceLine, ...]


@final
class Excerpts:
    """Excerpts of the files below a folder; each file is read once."""

    def __init__(self, root: Path) -> None:
        self._root = root.resolve()
        self._files: dict[str, tuple[str, ...]] = {}

    def around(self, place: Place, context: int = 1) -> Excerpt:
        """The line of a place with `context` lines before and after it."""
        lines = self._lines(place.file) if place.line > 0 and place.file else ()
        if not 0 < place.line <= len(lines):
            return Excerpt(place, ())
        first = max(1, place.line - context)
        shown = range(first, min(len(lines), place.line + context) + 1)
        return Excerpt(place, tuple(SourceLine(number, _shortened(lines[number - 1])) for number in shown))

    def _lines(self, file: str) -> tuple[str, ...]:
        if file not in self._files:
            if len(self._files) >= _MOST_FILES:
                return ()
            self._files[file] = self._read(file)
        return self._files[file]

    def _read(self, file: str) -> tuple[str, ...]:
        try:
            path = Path(disk.real_path(self._root / file))
        except (OSError, ValueError):  # a NUL in the name
            return ()
        if not path.is_relative_to(self._root):
            return ()
        data = read_bytes(path, file, limits.EXCERPT_FILE)
        text = data if isinstance(data, Finding) else decode(data, file)
        return () if isinstance(text, Finding) else tuple(text.text.split("\n"))


def _shortened(line: str) -> str:
    line = line.expandtabs(4)[: _LONGEST + 1].rstrip()
    return printable(line if len(line) <= _LONGEST else line[:_LONGEST] + "…")
