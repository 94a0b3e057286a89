# SPDX-License-Identifier: Apache-2.0
"""Which lines of the sources does the report hold?

    the places of the document  ->  {"demo/talker.py": {"8": "import rclpy", …, "12": "def __init__(self):", …}}

Each place with four lines on both sides, as long as all of it stays below a bound; a place that has no room is counted. Files come in the order
in which the places first name them, so the places that matter most are to be given first. One file is held at a time. Places that are `alone` come
last, and have their own line only: there are many of them, each a step of a way.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Final

from rosward.explanation.excerpts import Excerpts
from rosward.location import Place
from rosward.records import NamedTuple

__all__ = ["SourceLines", "source_lines"]

_AROUND: Final = 4
_MOST_CHARACTERS: Final = 2_000_000
_BESIDE_TEXT: Final = 10
"""Characters that a line has in the document beside its text."""


class SourceLines(NamedTuple):
    """The lines by file and number; `left_out` places have none because there are too many."""

    lines: dict[str, dict[str, str]]
    left_out: int


def source_lines(
    root: Path, places: Iterable[Place], limit: int = _MOST_CHARACTERS, *, alone: Iterable[Place] = ()
) -> SourceLines:
    """The lines around the places, and those that are `alone`, of files below `root`."""
    lines: dict[str, dict[int, str]] = {}
    left_out = 0
    for around, wanted in ((_AROUND, places), (0, alone)):
        for file, numbers in _by_file(wanted).items():
            excerpts = Excerpts(root)
            held = lines.setdefault(file, {})
            for number in numbers:
                if around == 0 and number in held:
                    continue
                excerpt = excerpts.around(Place(file, number), around)
                new = {row.line: row.text for row in excerpt.lines if row.line not in held}
                size = sum(len(text) + _BESIDE_TEXT for text in new.values())
                if size > limit:
                    left_out += 1
                else:
                    limit -= size
                    held.update(new)
    kept = {
        file: {str(number): held[number] for number in sorted(held)} for file, held in sorted(lines.items()) if held
    }
    return SourceLines(kept, left_out)


def _by_file(places: Iterable[Place]) -> dict[str, dict[int, None]]:
    """The numbers of the lines, each once, by file, in the order of the places."""
    wanted: dict[str, dict[int, None]] = {}
    for place in places:
        if place.file and place.line > 0:
            wanted.setdefault(place.file, {})[place.line] = None
    return wanted
