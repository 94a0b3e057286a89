# SPDX-License-Identifier: Apache-2.0
"""How does a value become text in C++: in a stream, by `std::to_string`, by `printf`, by `fmt::format`?

std::to_string(0.5)                     '0.500000'
stream << 0.5 << true                   '0.51'
snprintf(s, n, "cam%02zu", id)          Text('cam', hole)
fmt::format("{}/{:>3}", "a", 7)         'a/  7'
"""

from __future__ import annotations

import math
import re
from typing import Final

from rosward.domain.choice import lift
from rosward.domain.compound import Tuple
from rosward.domain.enumerated import Whole
from rosward.domain.slots import Pointer
from rosward.domain.text import concat, make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Text, Unknown, Value
from rosward.models.cpp.values.characters import text_behind
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction, perform
from rosward.models.python.plain import from_python, operation, origins, spread, text_of, unknown_from
from rosward.models.python.strings import text_parts
from rosward.models.python.strings.methods import NATIVES as PYTHON
from rosward.models.python.strings.percent import percent
from rosward.records import NamedTuple

__all__ = ["NATIVES", "Flags", "format_braces", "general", "printf", "shown", "to_string"]

_LENGTH: Final = re.compile(r"%%|(%[#0\- +]*(?:\*|\d+)?(?:\.(?:\*|\d*))?)(hh|h|ll|l|j|z|t|L|q)?(.)", re.DOTALL)
_WIDEST: Final = 1_000
_PLAIN_FIELD: Final = re.compile(r"\{[^{}:]*\}")


class Flags(NamedTuple):
    """How a stream shows what is put into it."""

    width: int = 0
    fill: str = " "
    precision: int = 6
    floats: str = ""
    base: int = 10
    words: bool = False
    left: bool = False
    upper: bool = False
    show_base: bool = False


def general(number: float, precision: int = 6) -> str:
    """What `%g` gives."""
    return f"%.{precision}g" % number


def shown(machine: Machine, value: Value, flags: Flags) -> Value:
    """What a stream makes of a value."""
    return spread(lambda v: _aligned(_shown(machine, v, flags), flags), read(machine, value))


def _shown(machine: Machine, value: Value, flags: Flags) -> Value:
    if isinstance(value, Text) or text_of(value) is not None:
        return value
    if isinstance(value, Const) and isinstance(value.value, Whole):
        return from_python(machine, chr(value.value % 256), value.origins, "<<")
    if isinstance(value, Const):
        return from_python(machine, _of_constant(value.value, flags), value.origins, "<<")
    if isinstance(value, Unknown):
        digits = value.hint == "int" and flags.base == 10 and not flags.width
        return Unknown(value.reasons, "int" if digits else "str")
    if isinstance(value, Pointer):
        return machine.unknown(Cause.ANEW, "address", "str")
    return unknown_from(machine, "<<", "str", value)


def _of_constant(value: object, flags: Flags) -> str:
    if isinstance(value, bool):
        return str(value).lower() if flags.words else str(int(value))
    if isinstance(value, int):
        return _of_number(value, flags)
    if isinstance(value, float):
        text = _of_float(value, flags)
        return text.upper() if flags.upper else text
    return "0" if value is None else str(value)


def _of_number(value: int, flags: Flags) -> str:
    if flags.base == 10:
        return str(value)
    if value < 0:
        value += 2**32 if value >= -(2**31) else 2**64
    text = f"{value:x}" if flags.base == 16 else f"{value:o}"
    before = {16: "0x", 8: "0"}[flags.base] if flags.show_base and value else ""
    return (before + text).upper() if flags.upper else before + text


def _of_float(value: float, flags: Flags) -> str:
    if not math.isfinite(value):
        return "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"
    precision = min(flags.precision, _WIDEST)
    if flags.floats == "fixed":
        return f"{value:.{precision}f}"
    return f"{value:.{precision}e}" if flags.floats == "scientific" else general(value, precision or 1)


def _aligned(text: Value, flags: Flags) -> Value:
    """A text with the width that was asked for."""
    if not flags.width:
        return text
    plain = text_of(text)
    width = min(flags.width, _WIDEST)
    if plain is not None:
        return Const(plain.ljust(width, flags.fill) if flags.left else plain.rjust(width, flags.fill), origins(text))
    parts = parts_of(text)
    if sum(len(p) for p in parts if isinstance(p, str)) >= width:
        return text
    hole = text_parts.anything(parts)
    return make((*parts, hole) if flags.left else (hole, *parts), origins(text))


# std::to_string


def to_string(machine: Machine, value: Value) -> Value:
    """std::to_string(value)."""
    return spread(lambda v: _to_string(machine, v), read(machine, value))


def _to_string(machine: Machine, value: Value) -> Value:
    if isinstance(value, Const):
        if isinstance(value.value, float):
            text = f"{value.value:f}" if math.isfinite(value.value) else _of_float(value.value, Flags())
            return from_python(machine, text, value.origins, "to_string")
        if isinstance(value.value, (bool, int)):
            return Const(str(int(value.value)), value.origins)
        if isinstance(value.value, str) and len(value.value) == 1:
            return Const(str(ord(value.value)), value.origins)
    if isinstance(value, Unknown) and value.hint in ("int", "bool"):
        return lift(lambda v: concat((v,)), Unknown(value.reasons, "int"))
    return unknown_from(machine, "to_string", "str", value)


# printf


def printf(machine: Machine, template: Value, args: tuple[Value, ...]) -> Value:
    """What `printf(template, args…)` writes."""
    template, values = text_behind(machine, read(machine, template)), [read(machine, arg) for arg in args]
    text = text_of(template)
    if text is None:
        return percent(machine, template, Tuple(tuple(values)))
    fields = [match for match in _LENGTH.finditer(text) if match[0] != "%%"]
    plain = _LENGTH.sub(lambda m: m[0] if m[0] == "%%" else m[1] + {"p": "s", "u": "d"}.get(m[3], m[3]), text)
    given = [n for match in fields for n in (*["*"] * match[0].count("*"), match[3])]
    if len(given) > len(values):
        return unknown_from(machine, "printf", "str", *values)
    ready = tuple(_for_field(machine, kind, value) for kind, value in zip(given, values, strict=False))
    return percent(machine, Const(plain, origins(template)), Tuple(ready))


def _for_field(machine: Machine, kind: str, value: Value) -> Value:
    """An argument as the conversion takes it."""

    if kind == "s":
        value = text_behind(machine, value)

    def one(option: Value) -> Value:
        if kind == "p":
            return machine.unknown(Cause.ANEW, "address", "str")
        if isinstance(option, Const):
            if kind in "diuoxX" and isinstance(option.value, str) and len(option.value) == 1:
                return Const(ord(option.value), option.origins)
            if kind in "diuoxXc" and isinstance(option.value, float):
                return machine.unknown(Cause.OPERATION, "printf", "int")
            if kind in "fFeEgGaA" and isinstance(option.value, (bool, int)):
                return Const(float(option.value), option.origins)
            fits = isinstance(option.value, str) if kind == "s" else not isinstance(option.value, str) or kind == "c"
            if option == NONE or not fits or kind in "aA":
                return machine.unknown(Cause.OPERATION, "printf", "str")
        if isinstance(option, Unknown) and not option.hint:
            return Unknown(option.reasons, "str" if kind in "sc" else "int" if kind in "diu" else "float")
        return option

    return spread(one, value)


# fmt::format, std::format


def format_braces(machine: Machine, template: Value, args: tuple[Value, ...]) -> Value:
    """What `fmt::format(template, args…)` gives."""
    template, values = read(machine, template), tuple(text_behind(machine, read(machine, arg)) for arg in args)
    text = text_of(template)
    plain = text is not None and all(_PLAIN_FIELD.fullmatch(m[0]) for m in re.finditer(r"\{[^{}]*\}", text))
    given = tuple(spread(lambda v: _for_braces(machine, v, plain=plain), value) for value in values)
    return _python(machine, "str.format", template, *given)


def _for_braces(machine: Machine, value: Value, *, plain: bool) -> Value:
    if isinstance(value, Const):
        if isinstance(value.value, bool):
            return Const(str(value.value).lower(), value.origins)
        if isinstance(value.value, float) and plain:
            number = value.value
            whole = math.isfinite(number) and number == int(number)
            return machine.unknown(Cause.OPERATION, "format", "str") if whole or not math.isfinite(number) else value
        if value == NONE:
            return unknown_from(machine, "format", "str", value)
        return value
    if isinstance(value, (Text, Unknown)):
        return value
    return unknown_from(machine, "format", "str", value)


def _python(machine: Machine, name: str, *args: Value) -> Value:
    return perform(PYTHON[name], NativeCall(machine, name, args, {}))


# Natives


def _to_string_native(call: NativeCall) -> Value:
    return to_string(call.machine, call.args[0])


@operation
def _format(machine: Machine, args: tuple[Value, ...]) -> Value:
    return format_braces(machine, args[0], args[1:])


def _format_native(call: NativeCall) -> Value:
    return _format(call.machine, call.exactly(1) + call.args[1:])


def _printf_text(call: NativeCall) -> Value:
    return printf(call.machine, call.exactly(1)[0], call.args[1:])


NATIVES: Final[dict[str, NativeFunction]] = {
    "std.to_string": _to_string_native,
    "std.format": _format_native,
    "fmt.format": _format_native,
    "fmt.to_string": _format_native,
    "absl.StrFormat": _printf_text,
}


def _fmt_to_string(call: NativeCall) -> Value:
    return format_braces(call.machine, Const("{}"), call.exactly(1)[:1])


NATIVES["fmt.to_string"] = _fmt_to_string
