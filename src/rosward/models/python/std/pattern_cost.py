# SPDX-License-Identifier: Apache-2.0
"""How long would Python take to match a regular expression against a text, at the most?

    work('(a|a)*b', 0, 'aaaa')      the ways through the pattern that its matcher may try before it gives up
    work('(a+)+b', 0, 'a' * 100)    None: too many to count

Python's matcher tries one way after the other. How many there are can be counted without trying them: `ways[p]` is the number of ways that
lead to position p of the text, and each part of the pattern maps these numbers to those behind it. So the bound is that of this text, not
of the worst one, and a pattern is refused for what it would do, not for how it looks. The sum over all parts is what a search that fails costs;
one that succeeds costs less.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable
from typing import Any, Final, final

try:
    from re import _compiler, _parser  # type: ignore[attr-defined]  # the parser of `re`, which is private
except ImportError:  # Python 3.10
    import sre_compile as _compiler
    import sre_parse as _parser

MAX_PATTERN: Final = 1_000
MAX_TEXT: Final = 4_096
MAX_WORK: Final = 3_000_000
_MAX_COUNTING: Final = 400_000
"""Positions looked at while counting."""

_ONE: Final = ("LITERAL", "NOT_LITERAL", "IN", "RANGE", "ANY", "ANY_ALL", "CATEGORY")
_REPEATS: Final = ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT")

Ways = dict[int, int]


class _TooMuchError(Exception):
    """There are more ways than are tried."""


def work(pattern: str, flags: int, text: str) -> int | None:
    """The steps of all searches for a pattern in a text; None where these are too many, or the pattern is not understood."""
    if len(pattern) > MAX_PATTERN or len(text) > MAX_TEXT:
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return _Counter(text).all_searches(_parser.parse(pattern, flags))
    except (_TooMuchError, _parser.error, OverflowError, RecursionError, ValueError):
        return None


@final
class _Counter:
    """Counts on one text; `work` is what all parts looked at so far cost the matcher, `left` what may still be looked at here."""

    __slots__ = ("_accepted", "_flags", "_pattern", "_single", "left", "text", "work")

    def __init__(self, text: str) -> None:
        self.text = text
        self.work = 0
        self.left = _MAX_COUNTING
        self._pattern: Any = None
        self._flags = 0
        self._single: dict[tuple[str, int, int], re.Pattern[str]] = {}
        self._accepted: dict[tuple[str, int, int, str], bool] = {}

    def all_searches(self, pattern: Any) -> int:
        """A search begins at each position; after an empty match, once more at the same."""
        self._pattern, self._flags = pattern, pattern.state.flags
        self._sequence(pattern, dict.fromkeys(range(len(self.text) + 1), 2))
        return self.work

    def _spend(self, ways: Ways) -> None:
        self.work += sum(ways.values())
        self.left -= len(ways) + 1
        if self.work > MAX_WORK or self.left < 0:
            raise _TooMuchError

    def _sequence(self, parts: Iterable[tuple[Any, Any]], ways: Ways) -> Ways:
        for operation, argument in parts:
            if not ways:
                break
            self._spend(ways)
            ways = self._part(str(operation), argument, ways)
        return ways

    def _part(self, operation: str, argument: Any, ways: Ways) -> Ways:
        if operation in _ONE:
            return {
                at + 1: n for at, n in ways.items() if at < len(self.text) and self._accept(operation, argument, at)
            }
        if operation in _REPEATS:
            return self._repeat(argument, ways)
        if operation == "BRANCH":
            return self._either(argument[1], ways)
        if operation == "SUBPATTERN":
            return self._group(argument, ways)
        if operation == "ATOMIC_GROUP":
            return self._sequence(argument, ways)
        if operation in ("ASSERT", "ASSERT_NOT"):
            ahead = argument[0] > 0
            self._sequence(argument[1], ways if ahead else dict.fromkeys(range(len(self.text) + 1), max(ways.values())))
            return ways
        if operation == "GROUPREF_EXISTS":
            return self._either([a for a in argument[1:] if a is not None], ways, ways)
        if operation.startswith("GROUPREF"):  # the group may hold anything
            return {at: n for start, n in ways.items() for at in range(start, len(self.text) + 1)}
        if operation in ("AT", "FAILURE"):
            return ways
        raise _TooMuchError

    def _group(self, argument: tuple[Any, int, int, Any], ways: Ways) -> Ways:
        """A group, with its own flags: `(?i:…)`."""
        outer = self._flags
        kept = outer & ~_parser.TYPE_FLAGS if argument[1] & _parser.TYPE_FLAGS else outer
        self._flags = (kept | argument[1]) & ~argument[2]
        found = self._sequence(argument[-1], ways)
        self._flags = outer
        return found

    def _either(self, branches: Iterable[Any], ways: Ways, none: Ways | None = None) -> Ways:
        found = dict(none or {})
        for branch in branches:
            _add(found, self._sequence(branch, ways))
        return found

    def _repeat(self, argument: tuple[int, int, Any], ways: Ways) -> Ways:
        least, most, body = int(argument[0]), int(argument[1]), argument[2]
        if len(body) == 1 and str(body[0][0]) in _ONE:
            return self._run_of_one(least, most, str(body[0][0]), body[0][1], ways)
        found = dict(ways) if least == 0 else {}
        for turn in range(1, min(most, least + len(self.text) + 1) + 1):
            if not ways:
                break
            ways = self._sequence(body, ways)
            if turn >= least:
                _add(found, ways)
            self._spend(ways)
        return found

    def _run_of_one(self, least: int, most: int, operation: str, argument: Any, ways: Ways) -> Ways:
        """A single character repeated, as most repeats are: all of its turns at once, by sums over neighbouring positions."""
        sums, begin, found = [0], 0, {}
        for at in range(len(self.text) + 1):
            if at and not self._accept(operation, argument, at - 1):
                begin = at
            sums.append(sums[-1] + ways.get(at, 0))
            first, last = max(begin, at - most), at - least
            number = sums[last + 1] - sums[first] if first <= last else 0
            if number:
                found[at] = number
        self.left -= len(self.text)
        self._spend(found)
        return found

    def _accept(self, operation: str, argument: Any, at: int) -> bool:
        """Whether one character matches: asked of Python itself, under the flags that hold here."""
        if operation.startswith("ANY"):
            return operation == "ANY_ALL" or self.text[at] != "\n" or bool(self._flags & re.DOTALL)
        key = (operation, id(argument), self._flags)
        one = self._single.get(key)
        if one is None:
            part = _parser.SubPattern(self._pattern.state, [(getattr(_parser, operation), argument)])
            one = self._single[key] = _compiler.compile(part, self._flags)
        where = (*key, self.text[at])
        found = self._accepted.get(where)
        if found is None:
            found = self._accepted[where] = one.fullmatch(self.text[at]) is not None
        return found


def _add(ways: Ways, more: Ways) -> None:
    for at, number in more.items():
        ways[at] = ways.get(at, 0) + number
