# SPDX-License-Identifier: Apache-2.0
"""Which fields and constants does an interface have? The text of .msg, .srv and .action files, as rosidl reads it.

uint8 FAST=2          the constant FAST
string name "left"    a field with a default
Point[] points        a sequence of messages of the same package
---                   between request and response; goal, result and feedback
"""

from __future__ import annotations

import re
from typing import Final

from rosward.records import NamedTuple

Constant = bool | int | float | bytes | str

PARTS: Final = {"msg": ("",), "srv": ("Request", "Response"), "action": ("Goal", "Result", "Feedback")}
"""The messages that an interface of each kind consists of."""

INTEGERS: Final = frozenset(f"{sign}int{size}" for sign in ("", "u") for size in (8, 16, 32, 64)) | {"char"}
"""The types whose values are int in Python."""
FLOATS: Final = frozenset({"float32", "float64"})
"""The types whose values are float in Python."""
TEXTS: Final = frozenset({"string", "wstring"})
"""The types whose values are str in Python."""
_PRIMITIVE: Final = INTEGERS | FLOATS | TEXTS | {"bool", "byte"}
_LINE: Final = re.compile(
    r"(?P<maybe>\?)?(?P<type>[A-Za-z][\w/]*|\*)(?:<=\d+)?(?P<array>\[(?:<=)?\d*\])?\s+(?P<name>[A-Za-z]\w*)\s*(?P<rest>.*)"
)
_ZERO: Final[dict[str, Constant]] = {
    **dict.fromkeys(INTEGERS, 0),
    **dict.fromkeys(FLOATS, 0.0),
    **dict.fromkeys(TEXTS, ""),
    "bool": False,
    "byte": b"\0",
}


class Field(NamedTuple):
    """A field: `type` is primitive or `package/Name`, '*' where it is not the same in all distros; `array` is '', '[]', '[3]' or '[<=3]'.

    `default` is None where it is not known, and where the field is an array or a message. `empty`: it is a sequence that has nothing in it
    until somebody writes to it. `sure`: all distros have it.
    """

    type: str
    array: str
    default: Constant | None
    empty: bool
    sure: bool

    @property
    def is_message(self) -> bool:
        """Whether the field, or each of its elements, is a message."""
        return "/" in self.type


class Definition(NamedTuple):
    """One message, or one part of a service or action. `closed`: nothing has other fields than these."""

    fields: dict[str, Field]
    constants: dict[str, Constant | None]
    closed: bool


def read_definition(text: str, package: str, kind: str, *, closed: bool) -> dict[str, Definition] | None:
    """The parts of an interface by name (`PARTS`); None where the text is no such interface."""
    parts: list[list[str]] = [[]]
    for line in text.splitlines():
        bare = line.partition("#")[0].strip()
        if bare == "---":
            parts.append([])
        elif bare:
            parts[-1].append(bare)
    names = PARTS[kind]
    if len(parts) != len(names):
        return None
    found = [_part(lines, package, closed=closed) for lines in parts]
    return {name: part for name, part in zip(names, found, strict=True) if part is not None}


def _part(lines: list[str], package: str, *, closed: bool) -> Definition | None:
    fields: dict[str, Field] = {}
    constants: dict[str, Constant | None] = {}
    for line in lines:
        match = _LINE.fullmatch(line)
        if match is None:
            return None
        type_, name, rest, array = match["type"], match["name"], match["rest"], match["array"] or ""
        if rest.startswith("="):
            constants[name] = _value(type_, rest[1:].strip())
        else:
            fields[name] = _field(type_, array, rest, package, sure=match["maybe"] is None)
    return Definition(fields, constants, closed)


def _field(type_: str, array: str, rest: str, package: str, *, sure: bool) -> Field:
    empty = not rest and (array == "[]" or array.startswith("[<="))
    if type_ not in _PRIMITIVE and type_ != "*":
        own = "std_msgs/Header" if type_ == "Header" else type_
        return Field(own if "/" in own else f"{package}/{own}", array, None, empty, sure)
    if array or type_ == "*":
        return Field(type_, array, None, empty, sure)
    return Field(type_, array, _value(type_, rest) if rest else _ZERO[type_], False, sure)


def _value(type_: str, text: str) -> Constant | None:
    """A constant as Python has it; None where the text says nothing of that type."""
    try:
        if type_ in TEXTS:
            return _text(text)
        if type_ == "bool":
            return {"true": True, "1": True, "false": False, "0": False}[text.lower()]
        if type_ in FLOATS:
            return float(text)
        number = int(text, 0)
    except (KeyError, ValueError):
        return None
    if type_ == "byte":
        return bytes((number,)) if 0 <= number < 256 else None
    return number if type_ in INTEGERS else None


def _text(text: str) -> str | None:
    if len(text) >= 2 and text[0] == text[-1] and text[0] in "\"'":
        text = text[1:-1]
    return None if "\\" in text else text
