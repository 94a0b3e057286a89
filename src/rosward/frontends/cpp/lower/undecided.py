# SPDX-License-Identifier: Apache-2.0
"""In which branches of conditions that nobody knows does a line stand? Branches lie within each other, or apart."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from typing import Final, final

from rosward.frontends.cpp.prepared import Choice

_NONE: Final = -1


@final
class Undecided:
    """The choices within a body."""

    __slots__ = ("_branches", "_choices", "_first", "_outer")

    def __init__(self, choices: Iterable[Choice]) -> None:
        self._choices = sorted(choices, key=lambda choice: (choice.first, -choice.last))
        self._first = [choice.first for choice in self._choices]
        self._outer: list[int] = []  # for each, the number of the one around it
        self._branches: dict[int, set[int]] = {}
        around: list[int] = []
        for number, choice in enumerate(self._choices):
            while around and self._choices[around[-1]].last < choice.first:
                around.pop()
            self._outer.append(around[-1] if around else _NONE)
            around.append(number)
            self._branches.setdefault(choice.condition, set()).add(choice.branch)

    def __bool__(self) -> bool:
        return bool(self._choices)

    def around(self, line: int) -> tuple[Choice, ...]:
        """The branches around a line, outermost first."""
        found: list[Choice] = []
        number = bisect_right(self._first, line) - 1
        while number != _NONE:
            if self._choices[number].last >= line:
                found.append(self._choices[number])
            number = self._outer[number]
        return tuple(reversed(found))

    def branches(self, condition: int) -> set[int]:
        """The branches that a condition has."""
        return self._branches[condition]
