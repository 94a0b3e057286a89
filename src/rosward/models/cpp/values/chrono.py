# SPDX-License-Identifier: Apache-2.0
"""How long is a duration, and what comes of computing with durations?

std::chrono::milliseconds(1500)                 a record of 1500 counts of 1/1000 s
duration_cast<seconds>(1500ms).count()          1
steady_clock::now()                             not known, and what is computed from it
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Unknown, Value
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import name_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import from_python, int_of, origins, unknown_from

__all__ = ["NATIVES", "as_duration", "binary", "compare", "is_time", "unary", "unit_of"]

DURATION: Final = "std.chrono.duration"
_COUNT: Final = "count"
_UNITS: Final = {
    "nanoseconds": Fraction(1, 10**9),
    "microseconds": Fraction(1, 10**6),
    "milliseconds": Fraction(1, 1000),
    "seconds": Fraction(1),
    "minutes": Fraction(60),
    "hours": Fraction(3600),
    "days": Fraction(86400),
    "weeks": Fraction(604800),
}
_RATIOS: Final = {
    "nano": Fraction(1, 10**9),
    "micro": Fraction(1, 10**6),
    "milli": Fraction(1, 1000),
    "centi": Fraction(1, 100),
    "deci": Fraction(1, 10),
}
_SUFFIXES: Final = {
    "ns": "nanoseconds", "us": "microseconds", "ms": "milliseconds", "s": "seconds", "min": "minutes", "h": "hours",
}  # fmt: skip
_NANO: Final = TypeOf(DURATION, (TypeOf("long", ()), Const(1), Const(10**9)))


def unit_of(type_: Value) -> Fraction | None:
    """How long one count of a type of durations is, in seconds; None for what is no such type."""
    name = name_of(type_)
    if name == DURATION and isinstance(type_, TypeOf):
        return _ratio(type_.arguments[1:])
    short = name.removeprefix("std.chrono.")
    return _UNITS.get(short) if short != name else None


def _ratio(arguments: tuple[Value, ...]) -> Fraction | None:
    numbers = [int_of(value) for value in arguments]
    if len(numbers) == 2 and numbers[0] is not None and numbers[1]:
        return Fraction(numbers[0], numbers[1])
    if not arguments:
        return Fraction(1)
    if isinstance(arguments[0], TypeOf) and arguments[0].name == "std.ratio":
        return _ratio((*arguments[0].arguments, Const(1))[:2])
    return _RATIOS.get(name_of(arguments[0]).removeprefix("std."))


def _is_whole(type_: Value) -> bool:
    """Whether a type of durations counts in whole numbers."""
    return not (
        isinstance(type_, TypeOf) and type_.arguments and {"float", "double"} & set(name_of(type_.arguments[0]).split())
    )


def _new(machine: Machine, unit: Fraction, count: Value, *, whole: bool = True) -> Ref:
    counted = TypeOf("long" if whole else "double", ())
    cls = TypeOf(DURATION, (counted, Const(unit.numerator), Const(unit.denominator)))
    return machine.allocate(Obj("instance", cls, {_COUNT: count}), (cls, count))


def is_time(machine: Machine, value: Value) -> bool:
    """Whether a value is a duration."""
    if not isinstance(value, Ref):
        return False
    cls = machine.obj(value).cls
    return isinstance(cls, TypeOf) and cls.name == DURATION


def _unit(machine: Machine, ref: Value) -> Fraction:
    assert isinstance(ref, Ref)
    return unit_of(machine.obj(ref).cls) or Fraction(1)


def _count(machine: Machine, ref: Value) -> Value:
    assert isinstance(ref, Ref)
    return machine.obj(ref).attrs.get(_COUNT, NONE)


def as_duration(machine: Machine, value: Value, type_: Value) -> Value:
    """A duration as one of another type: whole counts are cut off."""
    unit = unit_of(type_)
    if unit is None:
        return value
    return join_all(_as(machine, option, type_, unit) for option in options(value))


def _as(machine: Machine, value: Value, type_: Value, unit: Fraction) -> Value:
    whole = _is_whole(type_)
    if not is_time(machine, value):
        return _new(machine, unit, value, whole=whole) if not isinstance(value, Ref) else value
    count, own = _count(machine, value), _unit(machine, value)
    if not isinstance(count, Const) or not isinstance(count.value, (int, float)):
        return _new(
            machine, unit, count if own == unit else unknown_from(machine, "duration", "int", count), whole=whole
        )
    if isinstance(count.value, float) and not math.isfinite(count.value * float(own / unit)):
        return _new(machine, unit, unknown_from(machine, "duration", "int" if whole else "float", count), whole=whole)
    if isinstance(count.value, float):
        number: float = count.value * float(own / unit)
        return _new(machine, unit, from_python(machine, int(number) if whole else number, count.origins), whole=whole)
    exact = count.value * own / unit
    truncated = int(exact)
    return _new(machine, unit, Const(truncated if whole else float(exact), count.origins), whole=whole)


def _common(machine: Machine, left: Value, right: Value) -> tuple[Fraction, Value, Value, bool]:
    """Two durations in a unit that fits both."""
    units = (_unit(machine, left), _unit(machine, right))
    unit = min(units)
    whole = all(isinstance(v, Ref) and _is_whole(machine.obj(v).cls) for v in (left, right))
    type_ = TypeOf(
        DURATION, (TypeOf("long" if whole else "double", ()), Const(unit.numerator), Const(unit.denominator))
    )
    a, b = (_as(machine, value, type_, unit) for value in (left, right))
    return unit, _count(machine, a), _count(machine, b), whole


def binary(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right, of which one is a duration."""
    if is_time(machine, left) and is_time(machine, right):
        unit, a, b, whole = _common(machine, left, right)
        result = machine.binary(op, a, b)
        return result if op == "/" else _new(machine, unit, result, whole=whole)
    duration, other = (left, right) if is_time(machine, left) else (right, left)
    if isinstance(other, (Unknown, Ref)) and op in ("+", "-"):
        return unknown_from(machine, op, "", other)  # a point of time
    if op not in ("*", "/", "%"):
        return unknown_from(machine, op, "", left, right)
    unit = _unit(machine, duration)
    count = machine.binary(op, _count(machine, duration), other)
    whole = not (isinstance(count, Const) and isinstance(count.value, float))
    return _new(machine, unit, count, whole=whole)


def compare(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right of two durations."""
    _, a, b, _ = _common(machine, left, right)
    return machine.compare(op, a, b)


def unary(machine: Machine, op: str, value: Value) -> Value:
    """op value."""
    count = _count(machine, value)
    negated = machine.binary("-", Const(0), count) if op == "-" else count
    return _new(machine, _unit(machine, value), negated)


# Natives


def _make(call: NativeCall) -> Value:
    """std::chrono::milliseconds(n): the type comes first."""
    machine, type_ = call.machine, call.args[0]
    count = read(machine, call.args[1]) if len(call.args) > 1 else Const(0)
    if isinstance(count, Tuple):
        count = count.items[0] if count.items else Const(0)
    return as_duration(machine, count, type_)


def _count_of(call: NativeCall) -> Value:
    return join_all(
        _count(call.machine, option)
        if is_time(call.machine, option)
        else unknown_from(call.machine, "count", "int", option)
        for option in options(read(call.machine, call.args[0]))
    )


def _cast(call: NativeCall) -> Value:
    """std::chrono::duration_cast<T>(duration)."""
    types = call.keywords.get("types")
    value = read(call.machine, call.args[0])
    wanted = types.items[0] if isinstance(types, Tuple) and types.items else None
    return value if wanted is None else as_duration(call.machine, value, wanted)


def _constant(count: int) -> NativeFunction:
    return lambda call: _new(call.machine, unit_of(_NANO) or Fraction(1), Const(count))


def _literal(suffix: str) -> NativeFunction:
    """What `500ms` makes of the number."""
    unit = _UNITS[_SUFFIXES[suffix]]

    def make(call: NativeCall) -> Value:
        count = read(call.machine, call.args[0])
        if suffix == "s" and isinstance(count, Const) and isinstance(count.value, str):
            return count  # "text"s
        whole = not (isinstance(count, Const) and isinstance(count.value, float))
        return _new(call.machine, unit, count, whole=whole)

    return make


def _now(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.RANDOM, call.name)


def _asked(call: NativeCall) -> Value:
    """Something of a point of time."""
    return unknown_from(call.machine, call.name, "", read(call.machine, call.args[0])) if call.args else _now(call)


def _abs(call: NativeCall) -> Value:
    """std::chrono::abs(duration)."""
    value = read(call.machine, call.args[0])
    if is_time(call.machine, value):
        count = _count(call.machine, value)
        if isinstance(count, Const) and isinstance(count.value, (int, float)):
            return _new(call.machine, _unit(call.machine, value), Const(abs(count.value), origins(count)))
    return unknown_from(call.machine, "abs", "", value)


def _text(call: NativeCall) -> Value:
    """What `"text"sv` makes of the text."""
    return read(call.machine, call.args[0])


_SPACES: Final = tuple(
    f"std.{outer}{inner}"
    for outer in ("", "literals.")
    for inner in ("", "chrono_literals.", "string_literals.", "string_view_literals.")
)
"""The namespaces of which a program may use the literals."""
_CLOCKS: Final = ("steady_clock", "system_clock", "high_resolution_clock")

NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.chrono.{name}.new": _make for name in (*_UNITS, "duration")},
    "std.chrono.duration.count": _count_of,
    **dict.fromkeys(("std.chrono.duration_cast", "std.chrono.round", "std.chrono.floor", "std.chrono.ceil"), _cast),
    **{f"std.chrono.{name}.zero": _constant(0) for name in (*_UNITS, "duration")},
    **{f"std.chrono.{name}.max": _constant(2**63 - 1) for name in (*_UNITS, "duration")},
    **{f"std.chrono.{name}.min": _constant(-(2**63)) for name in (*_UNITS, "duration")},
    **{f'{space}operator""{suffix}': _literal(suffix) for space in _SPACES for suffix in _SUFFIXES},
    **{f'{space}operator""sv': _text for space in _SPACES},
    **{f"std.chrono.{clock}.now": _now for clock in _CLOCKS},
    **{f"std.chrono.{clock}.{name}": _asked for clock in _CLOCKS for name in ("to_time_t", "from_time_t")},
    "std.chrono.time_point.new": _asked,
    "std.chrono.abs": _abs,
}
