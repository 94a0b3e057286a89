# SPDX-License-Identifier: Apache-2.0
"""Characters, which are texts of one here, and small numbers in C++; pointers to them, which are texts where one is asked for."""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import lift, options
from rosward.domain.slots import Pointer, Slot, is_char_text
from rosward.domain.values import Choice, Const, Ref, Text, Unknown, Value
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine
from rosward.models.python.plain import from_python, int_of, origins, text_of, unknown_from

__all__ = [
    "as_kept",
    "as_string",
    "beside",
    "beside_text",
    "character_of",
    "is_character",
    "is_text",
    "number_of",
    "text_behind",
    "text_in",
]

_LAST: Final = 127


def character_of(value: Value) -> str | None:
    """The character that a value is; a small number is one, too."""
    if (
        isinstance(value, Const)
        and isinstance(value.value, int)
        and value.value.__class__ is not bool
        and 0 <= value.value < 128
    ):
        return chr(value.value)
    return text_of(value)


def number_of(value: Value) -> Const | None:
    """A number, a truth, or a character as the number that it is."""
    if not isinstance(value, Const) or value.value is None or isinstance(value.value, bytes):
        return None
    if isinstance(value.value, str):
        return Const(ord(value.value), value.origins) if len(value.value) == 1 else None
    return value


def is_character(value: Value) -> bool:
    """Whether a value is one character that is known, of ASCII as both its neighbours are, and no pointer to one."""
    text = text_of(value) if isinstance(value, Const) and not is_char_text(value) else None
    return text is not None and len(text) == 1 and 0 < ord(text) < _LAST


def beside(value: Value, by: int) -> Value:
    """The character after a known one, or before it."""
    return Const(chr(ord(text_of(value) or " ") + by), origins(value))


def is_text(value: Value) -> bool:
    """Whether a value is a text, known or not."""
    return isinstance(value, Text) or text_of(value) is not None or (isinstance(value, Unknown) and value.hint == "str")


def text_behind(machine: Machine, value: Value) -> Value:
    """A pointer into a text as the text from there on; anything else as it is."""
    if value.__class__ is Pointer:
        return _behind(machine, value)
    if value.__class__ is Choice and any(option.__class__ is Pointer for option in value.options):
        return lift(lambda o: _behind(machine, o) if o.__class__ is Pointer else o, value)
    return value


def as_string(machine: Machine, value: Value) -> Value:
    """Characters, or a pointer to them, as a string object has them; anything else as it is."""

    def one(option: Value) -> Value:
        return (
            Const(str(option.value), option.origins) if is_char_text(option) and isinstance(option, Const) else option
        )

    return lift(one, text_behind(machine, value))


def as_kept(machine: Machine, place: Value, value: Value) -> Value:
    """A value as a place keeps it: where a string is, characters that a pointer leads to become one."""
    if not any(option.__class__ is Pointer for option in options(value)):
        return value
    held = options(read(machine, place))
    return as_string(machine, value) if all(is_text(o) and not is_char_text(o) for o in held) else value


def beside_text(machine: Machine, left: Value, right: Value) -> tuple[Value, Value]:
    """Two operands; a pointer into a text as that text, where the other operand is one."""

    def one(value: Value, other: Value) -> Value:
        leads = value.__class__ in (Pointer, Choice) and any(map(is_text, options(other)))
        return text_behind(machine, value) if leads else value

    return one(left, right), one(right, left)


def text_in(machine: Machine, ref: Ref, begin: int) -> Value | None:
    """The text that stands in a container of characters, up to the first zero."""
    found = [text_of(read(machine, item)) for item in machine.obj(ref).series().head[begin:]]
    if "\0" not in found or None in found[: found.index("\0")]:
        return None
    return from_python(machine, "".join(map(str, found[: found.index("\0")])), what="string")


def _behind(machine: Machine, pointer: Pointer) -> Value:
    target = pointer.target
    if target.__class__ is not Slot or target.kind != "item" or not isinstance(target.key, Value):
        return pointer
    whole, key, begin = read(machine, target.base), target.key, int_of(target.key)
    if whole.__class__ is Ref:
        found = None if begin is None or machine.obj(whole).kind != "list" else text_in(machine, whole, begin)
        return pointer if found is None else found
    if not all(map(is_text, options(whole))):
        return pointer
    if begin == 0:
        return whole

    def one(option: Value) -> Value:
        text = text_of(option)
        if text is None or begin is None or begin > len(text):
            return unknown_from(machine, "string", "str", option, key)
        return from_python(machine, text[begin:], origins(option))

    return lift(one, whole)
