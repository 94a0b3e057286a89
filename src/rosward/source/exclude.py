# SPDX-License-Identifier: Apache-2.0
"""Which files does the user not want to be read at all?

    third_party        a file or folder of that name, at any depth, with all that is in it
    src/legacy/**      what is in that folder; with a `/` inside, a pattern starts at the folder that it belongs to
    **/gen_*.py        `*` is any text without `/`, `**` any number of folders
    docs/              a folder, no file

The patterns are those of .gitignore, without `!`. What the user names as a PATH is read even if a pattern means it, or a folder around it.

Patterns come with the sources (`rosward.toml`), so no pattern may take long: each part of a path is looked at once for each part of the
pattern, and within a part a star never goes back (`fnmatch.translate`). The package pathspec, which makes one regular expression of a pattern,
needs more than 20 s for `*a*a*a*a*a*a*a*ab` and a name of 60 characters.
"""

from __future__ import annotations

import fnmatch
import os
import re
from collections.abc import Iterable, Sequence
from typing import Final, final

from rosward.records import NamedTuple
from rosward.source import disk

__all__ = ["Exclusion", "Exclusions", "PatternError", "exclusions_of", "pattern_of"]

_LONGEST: Final = 1_000
_MOST: Final = 1_000
_ESCAPED: Final = re.compile(r"\\(.)|\[\^", re.DOTALL)


class PatternError(Exception):
    """A pattern that has no meaning; the message says why."""


class Exclusion(NamedTuple):
    """A pattern, and the folder that it starts at."""

    base: str
    pattern: str


def pattern_of(text: str) -> str:
    """The text, if it is a pattern. Raises PatternError."""
    if text.startswith("!"):
        raise PatternError(f"{text}: an exclusion cannot be revoked")
    if "\0" in text or len(text) > _LONGEST or not [p for p in text.split("/") if p not in ("", ".", "**")]:
        raise PatternError(f"{text[:60]!r} does not name anything specific")
    if ".." in text.split("/"):
        raise PatternError(f"{text[:60]!r} leads out of its folder")
    return text


def exclusions_of(patterns: Iterable[str | Exclusion], paths: Iterable[str]) -> list[Exclusion]:
    """The patterns with their folders: one that has none starts at the working directory, and at paths outside of it. Raises PatternError."""
    here = os.getcwd()  # noqa: PTH109
    outside = [p for p in map(os.path.abspath, paths) if p != here and not p.startswith(here.rstrip(os.sep) + os.sep)]
    bases = list(dict.fromkeys([here, *outside]))
    found: list[Exclusion] = []
    for pattern in patterns:
        if isinstance(pattern, Exclusion):
            found.append(pattern)
        else:
            found += (Exclusion(base, pattern_of(pattern)) for base in bases)
    return found


class _Compiled(NamedTuple):
    """A pattern by its parts, None for `**`."""

    exclusion: Exclusion
    base: tuple[str, ...]
    parts: tuple[re.Pattern[str] | None, ...]
    folders_only: bool


@final
class Exclusions:
    """All patterns of an analysis; `named` are the paths that the user names."""

    def __init__(self, exclusions: Iterable[Exclusion] = (), named: Sequence[str] = ()) -> None:
        self._patterns = [_compiled(e) for e in dict.fromkeys(exclusions)][:_MOST]
        self._named = [_split(path) for path in named]

    def __bool__(self) -> bool:
        return bool(self._patterns)

    def of(self, path: str) -> Exclusion | None:
        """The pattern that excludes a path, or a folder that it is in."""
        if not self._patterns:
            return None
        parts = _split(path)
        given = max((len(n) for n in self._named if parts[: len(n)] == n), default=0)
        return next((p.exclusion for p in self._patterns if _excludes(p, parts, given, path)), None)


def _split(path: str) -> tuple[str, ...]:
    return tuple(part for part in path.split(os.sep) if part)  # noqa: PTH206  where nothing but speed matters


def _compiled(exclusion: Exclusion) -> _Compiled:
    text = exclusion.pattern
    names = [part for part in text.split("/") if part not in ("", ".")]
    while len(names) > 1 and names[-1] == "**":
        names.pop()
        if names[-1] != "**":
            names.append("*")  # all that is in a folder, but not what has its name
            break
    anchored = "/" in text.rstrip("/")
    names = names if anchored or names[0] == "**" else ["**", *names]
    names = [
        n for n, before in zip(names, [None, *names], strict=False) if not n == before == "**"
    ]  # one says the same
    parts = tuple(None if name == "**" else re.compile(fnmatch.translate(_for_fnmatch(name))) for name in names)
    return _Compiled(exclusion, _split(exclusion.base), parts, text.endswith("/"))


def _for_fnmatch(name: str) -> str:
    """One part of a pattern as fnmatch writes it: `\\*` is the character, `[^a]` any other than `a`."""
    return _ESCAPED.sub(lambda found: f"[{found[1]}]" if found[1] else "[!", name)


def _excludes(pattern: _Compiled, parts: tuple[str, ...], given: int, path: str) -> bool:
    """Whether the pattern means the path, or a folder around it that is below the first `given` parts."""
    depth = len(pattern.base)
    if parts[:depth] != pattern.base:
        return False
    last = len(pattern.parts)
    states = _after_stars({0}, pattern)
    for position in range(depth, len(parts)):
        following: set[int] = set()
        for state in states:
            if state == last:
                continue
            part = pattern.parts[state]
            if part is None:
                following.add(state)
            elif part.match(parts[position]):
                following.add(state + 1)
        states = _after_stars(following, pattern)
        whole = position == len(parts) - 1
        if last in states and position >= given and (not (whole and pattern.folders_only) or disk.is_folder(path)):
            return True
    return False


def _after_stars(states: set[int], pattern: _Compiled) -> set[int]:
    """`**` also means no folder at all."""
    return states | {s + 1 for s in states if s < len(pattern.parts) and pattern.parts[s] is None}
