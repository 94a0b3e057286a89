# SPDX-License-Identifier: Apache-2.0
"""Which numbers does `std::index_sequence_for<Ts...>` hold? They are the arguments of its type, as they are of what it stands for."""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Value
from rosward.models.native import NativeCall, NativeFunction

_MOST: Final = 256


def _of(call: NativeCall, count: int) -> Value:
    type_ = TypeOf("std.index_sequence", tuple(Const(number) for number in range(count)))
    return call.machine.allocate(Obj("instance", type_), "sequence")


def _given(call: NativeCall) -> tuple[Value, ...]:
    """The arguments of the type, packs spread."""
    type_ = call.args[0]
    found = type_.arguments if isinstance(type_, TypeOf) else ()
    return tuple(each for value in found for each in (value.items if isinstance(value, Tuple) else (value,)))


def _for(call: NativeCall) -> Value:
    """As many as there are types."""
    return _of(call, len(_given(call)[:_MOST]))


def _make(call: NativeCall) -> Value:
    """`make_index_sequence<3>`: as many as it says."""
    *_, count = _given(call) or (None,)
    number = count.value if isinstance(count, Const) else None
    if isinstance(number, int) and 0 <= number <= _MOST:
        return _of(call, number)
    return call.machine.unknown(Cause.CALL, "make_index_sequence")


def _numbers(call: NativeCall) -> Value:
    """`index_sequence<0, 2>`: those that are written; of `integer_sequence` the first argument is their type."""
    type_ = TypeOf("std.index_sequence", tuple(v for v in _given(call) if isinstance(v, Const)))
    return call.machine.allocate(Obj("instance", type_), "sequence")


NATIVES: Final[dict[str, NativeFunction]] = {
    "std.index_sequence_for.new": _for,
    "std.make_index_sequence.new": _make,
    "std.make_integer_sequence.new": _make,
    "std.index_sequence.new": _numbers,
    "std.integer_sequence.new": _numbers,
}
