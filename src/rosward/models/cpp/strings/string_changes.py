# SPDX-License-Identifier: Apache-2.0
"""The methods of `std::string` that change it, and its constructors: a string is a value, so another text stands in its slot.

s.append("/x"); s.erase(0, 2)
std::string(3, 'x')             'xxx'
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.compound import Tuple
from rosward.domain.slots import Slot
from rosward.domain.text import concat, make, parts_of
from rosward.domain.values import EMPTY, NONE, UNBOUND, Const, Text, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.exceptions import raises
from rosward.models.cpp.iteration.iterators import as_iterator, iterator
from rosward.models.cpp.strings.string_parts import (
    CHAR,
    MOST,
    NOWHERE,
    NPOS,
    STRING,
    sliced,
    text_from,
)
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import from_python, int_of, origins, spread, text_of, unknown_from

__all__ = ["NATIVES", "OF_PLACES"]


def _changed(call: NativeCall, text: Value) -> Value:
    """The string is another text from now on; gives the string."""
    if text is UNBOUND:
        return text
    if call.args[0].__class__ is Slot:
        write(call.machine, call.args[0], text)
        return call.args[0]
    return text


def _append(call: NativeCall) -> Value:
    machine = call.machine
    more = text_from(machine, call.args[1:])
    return _changed(call, python.binary(machine, "+", read(machine, call.args[0]), more))


def _assign(call: NativeCall) -> Value:
    return _changed(call, text_from(call.machine, call.args[1:]))


def _push_back(call: NativeCall) -> Value:
    machine = call.machine
    more = convert(machine, call.args[1], CHAR)
    _changed(call, python.binary(machine, "+", read(machine, call.args[0]), more))
    return NONE


def _pop_back(call: NativeCall) -> Value:
    machine = call.machine
    _changed(call, sliced(machine, read(machine, call.args[0]), NONE, Const(-1)))
    return NONE


def _clear(call: NativeCall) -> Value:
    _changed(call, EMPTY)
    return NONE


def _place(value: Value) -> Value:
    """An index, or that to which an iterator leads."""
    slot = as_iterator(value)
    if slot is None:
        return value
    return NOWHERE if slot.key == NONE or not isinstance(slot.key, Value) else slot.key


def _replaced(machine: Machine, text: Value, start: Value, count: Value, new: Value, *, by_index: bool) -> Value:
    """The text with `new` for so many characters; `by_index`: from a position that is asked whether it is one."""

    def one(whole: Value, begin: Value, many: Value, fresh: Value) -> Value:
        first, length = int_of(begin), int_of(many)
        if first is None or length is None:
            return unknown_from(machine, "replace", "str", whole, begin, many, fresh)
        plain = text_of(whole)
        if plain is not None and first > len(plain) and by_index:
            return raises(machine, "out_of_range", "basic_string")
        if plain is not None:
            first = min(first, len(plain))
        before = sliced(machine, whole, NONE, Const(first))
        after = EMPTY if length >= MOST else sliced(machine, whole, Const(first + length), NONE)
        return concat((before, fresh, after))

    return spread(one, text, start, count, new)


def _span(machine: Machine, first: Value, second: Value) -> tuple[Value, Value]:
    """Begin and length of what is given by two iterators, or by these themselves."""
    if as_iterator(first) is None:
        return first, second
    start, stop = _place(first), _place(second)
    a, b = int_of(start), int_of(stop)
    if b == NPOS:
        return start, NOWHERE
    return start, Const(b - a) if a is not None and b is not None else unknown_from(
        machine, "range", "int", start, stop
    )


def _replace(call: NativeCall) -> Value:
    machine = call.machine
    start, count = _span(machine, read(machine, call.args[1]), read(machine, call.args[2]))
    fresh, indexed = text_from(machine, call.args[3:]), as_iterator(read(machine, call.args[1])) is None
    return _changed(call, _replaced(machine, read(machine, call.args[0]), start, count, fresh, by_index=indexed))


def _insert(call: NativeCall) -> Value:
    machine = call.machine
    place = read(machine, call.args[1])
    fresh = text_from(machine, call.args[2:])
    indexed = as_iterator(place) is None
    made = _replaced(machine, read(machine, call.args[0]), _place(place), Const(0), fresh, by_index=indexed)
    changed = _changed(call, made)
    return place if as_iterator(place) is not None else changed


def _erase(call: NativeCall) -> Value:
    machine = call.machine
    values = [read(machine, arg) for arg in call.args[1:3]]
    if values and as_iterator(values[0]) is not None:
        start, count = _span(machine, *values) if len(values) > 1 else (_place(values[0]), Const(1))
        _changed(call, _replaced(machine, read(machine, call.args[0]), start, count, EMPTY, by_index=False))
        number, size = int_of(start), text_of(read(machine, call.args[0]))
        at_end = number is not None and size is not None and number >= len(size)
        return iterator(call.args[0], NONE if at_end else start)
    start, count = (values + [Const(0), NOWHERE][len(values) :])[:2]
    return _changed(call, _replaced(machine, read(machine, call.args[0]), start, count, EMPTY, by_index=True))


def _resize(call: NativeCall) -> Value:
    machine = call.machine
    fill = text_of(read(machine, call.args[2])) if len(call.args) > 2 else "\0"

    def one(text: Value, size: Value) -> Value:
        plain, number = text_of(text), int_of(size)
        if plain is None or number is None or not 0 <= number <= MOST or not fill:
            if number is not None and number <= MOST and isinstance(text, Text):
                return make((*parts_of(sliced(machine, text, NONE, size)),))
            return unknown_from(machine, "resize", "str", text, size)
        return from_python(machine, plain[:number].ljust(number, fill), origins(text, size))

    _changed(call, spread(one, read(machine, call.args[0]), read(machine, call.args[1])))
    return NONE


def _shortened(call: NativeCall) -> Value:
    """remove_prefix(n), remove_suffix(n) of a view."""
    machine = call.machine
    count = int_of(read(machine, call.args[1]))
    text = read(machine, call.args[0])
    if count is None:
        changed: Value = unknown_from(machine, call.name, "str", text, read(machine, call.args[1]))
    elif call.name.endswith("prefix"):
        changed = sliced(machine, text, Const(count), NONE)
    else:
        changed = sliced(machine, text, NONE, Const(-count) if count else NONE)
    write(machine, call.args[0], changed)
    return NONE


def _swap(call: NativeCall) -> Value:
    machine = call.machine
    ours, theirs = (read(machine, arg) for arg in call.args[:2])
    write(machine, call.args[0], theirs)
    write(machine, call.args[1], ours)
    return NONE


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


def _capacity(call: NativeCall) -> Value:
    return unknown_from(call.machine, "capacity", "int")


def _new(call: NativeCall) -> Value:
    """std::string(…): the type comes first."""
    args = call.args[1:]
    if len(args) == 1 and isinstance(args[0], Tuple):
        return convert(call.machine, args[0], STRING)
    return text_from(call.machine, args)


_METHODS: Final[dict[str, Callable[[NativeCall], Value]]] = {
    **dict.fromkeys(("append", "concat"), _append),
    "assign": _assign,
    "push_back": _push_back,
    "pop_back": _pop_back,
    "clear": _clear,
    "replace": _replace,
    "insert": _insert,
    "erase": _erase,
    "resize": _resize,
    "swap": _swap,
    **dict.fromkeys(("remove_prefix", "remove_suffix"), _shortened),
    **dict.fromkeys(("reserve", "shrink_to_fit"), _nothing),
    **dict.fromkeys(("capacity", "max_size"), _capacity),
}

OF_PLACES: Final = frozenset(f"std.string.{name}" for name in _METHODS)
_LEAST: Final = {
    **dict.fromkeys(
        (
            "push_back",
            "resize",
            "swap",
            "remove_prefix",
            "remove_suffix",
            "insert",
        ),
        2,
    ),
    **dict.fromkeys(("replace",), 4),
}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.string.{name}": function for name, function in with_least(_METHODS, 1, _LEAST).items()},
    **{f"std.{name}.new": _new for name in ("string", "string_view", "basic_string", "filesystem.path")},
    "rcpputils.fs.path.new": _new,
    "boost.filesystem.path.new": _new,
}
