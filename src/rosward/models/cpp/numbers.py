# SPDX-License-Identifier: Apache-2.0
"""`<cmath>`, `<cstdlib>`, `<string>`: numbers from texts and from numbers, and the environment.

std::stoi("12 m")           12
std::max(a, b)              the greater one, or both where that is not known
std::getenv("ROBOT_NAME")   null or a text that is not known, unless somebody sets it
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from typing import Final

from rosward.domain.certain import text_of as plain_text
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Pointer, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.elements import series_of
from rosward.models.cpp.iteration.exceptions import is_settled, may_raise, raises
from rosward.models.cpp.values.characters import text_behind
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import new_pair, read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.operators.operators import is_default
from rosward.models.python.plain import from_python, int_of, origins, spread, text_of, unknown_from, with_origins
from rosward.models.python.std.processes import launches
from rosward.models.ros.effects import own_variables
from rosward.records import NamedTuple

__all__ = ["NATIVES"]

_INT: Final = re.compile(r"\s*([+-]?\d+)")
_HEX: Final = re.compile(r"\s*([+-]?)(?:0[xX])?([0-9a-fA-F]+)")
_DIGITS: Final = re.compile(r"\s*([+-]?)(\d+)")
_PREFIX: Final = re.compile(r"\s*[+-]?0(?:([xX])[0-9a-fA-F]|[0-7])")
_FLOAT: Final = re.compile(r"\s*([+-]?(?:inf(?:inity)?|nan|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))", re.IGNORECASE)
_LIMITS: Final = {"stoi": 2**31, "stol": 2**63, "stoll": 2**63, "stoul": 2**64, "stoull": 2**64}


# Numbers from texts


class _Number(NamedTuple):
    """A number with which a text begins, and how many characters it takes."""

    value: float | int
    end: int


def _parsed(text: str, *, whole: bool, base: int) -> _Number | None:
    """The number with which a text begins."""
    if not whole:
        match = _FLOAT.match(text)
        return None if match is None else _Number(float(match[1]), match.end())
    if base == 0:
        prefix = _PREFIX.match(text)
        base = 10 if prefix is None else 16 if prefix[1] else 8
    match = _HEX.match(text) if base == 16 else _INT.match(text) if base == 10 else _DIGITS.match(text)
    if match is None:
        return None
    digits = match[1] if base == 10 else match[1] + match[2]
    end = match.end()
    while base < 10 and digits and digits[-1] not in "+-" and any(int(d) >= base for d in digits.lstrip("+-")):
        digits, end = digits[:-1], end - 1
    return _Number(int(digits, base), end) if digits.lstrip("+-") else None


def _tell_end(call: NativeCall, end: Value) -> None:
    """Where a number ends is written to who asks for it."""
    machine = call.machine
    for option in options(read(machine, call.args[1])) if len(call.args) > 1 else ():
        if isinstance(option, Pointer):
            write(machine, option.target, end)


_BASES: Final = (0, 2, 8, 10, 16)


def _stoi(call: NativeCall) -> Value:
    """std::stoi, stod and their kin: what is no number at all is an exception."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    whole = name in _LIMITS
    base = int_of(read(machine, call.args[2])) if len(call.args) > 2 else 10

    def one(value: Value) -> Value:
        text = text_of(value)
        number = None if text is None or base not in _BASES else _parsed(text, whole=whole, base=base)
        settled = text is not None and base in _BASES and is_settled(value)
        if not settled:
            may_raise(machine, "invalid_argument", name)
            may_raise(machine, "out_of_range", name)
        if number is None and not settled:
            _tell_end(call, unknown_from(machine, name, "int", value))
            return unknown_from(machine, name, "int" if whole else "float", value)
        if number is None:
            return raises(machine, "invalid_argument", name)
        if whole and not -_LIMITS[name] <= number.value < _LIMITS[name]:
            return raises(machine, "out_of_range", name)
        _tell_end(call, Const(number.end))
        return from_python(machine, number.value, origins(value), name)

    return spread(one, text_behind(machine, read(machine, call.args[0])))


def _atoi(call: NativeCall) -> Value:
    """atoi, atof: 0 for what is no number; `strtol(text, &end, base)`."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    whole = name not in ("atof", "strtod", "strtof")
    base = int_of(read(machine, call.args[2])) if len(call.args) > 2 else 10

    def one(value: Value) -> Value:
        text = text_of(value)
        if text is None or (whole and base not in _BASES):
            return unknown_from(machine, name, "int" if whole else "float", value)
        number = _parsed(text, whole=whole, base=base or 0)
        return from_python(machine, (0 if whole else 0.0) if number is None else number.value, origins(value), name)

    _tell_end(call, unknown_from(machine, name, "", read(machine, call.args[0])))
    return spread(one, text_behind(machine, read(machine, call.args[0])))


# Mathematics


def _math(function: Callable[..., float], hint: str = "float") -> NativeFunction:
    """A function of numbers; what it does not give for these is not known."""

    def compute(call: NativeCall) -> Value:
        machine = call.machine

        def one(*values: Value) -> Value:
            numbers = [v.value for v in values if isinstance(v, Const) and isinstance(v.value, (bool, int, float))]
            if len(numbers) < len(values):
                return unknown_from(machine, call.name, hint, *values)
            try:
                return from_python(machine, function(*numbers), origins(*values), call.name)
            except (ArithmeticError, TypeError, ValueError):
                return unknown_from(machine, call.name, hint, *values)

        return spread(one, *(read(machine, arg) for arg in call.args))

    return compute


def _absolute(value: float) -> float:
    return abs(value)


def _rounded(value: float) -> float:
    return float(math.floor(abs(value) + 0.5)) * (1 if value >= 0 else -1)


def _fmod(left: float, right: float) -> float:
    return math.fmod(left, right)


_MATH: Final[dict[str, Callable[..., float]]] = {
    **dict.fromkeys(("abs", "labs"), _absolute),
    "fabs": lambda v: abs(float(v)),
    "floor": lambda v: float(math.floor(v)),
    "ceil": lambda v: float(math.ceil(v)),
    "trunc": lambda v: float(math.trunc(v)),
    "round": _rounded,
    "fmod": _fmod,
    "pow": lambda a, b: float(math.pow(a, b)),
    "sqrt": math.sqrt,
    "cbrt": lambda v: math.copysign(abs(v) ** (1 / 3), v),
    "hypot": math.hypot,
    "exp": math.exp,
    "log": math.log,
    "log10": math.log10,
    "log2": math.log2,
    "sin": math.sin, "cos": math.cos, "tan": math.tan,
    "asin": math.asin, "acos": math.acos, "atan": math.atan, "atan2": math.atan2,
    "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh,
    "copysign": math.copysign,
    **dict.fromkeys(("rint", "nearbyint"), lambda v: float(round(v))),
    "remainder": math.remainder,
    "fdim": lambda a, b: float(max(a - b, 0)),
    "fma": lambda a, b, c: float(a * b + c),
    "ldexp": lambda v, n: math.ldexp(v, int(n)),
}  # fmt: skip
_ROUNDED_TO_INT: Final = ("lround", "llround", "lrint")
_QUESTIONS: Final[dict[str, Callable[..., bool]]] = {
    "isnan": math.isnan,
    "isinf": math.isinf,
    "isfinite": math.isfinite,
    "signbit": lambda v: math.copysign(1, v) < 0,
}


def _extreme(call: NativeCall) -> Value:
    """std::max(a, b), std::max({…}): the first of equal ones."""
    machine = call.machine
    first = read(machine, call.args[0])
    several = list(call.args)
    if isinstance(first, (Tuple, Ref)) and (len(call.args) == 1 or not isinstance(first, Ref)):
        series = series_of(machine, first)
        if not series.exact:
            return series.element() or machine.unknown(Cause.OPERATION, call.name)
        several = list(series.head) or [machine.unknown(Cause.OPERATION, call.name)]
    elif len(call.args) == 3:
        several = list(call.args[:2])
    several = list(_of_type(call, several))
    function = read(machine, call.args[2]) if len(call.args) == 3 else None
    best = [several[0]]
    for value in several[1:]:
        pairs = [(b, value) if call.name.endswith("max") else (value, b) for b in best]
        answers = [_is_less(machine, a, b, function) for a, b in pairs]
        if all(answers):
            best = [value]
        elif None in answers:
            best.append(value)
    source = origins(*(read(machine, value) for value in several))
    if is_default(source):  # with another value than the default, it may be another one
        best = [with_origins(read(machine, value), source) for value in best]
    return best[0] if len(best) == 1 else join_all(read(machine, value) for value in best)


def _of_type(call: NativeCall, values: Sequence[Value]) -> Sequence[Value]:
    """What is compared, as the type that is said: `std::max<int>(0, names.size() - 5)` compares with a number below zero."""
    types = call.keywords.get("types")
    if not isinstance(types, Tuple) or not types.items:
        return values
    return [convert(call.machine, read(call.machine, value), types.items[0]) for value in values]


def _is_less(machine: Machine, left: Value, right: Value, function: Value | None) -> bool | None:
    if function is not None:
        return machine.truth(machine.call(function, (left, right)))
    less = machine.compare("<", read(machine, left), read(machine, right))
    return bool(less.value) if isinstance(less, Const) else machine.truth(less)


def _clamp(call: NativeCall) -> Value:
    machine = call.machine
    value, low, high = (read(machine, arg) for arg in _of_type(call, call.exactly(3)))
    below, above = _is_less(machine, value, low, None), _is_less(machine, high, value, None)
    found = [low] if below is not False else []
    found += [high] if above is not False and not below else []
    if not below and not above:
        found.append(value)
    return join_all(found)


def _both_extremes(call: NativeCall) -> Value:
    """std::minmax(a, b), std::minmax({…})."""
    machine = call.machine
    low, high = (copied(machine, _extreme(call._replace(name=name))) for name in ("std.min", "std.max"))
    return new_pair(machine, low, high)


def _random(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.RANDOM, call.name, "int" if call.name.endswith("rand") else "")


# Characters


def _case(call: NativeCall) -> Value:
    """tolower, toupper of one character."""
    machine, name = call.machine, call.name.rpartition(".")[2]

    def one(value: Value) -> Value:
        text = text_of(value)
        if text is None and isinstance(value, Const) and isinstance(value.value, int) and 0 <= value.value < 128:
            text = chr(value.value)
        if text is None or len(text) != 1:
            return unknown_from(machine, name, "str", value)
        return Const(text.lower() if name == "tolower" else text.upper(), origins(value))

    return spread(one, read(machine, call.args[0]))


_CLASSES: Final[dict[str, Callable[[str], bool]]] = {
    "isspace": lambda c: c in " \t\n\r\v\f",
    "isdigit": lambda c: c in "0123456789",
    "isalpha": lambda c: c.isascii() and c.isalpha(),
    "isalnum": lambda c: c.isascii() and c.isalnum(),
    "isupper": lambda c: c.isascii() and c.isupper(),
    "islower": lambda c: c.isascii() and c.islower(),
    "ispunct": lambda c: c.isascii() and c.isprintable() and not c.isalnum() and c != " ",
    "isxdigit": lambda c: c in "0123456789abcdefABCDEF",
    "isprint": lambda c: c.isascii() and c.isprintable(),
}


def _is_of_class(call: NativeCall) -> Value:
    machine, name = call.machine, call.name.rpartition(".")[2]

    def one(value: Value) -> Value:
        text = text_of(convert(machine, value, _CHAR))
        if text is None or len(text) != 1:
            return unknown_from(machine, name, "bool", value)
        return Const(_CLASSES[name](text), origins(value))

    return spread(one, read(machine, call.args[0]))


_CHAR: Final = TypeOf("char", ())


# The environment, and the process


def _getenv(call: NativeCall) -> Value:
    """std::getenv(name): null, or a text; known where the deployment sets it."""
    machine = call.machine
    name = plain_text(read(machine, call.args[0]))
    variables = own_variables(machine, name)
    if name in variables:
        value = variables[name]
        return NONE if value is None else value
    unknown = machine.unknown(Cause.ENVIRONMENT, name, "str")
    return join(Unknown(unknown.reasons, "str", name), NONE)


def _exit(call: NativeCall) -> Value:
    """std::exit, std::abort, std::terminate: the path ends."""
    return call.machine.die("SystemExit", "exit", (read(call.machine, call.args[0]),) if call.args else ())


def _command(call: NativeCall) -> Value:
    """std::system(command): what it starts is told."""
    machine = call.machine
    launches(call, read(machine, call.args[0]))
    return machine.unknown(Cause.CALL, call.name, "int" if call.name.endswith("system") else "")


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


def _zero(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.CALL, call.name, "int")


_FUNCTIONS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys((*_LIMITS, "stod", "stof", "stold"), _stoi),
    **dict.fromkeys(("atoi", "atol", "atoll", "atof", "strtol", "strtoul", "strtod", "strtof"), _atoi),
    **{name: _math(function) for name, function in _MATH.items()},
    **{f"{name}f": _math(function) for name, function in _MATH.items() if name not in ("abs", "labs")},
    **{name: _math(lambda v: int(_rounded(v)), "int") for name in _ROUNDED_TO_INT},
    **{name: _math(function, "bool") for name, function in _QUESTIONS.items()},
    **dict.fromkeys(("max", "min", "fmax", "fmin"), _extreme),
    "clamp": _clamp,
    "minmax": _both_extremes,
    **dict.fromkeys(("nan", "nanf"), lambda _call: Const(math.nan)),
    "strerror": lambda call: call.machine.unknown(Cause.LIVE, "strerror", "str"),
    **dict.fromkeys(("rand", "random"), _random),
    **dict.fromkeys(("tolower", "toupper"), _case),
    **dict.fromkeys(_CLASSES, _is_of_class),
    **dict.fromkeys(("getenv", "secure_getenv"), _getenv),
    **dict.fromkeys(("exit", "abort", "_Exit", "quick_exit", "terminate"), _exit),
    **dict.fromkeys(("srand", "atexit", "signal", "free", "perror"), _nothing),
    **dict.fromkeys(("time", "clock"), _zero),
    **dict.fromkeys(("system", "popen", "execl", "execlp"), _command),
}
"""Those of C are found without `std::` as well."""
_LEAST: Final = dict.fromkeys(
    (
        *_LIMITS,
        "stod",
        "stof",
        "stold",
        "atoi",
        "atol",
        "atof",
        "max",
        "min",
        "fmax",
        "fmin",
        "minmax",
        "getenv",
        "tolower",
        "toupper",
        "system",
    ),
    1,
)

NATIVES: Final[dict[str, NativeFunction]] = {
    f"std.{name}": function for name, function in with_least(_FUNCTIONS, 0, _LEAST).items()
}
