# SPDX-License-Identifier: Apache-2.0
"""Helpers for strings outside of `std::string`: `<cstring>`, `snprintf`, and what boost, absl, fmt, rcpputils and tf2 offer.

std::snprintf(name, sizeof(name), "cam%d", 4)       name is 'cam4'
rcpputils::join({"a", "b"}, "/")                    'a/b'
boost::algorithm::replace_all(s, ":", "/")          another text in the slot of s
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import External
from rosward.domain.series import Series
from rosward.domain.slots import TypeOf
from rosward.domain.text import concat
from rosward.domain.values import EMPTY, NONE, Const, Ref, Value
from rosward.models.cpp.algorithms.ranges import emit
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.elements import series_of
from rosward.models.cpp.strings.formatting import Flags, shown
from rosward.models.cpp.strings.string_parts import as_python
from rosward.models.cpp.values.conversions import convert, new_container
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import origins, text_of, unknown_from

__all__ = ["NATIVES"]

_STRING: Final = External("std.string")
_TEXTS: Final = TypeOf("std.vector", (_STRING,))


def _text(machine: Machine, value: Value) -> Value:
    return convert(machine, value, _STRING)


# Libraries


def _split(call: NativeCall) -> Value:
    """rcpputils::split(text, delimiter, skip_empty), absl::StrSplit."""
    machine = call.machine
    skips = len(call.args) > 2 and machine.truth(read(machine, call.args[2])) is True
    series = _pieces(machine, call.args[0], call.args[1], skips=skips)
    if len(call.args) == 4 and call.name.startswith("rcpputils"):
        emit(machine, call.args[3], series)
        return NONE
    return new_container(machine, _TEXTS, series, call.name)


def _pieces(machine: Machine, text: Value, separator: Value, *, skips: bool = False) -> Series:
    series = machine.series(as_python(machine, "split", _text(machine, text), _text(machine, separator)))
    if not skips:
        return series
    if series.exact and all(text_of(v) is not None for v in series.head):
        return Series(tuple(v for v in series.head if v != EMPTY))
    return series.loose()


def _boost_split(call: NativeCall) -> Value:
    """boost::split(result, text, boost::is_any_of(characters))."""
    machine = call.machine
    separators = text_of(read(machine, call.args[2]))
    text = _text(machine, call.args[1])
    for target in options(read(machine, call.args[0])):
        if isinstance(target, Ref):
            if separators is not None and len(separators) > 1:
                for other in separators[1:]:
                    text = as_python(machine, "replace", text, Const(other), Const(separators[0]))
            one = Const(separators[0]) if separators else read(machine, call.args[2])
            write_series(machine, target, _pieces(machine, text, one))
    return call.args[0]


def _join(call: NativeCall) -> Value:
    """rcpputils::join(texts, delimiter), absl::StrJoin, fmt::join."""
    machine = call.machine
    separator = _text(machine, call.args[1])
    series = series_of(machine, call.args[0])
    pieces = [shown(machine, value, Flags()) for value in series.head]
    if not series.exact:
        return unknown_from(machine, "join", "str", series.element(), separator)
    return as_python(machine, "join", separator, machine.new_list(pieces))


def _str_cat(call: NativeCall) -> Value:
    return concat(shown(call.machine, arg, Flags()) for arg in call.args)


def _append(call: NativeCall) -> Value:
    more = concat(shown(call.machine, arg, Flags()) for arg in call.args[1:])
    write(call.machine, call.args[0], concat((_text(call.machine, call.args[0]), more)))
    return NONE


def _in_place(change: Callable[[Machine, tuple[Value, ...]], Value]) -> NativeFunction:
    """What changes the text in the slot that comes first."""

    def apply(call: NativeCall) -> Value:
        write(call.machine, call.args[0], change(call.machine, call.args))
        return NONE

    return apply


def _copying(change: Callable[[Machine, tuple[Value, ...]], Value]) -> NativeFunction:
    return lambda call: change(call.machine, call.args)


def _replaced(machine: Machine, args: tuple[Value, ...]) -> Value:
    text, old, new = (_text(machine, arg) for arg in args[:3])
    return as_python(machine, "replace", text, old, new)


def _replaced_first(machine: Machine, args: tuple[Value, ...]) -> Value:
    text, old, new = (_text(machine, arg) for arg in args[:3])
    return as_python(machine, "replace", text, old, new, Const(1))


def _erased(machine: Machine, args: tuple[Value, ...]) -> Value:
    return as_python(machine, "replace", _text(machine, args[0]), _text(machine, args[1]), EMPTY)


def _method(name: str, count: int = 1) -> Callable[[Machine, tuple[Value, ...]], Value]:
    """A method of Python's `str` with so many arguments; what more is given (a locale) changes nothing."""
    return lambda machine, args: as_python(machine, name, *(_text(machine, arg) for arg in args[:count]))


def _contains(machine: Machine, args: tuple[Value, ...]) -> Value:
    return python.compare(machine, "in", _text(machine, args[1]), _text(machine, args[0]))


def _same_text(machine: Machine, args: tuple[Value, ...]) -> Value:
    ours, theirs = (as_python(machine, "lower", _text(machine, arg)) for arg in args[:2])
    return machine.compare("==", ours, theirs)


def _lexical_cast(call: NativeCall) -> Value:
    """boost::lexical_cast<T>(value)."""
    machine, types = call.machine, getattr(call.keywords.get("types"), "items", ())
    wanted = types[0] if types else _STRING
    value = read(machine, call.args[0])
    if convert(machine, Const("x"), wanted) == Const("x"):
        return shown(machine, value, Flags(precision=17))
    return (
        unknown_from(machine, "lexical_cast", "", value) if text_of(value) is None else _number(machine, value, wanted)
    )


def _number(machine: Machine, value: Value, wanted: Value) -> Value:
    text = text_of(value) or ""
    try:
        number = float(text) if "." in text or "e" in text else int(text)
    except ValueError:
        return unknown_from(machine, "lexical_cast", "", value)
    return convert(machine, Const(number, origins(value)), wanted)


_BOOST: Final[dict[str, NativeFunction]] = {
    "to_lower": _in_place(_method("lower")),
    "to_upper": _in_place(_method("upper")),
    "to_lower_copy": _copying(_method("lower")),
    "to_upper_copy": _copying(_method("upper")),
    "trim": _in_place(_method("strip")),
    "trim_left": _in_place(_method("lstrip")),
    "trim_right": _in_place(_method("rstrip")),
    "trim_copy": _copying(_method("strip")),
    "trim_left_copy": _copying(_method("lstrip")),
    "trim_right_copy": _copying(_method("rstrip")),
    "trim_if": _in_place(_method("strip", 2)),
    "trim_left_if": _in_place(_method("lstrip", 2)),
    "trim_right_if": _in_place(_method("rstrip", 2)),
    "replace_all": _in_place(_replaced),
    "replace_all_copy": _copying(_replaced),
    "replace_first": _in_place(_replaced_first),
    "replace_first_copy": _copying(_replaced_first),
    "erase_all": _in_place(_erased),
    "erase_all_copy": _copying(_erased),
    "starts_with": _copying(_method("startswith", 2)),
    "ends_with": _copying(_method("endswith", 2)),
    "contains": _copying(_contains),
    "iequals": _copying(_same_text),
    "split": _boost_split,
    "join": _join,
    "is_any_of": lambda call: _text(call.machine, call.args[0]),
    "lexical_cast": _lexical_cast,
}

_LEAST_OF_BOOST: Final = {
    **dict.fromkeys(
        (
            "trim_if",
            "trim_left_if",
            "trim_right_if",
            "erase_all",
            "erase_all_copy",
            "starts_with",
            "ends_with",
            "contains",
            "iequals",
            "join",
        ),
        2,
    ),
    **dict.fromkeys(
        (
            "replace_all",
            "replace_all_copy",
            "replace_first",
            "replace_first_copy",
            "split",
        ),
        3,
    ),
}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{
        f"{space}.{name}": function
        for name, function in with_least(_BOOST, 1, _LEAST_OF_BOOST).items()
        for space in ("boost", "boost.algorithm")
    },
    "rcpputils.split": _split,
    "rcpputils.join": _join,
    **with_least({"rcpputils.find_and_replace": _copying(_replaced)}, 3),
    "rcpputils.find_library_path": lambda call: unknown_from(call.machine, call.name, "str"),
    "absl.StrSplit": _split,
    "absl.StrJoin": _join,
    "absl.StrCat": _str_cat,
    "absl.StrAppend": _append,
    "absl.StartsWith": _copying(_method("startswith", 2)),
    "absl.EndsWith": _copying(_method("endswith", 2)),
    "absl.StrContains": _copying(_contains),
    "absl.AsciiStrToLower": _copying(_method("lower")),
    "absl.AsciiStrToUpper": _copying(_method("upper")),
    "absl.StripPrefix": _copying(_method("removeprefix", 2)),
    "absl.StripSuffix": _copying(_method("removesuffix", 2)),
    "absl.StripAsciiWhitespace": _copying(_method("strip")),
    "fmt.join": _join,
}
