# SPDX-License-Identifier: Apache-2.0
"""Values as numbers, truths and characters of a type: `int(2.5)` is 2, `uint8_t(260)` is 4, `char(65)` is 'A'."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping
from typing import Final

from rosward.domain.enumerated import Whole
from rosward.domain.values import NONE, Const, Unknown, Value
from rosward.ir.arithmetic import same_type
from rosward.models.cpp.values.types import Shape, name_of
from rosward.models.native import Machine
from rosward.models.python.plain import from_python, unknown_from

__all__ = ["NUMBERS", "OCTETS", "number_named", "truncated"]

_ZERO: Final = Const(0)


def _bool(machine: Machine, value: Value, _type: Value) -> Value:
    if isinstance(value, Const) and not isinstance(value.value, str):
        return Const(bool(value.value), value.origins)
    if isinstance(value, Const):  # a character, or a pointer to characters
        return Const(value.value != "\0", value.origins)
    decided = machine.truth(value)
    return unknown_from(machine, "bool", "bool", value) if decided is None else Const(decided)


NARROW: Final[Mapping[str, int]] = {
    **{f"{sign}int{bits}_t": bits for sign in ("", "u") for bits in (8, 16, 32)},
    "unsigned": 32, "unsigned int": 32, "short": 16, "unsigned short": 16, "signed char": 8, "unsigned char": 8,
}  # fmt: skip
"""The types of whole numbers that a program may well leave, and how many bits they have."""


OCTETS: Final[Mapping[str, str]] = {
    **dict.fromkeys(("uint8_t", "unsigned char"), "uint8_t"),
    **dict.fromkeys(("int8_t", "signed char"), "int8_t"),
}
"""The types of whole numbers that are characters to a stream, by their other names."""


def number_named(name: str) -> str:
    """A type of numbers by the one of its names that stands for all: `uint8_t` for `unsigned char`."""
    short = name.removeprefix("std.")
    return OCTETS.get(short) or same_type(short)


_INT: Final = frozenset({"int", "signed", "signed int"})


def truncated(number: int, words: list[str]) -> int:
    """A whole number as a type of that width has it: a narrow one, or one that stands for `npos`; overflow is no matter otherwise."""
    name = " ".join(words).removeprefix("std.")
    bits = NARROW.get(name)
    if bits is not None:
        number %= 1 << bits
        return number if name.startswith("u") or number < 1 << (bits - 1) else number - (1 << bits)
    if 2**31 <= number < 2**32 and name in _INT:  # an unsigned number that fell below zero
        return number - 2**32
    return (
        number - 2**64 if number >= 2**63 and not {"unsigned", "size_t", "std.size_t"}.intersection(words) else number
    )


def _int(machine: Machine, value: Value, type_: Value) -> Value:
    if isinstance(value, Const):
        if isinstance(value.value, str) and len(value.value) != 1:
            return unknown_from(machine, "int", "int")
        if isinstance(value.value, str):
            value = Const(ord(value.value), value.origins)
        if isinstance(value.value, (bool, int)):
            words = name_of(type_).split()
            name = name_of(type_).removeprefix("std.")
            unsigned = name.startswith(("u", "size_t")) and name not in NARROW
            number = int(value.value) % 2**64 if unsigned else truncated(int(value.value), words)
            octet = OCTETS.get(name)
            return Const(number if octet is None else Whole(number, octet), value.origins)
        if isinstance(value.value, float) and math.isfinite(value.value):
            return from_python(machine, int(value.value), value.origins, "int")
        if value == NONE:
            return _ZERO
    return value if isinstance(value, Unknown) and value.hint == "int" else unknown_from(machine, "int", "int", value)


def _float(machine: Machine, value: Value, type_: Value) -> Value:
    number: float | None = None
    if isinstance(value, Const) and isinstance(value.value, str) and len(value.value) == 1:
        number = float(ord(value.value))
    elif isinstance(value, Const) and isinstance(value.value, (bool, int, float)):
        number = float(value.value)
    if number is None or not isinstance(value, Const):
        known = isinstance(value, Unknown) and value.hint == "float"
        return value if known else unknown_from(machine, "float", "float", value)
    if "float" in name_of(type_).split() and math.isfinite(number) and abs(number) < 3e38:
        number = struct.unpack("f", struct.pack("f", number))[0]
    return Const(number, value.origins)


def _char(machine: Machine, value: Value, _type: Value) -> Value:
    if isinstance(value, Const):
        if isinstance(value.value, str):
            return value if len(value.value) == 1 else unknown_from(machine, "char", "str", value)
        if isinstance(value.value, (bool, int, float)) and 0 <= value.value < 128:
            return Const(chr(int(value.value)), value.origins)
    return value if isinstance(value, Unknown) and value.hint == "str" else unknown_from(machine, "char", "str", value)


NUMBERS: Final[dict[Shape, Callable[[Machine, Value, Value], Value]]] = {
    Shape.BOOL: _bool,
    Shape.INT: _int,
    Shape.FLOAT: _float,
    Shape.CHAR: _char,
}
