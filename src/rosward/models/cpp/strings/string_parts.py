# SPDX-License-Identifier: Apache-2.0
"""Pieces of strings: what Python's `str` says of them, and what constructors and `append` are given.

substring(machine, text, Const(2), NOWHERE)         all behind the first two characters
text_from(machine, (Const(3), Const('x')))          'xxx'
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import External, Partial, Slice
from rosward.domain.slots import Pointer, TypeOf, is_char_text
from rosward.domain.text import concat
from rosward.domain.values import EMPTY, NONE, Const, Value
from rosward.models.cpp.iteration.elements import between
from rosward.models.cpp.iteration.exceptions import may_raise, raises
from rosward.models.cpp.iteration.iterators import as_iterator, moved
from rosward.models.cpp.strings import streams
from rosward.models.cpp.values.characters import is_text
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, perform
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import MAX_ITEMS, int_of, origins, spread, text_of, unknown_from
from rosward.models.python.strings.methods import NATIVES as PYTHON

__all__ = [
    "CHAR", "MOST", "NOWHERE", "NPOS", "STRING",
    "as_python", "characters", "from_characters", "sliced", "substring", "text_from",
]  # fmt: skip

NPOS: Final = 2**64 - 1
NOWHERE: Final = Const(NPOS)
MOST: Final = 4096
STRING: Final = External("std.string")
CHAR: Final = TypeOf("char", ())


def as_python(machine: Machine, name: str, *args: Value) -> Value:
    """What the method of Python's `str` gives."""
    return perform(PYTHON[f"str.{name}"], NativeCall(machine, f"str.{name}", args, {}))


def sliced(machine: Machine, text: Value, start: Value, stop: Value) -> Value:
    """text[start:stop]."""
    return python.load_item(machine, text, Slice(start, stop, NONE))


def characters(value: Value) -> list[Value] | None:
    """The characters of a text that is known."""
    text = text_of(value)
    if text is None or len(text) > MAX_ITEMS:
        return None
    source = origins(value)
    return [Const(char, source) for char in text]


def from_characters(machine: Machine, values: tuple[Value, ...]) -> Value:
    """The text that characters make; numbers among them are characters too."""
    return concat(convert(machine, value, CHAR) for value in values)


def text_from(machine: Machine, args: tuple[Value, ...]) -> Value:
    """What a constructor of a string, `append` and `assign` make of their arguments."""
    values = [read(machine, arg) for arg in args]
    if not values:
        return EMPTY
    if len(values) > 1 and as_iterator(values[0]) is not None:
        counted = int_of(values[1]) is not None
        series = between(machine, values[0], moved(machine, values[0], values[1]) if counted else values[1])
        if series.exact:
            return from_characters(machine, series.head)
        return unknown_from(machine, "string", "str", series.element())
    first = values[0]
    if isinstance(first, Partial) and first.function == External(streams.ITERATOR):
        return streams.content(machine, first.arguments[0]) if first.arguments else EMPTY
    if len(values) == 2 and isinstance(first, Const) and isinstance(first.value, int):
        return _repeated(machine, values[1], first)
    if len(values) == 2 and is_text(first):
        return (
            sliced(machine, first, Const(0), values[1])
            if _is_pointer(first)
            else substring(machine, first, values[1], NOWHERE)
        )
    if len(values) > 2 and is_text(first):
        return substring(machine, first, values[1], values[2])
    return convert(machine, first, STRING)


def _is_pointer(value: Value) -> bool:
    """Whether a text is given as a pointer to its characters."""
    return is_char_text(value) or isinstance(value, Pointer)


def _repeated(machine: Machine, char: Value, count: Value) -> Value:
    """A character, so many times."""
    return python.binary(machine, "*", convert(machine, char, CHAR), count)


def substring(machine: Machine, text: Value, start: Value, count: Value) -> Value:
    """text.substr(start, count)."""

    def one(whole: Value, begin: Value, many: Value) -> Value:
        first, length = int_of(begin), int_of(many)
        plain = text_of(whole)
        if plain is not None and first is not None and first > len(plain):
            return raises(machine, "out_of_range", "basic_string::substr")
        if first is None:
            may_raise(machine, "out_of_range", "basic_string::substr")
        if first is None or length is None:
            return unknown_from(machine, "substr", "str", whole, begin, many)
        stop = NONE if length >= MOST else Const(first + length)
        return sliced(machine, whole, Const(first, origins(begin)), stop)

    return spread(one, text, start, count)
