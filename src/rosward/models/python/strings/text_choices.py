# SPDX-License-Identifier: Apache-2.0
"""Which alternatives of texts are kept apart where texts are put together?

    f'{robot}/{topic}'                          of 2 robots and 3 topics: six names
    ''.join(random.choice(LETTERS) for …)       one text with a hole: no letter says anything of the others

Where there would be more results than are kept apart, each piece loses its alternatives; so does a letter beside something unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rosward.domain.choice import MAX_OPTIONS, generalise, reasons_of
from rosward.domain.text import common
from rosward.domain.unknown import Cause
from rosward.domain.values import Choice, Const, Text, Unknown, Value
from rosward.models.native import Machine

MAX_LETTERS: Final = 8
"""Alternatives of one character, beyond which they are letters of a longer text rather than names."""


def bounded(machine: Machine, pieces: Sequence[Value]) -> list[Value]:
    """The pieces of one text, with as many alternatives as can be kept apart together."""
    count = 1
    for piece in pieces:
        count *= len(piece.options) if isinstance(piece, Choice) else 1
    if count == 1:
        return list(pieces)
    if count > MAX_OPTIONS:
        return [_one(machine, p) if isinstance(p, Choice) else p for p in pieces]
    return [
        _one(machine, piece) if isinstance(piece, Choice) and are_letters(piece) and _is_open(pieces, number) else piece
        for number, piece in enumerate(pieces)
    ]


def are_letters(value: Value) -> bool:
    """Whether a value is any of many single characters."""
    return (
        isinstance(value, Choice)
        and len(value.options) > MAX_LETTERS
        and all(isinstance(o, Const) and isinstance(o.value, str) and len(o.value) == 1 for o in value.options)
    )


def _is_open(pieces: Sequence[Value], number: int) -> bool:
    """Whether what stands beside a piece is not known, or is a letter too."""
    before = pieces[number - 1] if number else None
    after = pieces[number + 1] if number + 1 < len(pieces) else None
    return any(v is not None and are_letters(v) for v in (before, after)) or _edge(before, -1) or _edge(after, 0)


def _edge(value: Value | None, end: int) -> bool:
    return isinstance(value, Unknown) or (isinstance(value, Text) and not isinstance(value.parts[end], str))


def _one(machine: Machine, several: Choice) -> Value:
    """One text for all alternatives: what they have in common, and a hole."""
    if not all(isinstance(o, Text) or (isinstance(o, Const) and isinstance(o.value, str)) for o in several.options):
        return generalise(several.options)
    return common(several.options, reasons_of(several)[:4] or machine.unknown(Cause.MANY, "").reasons)
