# SPDX-License-Identifier: Apache-2.0
"""What is a value that is not known, by the type that the program or an interface declares for it?

bool valid(const double & x);           x is not known, but a number
bool valid(const Pose & pose);          a pose that nobody knows: valid(pose.position) means the one function for points
float64[36] covariance                  of a message that arrives: an array of 36 numbers that are not known
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import Final

from rosward.domain.choice import lift
from rosward.domain.compound import External
from rosward.domain.heap import Obj, fields_of
from rosward.domain.series import Series
from rosward.domain.slots import Pointer, TypeOf
from rosward.domain.unknown import derived
from rosward.domain.values import Const, Ref, Unknown, Value
from rosward.models.cpp.values.types import Shape, argument, hint_of, shape_of
from rosward.models.interfaces import message_name
from rosward.models.native import Machine
from rosward.records import NamedTuple
from rosward.source.definitions import Field

__all__ = ["MESSAGE", "Declared", "typed", "unknown_sequence"]

_PLAIN: Final = frozenset({"bool", "float", "int", "str"})
_SEQUENCES: Final = frozenset({Shape.ARRAY, Shape.LIST})
_ANY: Final = TypeOf("auto", ())
_DEPTH: Final = 3
"""So deep containers of containers are told."""
_BUILTIN: Final[dict[str, Value]] = {
    "bool": TypeOf("bool", ()),
    "byte": TypeOf("unsigned char", ()),
    "char": TypeOf("unsigned char", ()),
    "float32": TypeOf("float", ()),
    "float64": TypeOf("double", ()),
    "int16": TypeOf("short", ()),
    "int32": TypeOf("int", ()),
    "int64": TypeOf("long", ()),
    "int8": TypeOf("signed char", ()),
    "string": External("std.string"),
    "uint16": TypeOf("unsigned short", ()),
    "uint32": TypeOf("unsigned int", ()),
    "uint64": TypeOf("unsigned long", ()),
    "uint8": TypeOf("unsigned char", ()),
    "wstring": External("std.u16string"),
}
"""The types of primitive fields in C++ (rosidl_generator_cpp)."""


class Declared(NamedTuple):
    """What an object is made of that stands for a value of which only the type is known; `what` tells apart what is made in one place:
    of an argument, the code that is called and the name of the parameter.
    """

    what: Hashable
    depth: int = 0


MESSAGE: Final = Declared("message")
"""What a message is made of that is a copy of one that is not known."""


def typed(machine: Machine, value: Value, type_: Value, site: Declared) -> Value:
    """The value, with a type where it had none."""

    def one(option: Value) -> Value:
        return _typed(machine, option, type_, site) if option.__class__ is Unknown and not option.hint else option

    return lift(one, value)


def _typed(machine: Machine, unknown: Unknown, type_: Value, site: Declared) -> Value:
    target = argument(type_, 0) if shape_of(type_) is Shape.POINTER else None
    whole = type_ if target is None else target
    if isinstance(whole, External) and message_name(whole.name) is not None:
        made: Value = machine.allocate(Obj("instance", whole, payload=unknown), site)
    elif target is None and site.depth < _DEPTH and shape_of(whole) in _SEQUENCES and argument(whole, 0) != _ANY:
        inner = site._replace(depth=site.depth + 1)
        element = _typed(machine, Unknown(derived(unknown.reasons)), argument(whole, 0), inner)
        made = machine.allocate(Obj("list", whole, **fields_of(Series((), element))), site)
    else:
        hint = _hint(whole) if target is None else ""
        return Unknown(unknown.reasons, hint, unknown.variable) if hint else unknown
    return Pointer(made) if target is not None and isinstance(made, Ref) else made


def _hint(type_: Value) -> str:
    """What is known of any value of a plain type."""
    hint = hint_of(type_)
    return hint if hint in _PLAIN else ""


def unknown_sequence(machine: Machine, message: Ref, name: str, field: Field, unknown: Unknown) -> Obj:
    """What a field of a message holds that is a sequence, or an array, of which nothing is known but the type of its elements."""
    type_: Value = _ANY
    element: Value = unknown
    if field.is_message:
        type_ = External(field.type.replace("/", ".msg."))
        inner = Obj("instance", type_, many=True, payload=unknown)
        element = machine.place_inner(message, f"{name}[]", inner, again=False)
    elif field.type in _BUILTIN:
        type_ = _BUILTIN[field.type]
        element = Unknown(unknown.reasons, _hint(type_))
    size = field.array.strip("[]")
    cls = TypeOf("std.array", (type_, Const(int(size)))) if size.isdecimal() else TypeOf("std.vector", (type_,))
    return Obj("list", cls, **fields_of(Series((), element)))
