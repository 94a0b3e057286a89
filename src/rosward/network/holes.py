# SPDX-License-Identifier: Apache-2.0
"""May two names with holes be one and the same?

/robot_1/scan   /robot_*/scan    yes: * is any text, / included
/robot_*/scan   /*/front/scan    yes: both may be /robot_1/front/scan
/robot_*/scan   /arm_*/scan      no
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from typing import final

__all__ = ["NameIndex", "may_be", "may_meet"]


def may_be(name: str, pattern: str) -> bool:
    """Whether a name fits a pattern, in linear time."""
    first, *rest = pattern.split("*")
    if not rest:
        return name == pattern
    last = rest.pop()
    if not (name.startswith(first) and name.endswith(last) and len(name) >= len(first) + len(last)):
        return False
    at, end = len(first), len(name) - len(last)
    for piece in rest:
        found = name.find(piece, at, end)
        if found < 0:
            return False
        at = found + len(piece)
    return True


def may_meet(one: str, other: str) -> bool:
    """Whether some name fits both.

    Where both have a hole, only what stands before the first and behind the last hole can keep them apart: the hole of each takes in all
    that the other has between.
    """
    if "*" not in one:
        return may_be(one, other)
    if "*" not in other:
        return may_be(other, one)
    begin, end = one.partition("*")[0], one.rpartition("*")[2]
    other_begin, other_end = other.partition("*")[0], other.rpartition("*")[2]
    return (begin.startswith(other_begin) or other_begin.startswith(begin)) and (
        end.endswith(other_end) or other_end.endswith(end)
    )


@final
class NameIndex:
    """Many names, to be asked whether one of them may be another: only those are looked at whose beginnings agree."""

    def __init__(self, names: Iterable[str]) -> None:
        everything = set(names)
        self._whole = sorted(name for name in everything if "*" not in name)
        self._patterns: dict[str, list[str]] = {}
        for name in everything:
            if "*" in name:
                self._patterns.setdefault(name.partition("*")[0], []).append(name)
        self._beginnings = sorted(self._patterns)

    def meet(self, name: str) -> bool:
        """Whether one of them may be this name, which may have holes itself."""
        beginning, star, _ = name.partition("*")
        if star and any(may_be(whole, name) for whole in _starting(self._whole, beginning)):
            return True
        shorter = {beginning[:length] for length in range(len(beginning) + 1)}
        longer = _starting(self._beginnings, beginning) if star else ()
        return any(
            may_meet(name, pattern) for start in shorter.union(longer) for pattern in self._patterns.get(start, ())
        )


def _starting(names: list[str], beginning: str) -> Iterator[str]:
    """Those of sorted names that begin so."""
    for number in range(bisect_left(names, beginning), len(names)):
        if not names[number].startswith(beginning):
            return
        yield names[number]
