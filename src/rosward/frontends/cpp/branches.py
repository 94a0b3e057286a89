# SPDX-License-Identifier: Apache-2.0
"""Which directives does a file have, and can both branches of a condition stand in one text?

pub_ = create("a");                      a statement begins before `#ifdef`, and each branch is whole statements:
#ifdef WITH_GPS                          both can be kept
  gps_ = create("gps");
#endif
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from rosward.frontends.cpp.tokens import LITERAL
from rosward.records import NamedTuple

_DIRECTIVE: Final = re.compile(r"[ \t]*(?:#|%:)[ \t]*([A-Za-z_]\w*)?(.*)", re.DOTALL)
_LITERAL: Final = re.compile(LITERAL)
CONDITIONS: Final = frozenset({"if", "ifdef", "ifndef"})
"""Directives that begin a condition."""


class Directive(NamedTuple):
    """A directive: `line` from 0; `following` is the line of the next branch of its condition, or of its `#endif`."""

    name: str
    text: str
    line: int
    following: int = -1


def directives(lines: Sequence[str]) -> dict[int, Directive]:
    """The directives of cleaned text, by line. A condition that is not closed goes to the end."""
    found: dict[int, Directive] = {}
    around: list[int] = []
    for number, line in enumerate(lines):
        if "#" not in line and "%:" not in line:
            continue
        match = _DIRECTIVE.match(line)
        if match is None:
            continue
        name = match[1] or ""
        found[number] = Directive(name, match[2].strip(), number)
        if name in CONDITIONS:
            around.append(number)
        elif name in {"elif", "else", "endif", "elifdef", "elifndef"} and around:
            found[around[-1]] = found[around[-1]]._replace(following=number)
            if name == "endif":
                around.pop()
            else:
                around[-1] = number
    for number in around:
        found[number] = found[number]._replace(following=len(lines))
    return found


def guard(lines: Sequence[str], found: dict[int, Directive]) -> str | None:
    """The name of the include guard, '' for `#pragma once`; None where the file may be included again."""
    numbers = list(found)
    for number in numbers[:5]:
        if found[number].name == "pragma" and found[number].text.startswith("once"):
            return ""
    first = found[numbers[0]] if numbers else None
    if first is None or any(line.strip() for line in lines[: first.line]):
        return None
    name = first.text.split()[0] if first.name == "ifndef" and first.text else ""
    if first.name == "if":
        match = re.fullmatch(r"!\s*defined\s*\(?\s*(\w+)\s*\)?", first.text)
        name = match[1] if match else ""
    second = found[numbers[1]] if len(numbers) > 1 else None
    if name and second is not None and second.name == "define" and second.text.split()[:1] == [name]:
        return name
    return None


def code_of(lines: Sequence[str], found: dict[int, Directive], first: int, last: int) -> str:
    """The text of the lines without directives and literals."""
    text = "\n".join(lines[n] for n in range(first, last) if n not in found)
    return _LITERAL.sub('""', text)


def is_whole(text: str) -> bool:
    """Whether a text without literals is whole statements or members, or nothing."""
    text = text.strip()
    if not text:
        return True
    if text[-1] not in ";}:":
        return False
    depth = 0
    for character in text:
        if character in "({[":
            depth += 1
        elif character in ")}]":
            depth -= 1
            if depth < 0:
                return False
    return depth == 0


def begins_here(before: str) -> bool:
    """Whether a statement or member can begin after this text."""
    before = before.rstrip()
    return not before or before[-1] in ";{}:"


def branch_ends(found: dict[int, Directive], opening: int, lines: int) -> list[tuple[int, int]]:
    """First and last line (behind) of each branch of a condition."""
    result: list[tuple[int, int]] = []
    here = opening
    while True:
        following = found[here].following
        if following < 0:
            return result
        result.append((here + 1, min(following, lines)))
        if following >= lines or found[following].name == "endif":
            return result
        here = following
