# SPDX-License-Identifier: Apache-2.0
"""What do the methods of `std::string` say that change nothing?

s.find('/')                     where it stands first, or `npos`
s.substr(s.find('/') + 1)       what stands behind it
s.compare("a") == 0             whether they are the same
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import options
from rosward.domain.slots import Slot
from rosward.domain.text import origins_of, parts_of
from rosward.domain.values import Const, Text, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.exceptions import raises
from rosward.models.cpp.strings.string_parts import (
    NOWHERE,
    NPOS,
    STRING,
    as_python,
    substring,
)
from rosward.models.cpp.values.characters import is_text
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.slots import read
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import int_of, origins, spread, text_of, unknown_from

__all__ = ["NATIVES", "OF_PLACES"]


def _find(call: NativeCall) -> Value:
    machine, name = call.machine, call.name.rpartition(".")[2]
    start = read(machine, call.args[2]) if len(call.args) > 2 else (Const(0) if name == "find" else NOWHERE)

    def one(text: Value, wanted: Value, begin: Value) -> Value:
        plain, sub, number = text_of(text), text_of(wanted), int_of(begin)
        if sub is None or number is None or not is_text(text):
            return unknown_from(machine, name, "int", text, wanted, begin)
        source = origins(text, wanted, begin)
        if plain is None:
            first = parts_of(text)[0]
            found = first.find(sub, number) if name == "find" and isinstance(first, str) else -1
            return Const(found, source) if found >= 0 else unknown_from(machine, name, "int", text)
        found = plain.find(sub, number) if name == "find" else plain.rfind(sub, 0, min(number, len(plain)) + len(sub))
        return Const(NPOS if found < 0 else found, source)

    return spread(one, read(machine, call.args[0]), convert(machine, call.args[1], STRING), start)


def _find_one(call: NativeCall) -> Value:
    """find_first_of, find_last_not_of and their kin."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    last, wanted_inside = "last" in name, "not" not in name
    start = read(machine, call.args[2]) if len(call.args) > 2 else (NOWHERE if last else Const(0))

    def one(text: Value, chars: Value, begin: Value) -> Value:
        plain, among, number = text_of(text), text_of(chars), int_of(begin)
        source = origins(text, chars, begin)
        if among is None or number is None:
            return unknown_from(machine, name, "int", text, chars, begin)
        whole = plain is not None
        first = parts_of(text)[0]
        known = plain if plain is not None else first if isinstance(first, str) and not last else ""
        places = [
            n
            for n, char in enumerate(known)
            if (char in among) is wanted_inside and (n <= number if last else n >= number)
        ]
        if places:
            return Const(places[-1 if last else 0], source)
        return Const(NPOS, source) if whole else unknown_from(machine, name, "int", text)

    return spread(one, read(machine, call.args[0]), convert(machine, call.args[1], STRING), start)


def _substr(call: NativeCall) -> Value:
    values = [read(call.machine, arg) for arg in call.args]
    start, count = (values[1:3] + [Const(0), NOWHERE][len(values[1:3]) :])[:2]
    return substring(call.machine, values[0], start, count)


def _at(call: NativeCall) -> Value:
    machine = call.machine
    for text, index in (
        (t, i) for t in options(read(machine, call.args[0])) for i in options(read(machine, call.args[1]))
    ):
        plain, number = text_of(text), int_of(index)
        if plain is not None and number is not None and not 0 <= number < len(plain):
            return raises(machine, "out_of_range", "basic_string::at")
    return Slot(call.args[0], "item", read(machine, call.args[1]))


def _edge(call: NativeCall) -> Value:
    """front(), back()."""
    text = read(call.machine, call.args[0])
    plain = text_of(text)
    if call.name.endswith("front"):
        return Slot(call.args[0], "item", Const(0))
    if plain:
        return Slot(call.args[0], "item", Const(len(plain) - 1))
    last = parts_of(text)[-1] if isinstance(text, Text) else ""
    return (
        Const(last[-1], origins(text))
        if isinstance(last, str) and last
        else unknown_from(call.machine, "back", "str", text)
    )


def _compare(call: NativeCall) -> Value:
    machine = call.machine
    values = [read(machine, arg) for arg in call.args]
    text, other = (values[0], values[1]) if len(values) < 4 else (substring(machine, *values[:3]), values[3])

    def one(a: Value, b: Value) -> Value:
        same = machine.truth(machine.compare("==", a, b))
        left, right = text_of(a), text_of(b)
        if left is None or right is None:
            return Const(0) if same else unknown_from(machine, "compare", "int", a, b)
        return Const((left > right) - (left < right), origins(a, b))

    return spread(one, text, convert(machine, other, STRING))


def _asks(name: str) -> NativeFunction:
    def ask(call: NativeCall) -> Value:
        machine = call.machine
        return as_python(machine, name, read(machine, call.args[0]), convert(machine, call.args[1], STRING))

    return ask


def _contains(call: NativeCall) -> Value:
    machine = call.machine
    return python.compare(machine, "in", convert(machine, call.args[1], STRING), read(machine, call.args[0]))


def _copy(call: NativeCall) -> Value:
    text = read(call.machine, call.args[0])
    return Const(str(text.value), origins_of(text)) if isinstance(text, Const) else text


_METHODS: Final[dict[str, Callable[[NativeCall], Value]]] = {
    **dict.fromkeys(("find", "rfind"), _find),
    **dict.fromkeys(("find_first_of", "find_last_of", "find_first_not_of", "find_last_not_of"), _find_one),
    "substr": _substr,
    "at": _at,
    **dict.fromkeys(("front", "back"), _edge),
    "compare": _compare,
    "starts_with": _asks("startswith"),
    "ends_with": _asks("endswith"),
    "contains": _contains,
    "to_string": _copy,
}

_LEAST: Final = {
    **dict.fromkeys(
        (
            "find",
            "rfind",
            "find_first_of",
            "find_last_of",
            "find_first_not_of",
            "find_last_not_of",
            "at",
            "compare",
            "starts_with",
            "ends_with",
            "contains",
        ),
        2,
    ),
}
OF_PLACES: Final = frozenset(f"std.string.{name}" for name in ("at", "front", "back"))
NATIVES: Final[dict[str, NativeFunction]] = {
    f"std.string.{name}": function for name, function in with_least(_METHODS, 1, _LEAST).items()
}
