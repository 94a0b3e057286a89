# SPDX-License-Identifier: Apache-2.0
"""Texts as C has them: `<cstring>`, `snprintf`. A text is filled where it stands, from a character on where a pointer leads into it.

std::snprintf(name, sizeof(name), "cam%d", 4)       name is 'cam4'
char * end = name + 3; strcpy(end, "era")           name is 'camera'
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, lift, options
from rosward.domain.compound import External, Slice, Tuple
from rosward.domain.series import Series
from rosward.domain.slots import Pointer, Slot
from rosward.domain.text import concat
from rosward.domain.unknown import Cause, Origins
from rosward.domain.values import EMPTY, NONE, Const, Ref, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.iterators import moved
from rosward.models.cpp.strings.formatting import printf
from rosward.models.cpp.strings.string_parts import as_python
from rosward.models.cpp.values.conversions import as_characters, convert
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import int_of, origins, spread, text_of, unknown_from

__all__ = ["NATIVES"]

_STRING: Final = External("std.string")


def _text(machine: Machine, value: Value) -> Value:
    return convert(machine, value, _STRING)


def _put(machine: Machine, place: Value, text: Value) -> None:
    """A text where a buffer stands, or behind the beginning of one, which stays."""
    held = read(machine, place)
    pointers = [o for o in options(held) if isinstance(o, Pointer)]
    for pointer in pointers:
        target = pointer.target
        begin = int_of(target.key) if isinstance(target, Slot) and isinstance(target.key, Value) else None
        if isinstance(target, Slot) and isinstance(target.base, Slot) and begin is not None:
            whole = read(machine, target.base)
            if any(len(str(text_of(o))) < begin for o in options(whole) if text_of(o) is not None):
                text = unknown_from(machine, "characters", "str", whole, text)  # behind where it ends
            before = python.load_item(machine, whole, Slice(NONE, Const(begin), NONE))
            text = concat((before, text)) if begin else text
            write(machine, target.base, lift(as_characters, text), weak=len(options(held)) > 1)
        elif (
            isinstance(target, Slot)
            and isinstance(target.base, Ref)
            and begin is not None
            and text_of(text) is not None
        ):
            _fill(machine, target.base, begin, str(text_of(text)), origins(text))
        elif isinstance(target, Slot):
            write(machine, target, unknown_from(machine, "characters", "str", text), weak=True)
    if not pointers:
        write(machine, place, lift(as_characters, text))


def _fill(machine: Machine, ref: Ref, begin: int, text: str, source: Origins) -> None:
    """The elements of a container of characters, from one on."""
    series = machine.obj(ref).series()
    fresh = tuple(Const(char, source) for char in f"{text}\0")
    if series.exact and begin + len(fresh) <= len(series.head):
        write_series(machine, ref, Series((*series.head[:begin], *fresh, *series.head[begin + len(fresh) :])))
    else:
        write_series(
            machine, ref, Series((*series.head[:begin], *fresh), machine.unknown(Cause.OPERATION, "characters", "str"))
        )


def _snprintf(call: NativeCall) -> Value:
    """snprintf(place, size, template, …): the text is cut off where the size is known. `vsnprintf` has its arguments in a `va_list`."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    sized = "n" in name.removeprefix("v").removesuffix("printf")
    template, args = call.args[2 if sized else 1], call.args[3 if sized else 2 :]
    if name.startswith("v"):
        listed = read(machine, args[0]) if args else NONE
        if not isinstance(listed, Tuple):
            _put(machine, call.args[0], unknown_from(machine, name, "str", listed))
            return unknown_from(machine, name, "int", listed)
        args = tuple(read(machine, item) for item in listed.items)
    text = printf(machine, template, args)
    size = int_of(read(machine, call.args[1])) if sized else None
    kept = text
    if size is not None:
        kept = EMPTY if size <= 0 else python.load_item(machine, text, Slice(NONE, Const(size - 1), NONE))
    _put(machine, call.args[0], kept)
    return _length(machine, text)


def _length(machine: Machine, text: Value) -> Value:
    def one(value: Value) -> Value:
        plain = text_of(value)
        return unknown_from(machine, "length", "int", value) if plain is None else Const(len(plain), origins(value))

    return spread(one, text)


def _strlen(call: NativeCall) -> Value:
    return _length(call.machine, _text(call.machine, call.args[0]))


def _strcpy(call: NativeCall) -> Value:
    machine, name = call.machine, call.name.rpartition(".")[2]
    text = _text(machine, call.args[1])
    if name.startswith("strn"):
        text = python.load_item(machine, text, Slice(NONE, read(machine, call.args[2]), NONE))
    if name.endswith("cat"):
        text = concat((_text(machine, call.args[0]), text))
    _put(machine, call.args[0], text)
    return call.args[0]


def _strcmp(call: NativeCall) -> Value:
    machine, name = call.machine, call.name.rpartition(".")[2]
    values = [_text(machine, arg) for arg in call.exactly(2)]
    if name.startswith("strn"):
        values = [python.load_item(machine, v, Slice(NONE, read(machine, call.args[2]), NONE)) for v in values]
    if "case" in name:
        values = [as_python(machine, "lower", v) for v in values]

    def one(a: Value, b: Value) -> Value:
        left, right = text_of(a), text_of(b)
        if left is None or right is None:
            differ = machine.truth(machine.compare("==", a, b)) is False
            return Const(1) if differ else unknown_from(machine, name, "int", a, b)
        return Const((left > right) - (left < right), origins(a, b))

    return spread(one, *values)


def _strstr(call: NativeCall) -> Value:
    """strstr(text, part): the text from there on, or null."""
    machine = call.machine

    def one(where: Value, part: Value) -> Value:
        text = _text(machine, where)
        plain, wanted = text_of(text), text_of(part)
        place = None
        if plain is not None and wanted is not None:
            place = plain.rfind(wanted) if call.name.endswith("strrchr") else plain.find(wanted)
        if place is not None and place < 0:
            return NONE
        if isinstance(where, Pointer):
            steps = unknown_from(machine, "strstr", "int", text, part) if place is None else Const(place)
            return moved(machine, where, steps) if place is not None else join(moved(machine, where, steps), NONE)
        if place is None:
            return unknown_from(machine, "strstr", "", text, part)
        return Const(str(plain)[place:], origins(text, part))

    where, part = call.exactly(2)
    return spread(one, read(machine, where), _text(machine, part))


def _nothing(_call: NativeCall) -> Value:
    return NONE


_FUNCTIONS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("snprintf", "sprintf", "vsnprintf", "vsprintf"), _snprintf),
    "strlen": _strlen,
    **dict.fromkeys(("strcpy", "strncpy", "strcat", "strncat"), _strcpy),
    **dict.fromkeys(("strcmp", "strncmp", "strcasecmp", "strncasecmp"), _strcmp),
    **dict.fromkeys(("strstr", "strchr", "strrchr"), _strstr),
    "strdup": lambda call: lift(as_characters, _text(call.machine, call.args[0])),
    "va_end": _nothing,
}
_LEAST_OF_C: Final = {
    **dict.fromkeys(
        (
            "sprintf",
            "strcpy",
            "strcat",
            "strcmp",
            "strcasecmp",
            "strstr",
            "strchr",
            "strrchr",
        ),
        2,
    ),
    **dict.fromkeys(
        (
            "snprintf",
            "strncpy",
            "strncat",
            "strncmp",
            "strncasecmp",
        ),
        3,
    ),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    f"std.{name}": function for name, function in with_least(_FUNCTIONS, 1, _LEAST_OF_C).items()
}
