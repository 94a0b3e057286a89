# SPDX-License-Identifier: Apache-2.0
"""How does a value of the analysis stand in the document?

    9007199254740993     ->  "9007199254740993"     (JavaScript would read another number)

Text that is shown has no control characters and no direction marks, and has a bound, as lists have: what is longer says how long it was.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from rosward.location import Place
from rosward.safe import printable

__all__ = ["harmless", "place_rows", "value_row"]

_LONGEST: Final = 2000
_MOST_ITEMS: Final = 100
_WHOLE_NUMBERS: Final = 2**53
"""Above it JavaScript has no longer every whole number."""


def place_rows(places: Iterable[Place]) -> list[dict[str, object]]:
    """Places in the order given, each file and line once."""
    return [{"file": file, "line": line} for file, line in dict.fromkeys((p.file, p.line) for p in places)]


def value_row(value: object) -> object:
    """The value of a parameter; null for none and for what is not known."""
    if isinstance(value, int) and not isinstance(value, bool):
        return value if abs(value) <= _WHOLE_NUMBERS else str(value)
    if isinstance(value, float) and not math.isfinite(value):
        return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"
    if value is None or isinstance(value, (bool, float, str)):
        return value
    if isinstance(value, (list, tuple, bytes, bytearray)):
        more = [f"… {len(value) - _MOST_ITEMS} more"] if len(value) > _MOST_ITEMS else []
        return [value_row(item) for item in value[:_MOST_ITEMS]] + more
    return None


def harmless(value: object) -> object:
    """A piece of the document with every text in it, keys too, made harmless to show."""
    known: dict[str, str] = {}  # most texts come again and again
    get = known.get

    def of_text(text: str) -> str:
        found = known[text] = printable(text if len(text) <= _LONGEST else _cut(text))
        return found

    def of(value: object) -> object:
        if isinstance(value, str):
            return get(value) or of_text(value)
        if isinstance(value, dict):
            return {
                get(key) or of_text(key): (get(item) or of_text(item))
                if item.__class__ is str
                else item
                if item is None or item.__class__ is bool
                else of(item)
                for key, item in value.items()
            }
        if isinstance(value, list):
            return [of(item) for item in value]
        return value

    return of(value)


def _cut(text: str) -> str:
    return f"{text[:_LONGEST]}… ({len(text)} characters)"
