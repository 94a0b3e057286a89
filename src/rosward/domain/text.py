# SPDX-License-Identifier: Apache-2.0
"""Strings of which a part is known: concatenation and what several strings have in common.

concat('/robot_', unknown, '/cmd')      Text('/robot_', hole, '/cmd'), printed /robot_*/cmd
common('/a/x', '/b/x')                  Text('/', hole, '/x')
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Final

from rosward.domain.compound import External
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins, Reason, of_library
from rosward.domain.values import Choice, Const, Hole, Text, Unknown, Value
from rosward.holes import Holed, holed

MAX_LENGTH: Final = 4096
MAX_PARTS: Final = 32
_PATHS: Final = frozenset((Cause.SHARE, Cause.PREFIX, Cause.SOURCES))


def parts_of(value: Value) -> tuple[str | Hole, ...]:
    """The parts of a str value; anything that is not a text is one hole."""
    if value.__class__ is Const and value.value.__class__ is str:
        return (value.value,)
    if value.__class__ is Text:
        return value.parts
    if value.__class__ is Unknown:
        return (Hole(value.reasons, "digits" if value.hint == "int" else ""),)
    if value.__class__ is External:
        return (Hole((of_library(value.name),)),)
    if value.__class__ is Choice:
        holes = [p for option in value.options for p in parts_of(option) if isinstance(p, Hole)]
        return (Hole(tuple(dict.fromkeys(r for hole in holes for r in hole.reasons))[:4]),)
    return (Hole(()),)


def is_path(value: Value) -> bool:
    """Whether a text begins with the folder of a package or of the sources: then it is absolute, and surely a str."""
    first = parts_of(value)[0]
    return isinstance(first, Hole) and bool(first.reasons) and all(r.cause in _PATHS for r in first.reasons)


def origins_of(value: Value) -> Origins:
    """The origins that a value carries."""
    return value.origins if value.__class__ in (Const, Text) else NO_ORIGINS


def make(parts: Iterable[str | Hole], origins: Origins = NO_ORIGINS) -> Value:
    """The normal form of a text: neighbours merged; a Const without holes, an Unknown str with nothing but one."""
    merged: list[str | Hole] = []
    for part in parts:
        if not merged:
            if part != "":
                merged.append(part)
            continue
        last = merged[-1]
        if isinstance(part, str):
            if isinstance(last, str):
                merged[-1] = last + part
            elif part:
                merged.append(part)
        elif isinstance(last, Hole):
            reasons = tuple(dict.fromkeys(last.reasons + part.reasons))[:4]
            merged[-1] = Hole(reasons, last.shape if last.shape == part.shape else "")
        else:
            merged.append(part)
    if len(merged) > MAX_PARTS or sum(len(p) for p in merged if isinstance(p, str)) > MAX_LENGTH:
        merged = _shortened(merged)
    if not merged:
        return Const("", origins)
    if len(merged) == 1:
        only = merged[0]
        return Const(only, origins) if isinstance(only, str) else Unknown(only.reasons, "str")
    return Text(tuple(merged), origins)


def _shortened(parts: list[str | Hole]) -> list[str | Hole]:
    holes = [p for p in parts if isinstance(p, Hole)]
    if not holes:
        return parts  # a long constant is still a constant
    hole = Hole(tuple(dict.fromkeys(r for h in holes for r in h.reasons))[:4])
    first = parts[0] if isinstance(parts[0], str) else ""
    return [first[: MAX_LENGTH // 2], hole] if first else [hole]


def concat(values: Iterable[Value]) -> Value:
    """The concatenation of str values."""
    parts: list[str | Hole] = []
    origins: Origins = NO_ORIGINS
    for value in values:
        parts.extend(parts_of(value))
        origins |= origins_of(value)
    return make(parts, origins)


def common(values: Sequence[Value], reasons: tuple[Reason, ...]) -> Value:
    """A text that covers all: their common beginning, a hole, their common end."""
    origins: Origins = NO_ORIGINS
    heads: list[str] = []
    tails: list[str] = []
    for value in values:
        parts = parts_of(value)
        origins |= origins_of(value)
        first, last = parts[0], parts[-1]
        heads.append(first if isinstance(first, str) else "")
        tails.append(last if isinstance(last, str) else "")
    head = os.path.commonprefix(heads)
    whole = min((len(h) for h, v in zip(heads, values, strict=True) if v.__class__ is Const), default=MAX_LENGTH)
    tail = os.path.commonprefix([t[::-1] for t in tails])[: max(0, whole - len(head))][::-1]
    return make((head, Hole(reasons), tail), origins)


def pattern(value: Value) -> Holed:
    """The text with `*` for each hole, ready to be read as a name or as a word of a command line."""
    return holed(p if isinstance(p, str) else None for p in parts_of(value))


def readable(value: Value) -> str:
    """The text as a person reads it, `*` for each hole."""
    return "".join(p if isinstance(p, str) else "*" for p in parts_of(value))


def matches(value: Value, text: str) -> bool:
    """Whether a value covers a str: holes stand for any text of their shape."""
    if value.__class__ is Choice:
        return any(matches(o, text) for o in value.options)
    if value.__class__ is Const:
        return value.value.__class__ is str and value.value == text
    if value.__class__ is Unknown:
        return value.hint in ("", "str")
    if value.__class__ is not Text:
        return False
    first, last = value.parts[0], value.parts[-1]
    if (first.__class__ is str and not text.startswith(first)) or (last.__class__ is str and not text.endswith(last)):
        return False
    reached = {0}
    for part in value.parts:
        if isinstance(part, str):
            reached = {at + len(part) for at in reached if text.startswith(part, at)}
        else:
            reached = _behind(part, text, reached)
    return len(text) in reached


def _behind(hole: Hole, text: str, starts: set[int]) -> set[int]:
    """The positions at which a hole that begins at one of `starts` can end."""
    if not hole.shape:
        return set(range(min(starts), len(text) + 1)) if starts else set()
    found: set[int] = set()
    inside = False
    for at, char in enumerate(text):
        inside = (inside or at in starts) and (char != "/" if hole.shape == "word" else char in "-0123456789")
        if inside:
            found.add(at + 1)
    return found
