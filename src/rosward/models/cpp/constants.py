# SPDX-License-Identifier: Apache-2.0
"""What do names of the standard library stand for that are neither functions nor types that are kept as such?

std::string::npos                       the largest `size_t`
std::is_same_v<A, B>                    whether these types are one (`traits.py`)
std::numeric_limits<int>::max           something that gives 2147483647
std::vector<T>::value_type              T
std_msgs::msg::String::SharedPtr        std::shared_ptr<std_msgs::msg::String>
"""

from __future__ import annotations

import math
import sys
from typing import Final

from rosward.domain.compound import External, Partial
from rosward.domain.heap import Obj
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Const, Ref, Value
from rosward.models.cpp.strings.string_parts import NPOS
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.traits import TRAITS
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.interfaces import message_name
from rosward.models.native import NativeCall, NativeFunction

__all__ = ["NATIVES", "known_member", "known_name"]

_CONSTANTS: Final[dict[str, Value]] = {
    **{f"std.{name}.npos": Const(NPOS) for name in ("string", "string_view", "basic_string", "wstring")},
    "std.variant_npos": Const(NPOS),
    **{
        f"std.{kind}_ordering.{name}": Const(sign)
        for kind in ("strong", "weak", "partial")
        for name, sign in (("less", -1), ("equal", 0), ("equivalent", 0), ("greater", 1))
    },
    "NULL": NONE,
    "EXIT_SUCCESS": Const(0),
    "EXIT_FAILURE": Const(1),
    "RAND_MAX": Const(2**31 - 1),
    "EOF": Const(-1),
    "SIGINT": Const(2),
    "SIGTERM": Const(15),
    "M_PI": Const(math.pi),
    "M_PI_2": Const(math.pi / 2),
    "M_PI_4": Const(math.pi / 4),
    "M_E": Const(math.e),
    "std.numbers.pi": Const(math.pi),
    "std.numbers.e": Const(math.e),
    "INFINITY": Const(math.inf),
    "NAN": Const(math.nan),
    "HUGE_VAL": Const(math.inf),
    "DBL_MAX": Const(sys.float_info.max),
    "DBL_MIN": Const(sys.float_info.min),
    "DBL_EPSILON": Const(sys.float_info.epsilon),
    **{f"INT{bits}_MAX": Const(2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)},
    **{f"INT{bits}_MIN": Const(-(2 ** (bits - 1))) for bits in (8, 16, 32, 64)},
    **{f"UINT{bits}_MAX": Const(2**bits - 1) for bits in (8, 16, 32, 64)},
    "INT_MAX": Const(2**31 - 1),
    "INT_MIN": Const(-(2**31)),
    "UINT_MAX": Const(2**32 - 1),
    "LONG_MAX": Const(2**63 - 1),
    "SIZE_MAX": Const(NPOS),
}
_FLOATS: Final = {
    "max": sys.float_info.max,
    "lowest": -sys.float_info.max,
    "min": sys.float_info.min,
    "epsilon": sys.float_info.epsilon,
    "infinity": math.inf,
    "quiet_NaN": math.nan,
    "signaling_NaN": math.nan,
    "denorm_min": 5e-324,
}
_SINGLES: Final = {
    "max": 3.4028234663852886e38,
    "lowest": -3.4028234663852886e38,
    "min": 1.1754943508222875e-38,
    "epsilon": 1.1920928955078125e-07,
}
_SIZES: Final = {"char": 8, "short": 16, "long": 64, "size_t": 64}
_OF_MESSAGES: Final = {
    f"{const}{word}": pointer
    for const in ("", "Const")
    for word, pointer in (
        ("RawPtr", "pointer"),
        ("SharedPtr", "std.shared_ptr"),
        ("UniquePtr", "std.unique_ptr"),
        ("WeakPtr", "std.weak_ptr"),
    )
}
"""The pointers that each message has names for."""
_AUTO: Final = TypeOf("auto", ())
_SIZE: Final = TypeOf("unsigned long", ())
_LIMIT: Final = External("std.numeric_limits.call")


def known_name(name: str, types: tuple[Value, ...] | None) -> Value | None:
    """The value or type that a name of a library stands for; None for one that is kept as it is."""
    if types is None:
        return _CONSTANTS.get(name)
    trait = TRAITS.get(name)
    return None if trait is None else trait(types)


def known_member(type_: Value, name: str) -> Value | None:
    """`type::name` of a type of a library."""
    whole = name_of(type_)
    arguments = type_.arguments if isinstance(type_, TypeOf) else ()
    if whole == "std.numeric_limits":
        return _limit(argument(type_, 0), name)
    if name in ("value", "type"):
        if whole == "std.integral_constant":
            return argument(type_, 1) if name == "value" else type_
        if whole in ("std.true_type", "std.false_type"):
            return Const(whole == "std.true_type") if name == "value" else type_
        if whole == "std.bool_constant":
            return argument(type_, 0)
        trait = TRAITS.get(f"{whole}_{'v' if name == 'value' else 't'}")
        return None if trait is None else trait(arguments)
    if isinstance(type_, Class):
        return None
    pointer = _OF_MESSAGES.get(name)
    if pointer is not None and isinstance(type_, External) and message_name(whole) is not None:
        return TypeOf(pointer, (type_,))
    return _member_type(type_, name)


def _member_type(type_: Value, name: str) -> Value | None:
    shape = shape_of(type_)
    if shape not in _CONTAINERS:
        return None
    if name in ("iterator", "const_iterator", "reverse_iterator", "const_reverse_iterator", "node_type"):
        return _AUTO
    if name in ("size_type", "difference_type"):
        return _SIZE
    if shape is Shape.TEXT:
        return TypeOf("char", ()) if name == "value_type" else None
    if name == "value_type" and shape in (Shape.MAP, Shape.MULTIMAP):
        return TypeOf("std.pair", (argument(type_, 0), argument(type_, 1)))
    index = {"value_type": 0, "key_type": 0, "element_type": 0, "first_type": 0, "mapped_type": 1, "second_type": 1}
    return argument(type_, index[name]) if name in index else None


_CONTAINERS: Final = frozenset(
    {
        Shape.LIST,
        Shape.ARRAY,
        Shape.SET,
        Shape.MAP,
        Shape.MULTIMAP,
        Shape.PAIR,
        Shape.POINTER,
        Shape.OPTIONAL,
        Shape.TEXT,
    }
)


def _limit(type_: Value, name: str) -> Value | None:
    """What gives a bound of a type of numbers."""
    shape = shape_of(type_)
    words = name_of(type_).removeprefix("std.").split()
    if shape is Shape.FLOAT:
        table = _SINGLES if words == ["float"] else _FLOATS
        number: float | None = table.get(name, _FLOATS.get(name))
    elif shape in (Shape.INT, Shape.CHAR, Shape.BOOL):
        number = _whole_limit(words, name)
    else:
        return None
    return None if number is None else Partial(_LIMIT, (Const(number),), ())


def _whole_limit(words: list[str], name: str) -> int | None:
    joined = " ".join(words)
    digits = "".join(c for c in joined if c.isdigit())
    bits = int(digits) if digits else next((size for word, size in _SIZES.items() if word in words), 32)
    if "bool" in words:
        return int(name == "max")
    unsigned = "unsigned" in words or joined.startswith("u") or "size_t" in words
    if name == "max":
        return (1 << (bits if unsigned else bits - 1)) - 1
    if name in ("min", "lowest"):
        return 0 if unsigned else -(1 << (bits - 1))
    return 0 if name in ("epsilon", "infinity", "quiet_NaN") else None


def _given(call: NativeCall) -> Value:
    return call.args[0]


def _value_of(call: NativeCall) -> Value:
    """`std::is_same<A, B>{}`: an object that counts as its value."""
    found = known_member(call.args[0], "value")
    return call.args[0] if found is None else found


def _limits(call: NativeCall) -> Value:
    """`std::numeric_limits<T>()`: an object whose methods are those of the type."""
    return call.machine.allocate(Obj("instance", call.args[0]), "limits")


def _limit_of(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0]) if call.args else NONE
    found = (
        _limit(argument(call.machine.obj(held).cls, 0), call.name.rpartition(".")[2]) if isinstance(held, Ref) else None
    )
    return found.arguments[0] if isinstance(found, Partial) else call.machine.unknown(Cause.OPERATION, call.name)


NATIVES: Final[dict[str, NativeFunction]] = {
    "std.numeric_limits.new": _limits,
    **{f"std.numeric_limits.{name}": _limit_of for name in _FLOATS},
    _LIMIT.name: _given,
    **{f"{name.removesuffix('_v')}.new": _value_of for name in TRAITS if name.endswith("_v")},
    **{f"std.{name}.new": _value_of for name in ("true_type", "false_type", "integral_constant", "bool_constant")},
}
