# SPDX-License-Identifier: Apache-2.0
"""What stands in an object of a class that derives from a type of the standard library: its content, which is a value of that type.

class Corners : public std::vector<std::string> {…};        the object has the content as it has a field, and what the class lacks the content does
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.slots import Slot
from rosward.domain.values import UNBOUND, Class, Ref, Value
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, name_of, shape_of
from rosward.models.native import Machine

__all__ = ["CONTENT", "content_base", "has_content", "is_content", "put", "within"]

CONTENT: Final = "<content>"
"""The attribute of an object in which its content stands."""
_SHAPES: Final = frozenset(
    {
        *(Shape.ANY, Shape.ARRAY, Shape.CALLABLE, Shape.LIST, Shape.MAP, Shape.MULTIMAP, Shape.OPTIONAL, Shape.PAIR),
        *(Shape.POINTER, Shape.SET, Shape.TEXT, Shape.TUPLE),
    }
)


def is_content(base: Value) -> bool:
    """Whether a base is a type of which an object has a value as its content."""
    return not isinstance(base, Class) and name_of(base).startswith("std.") and shape_of(base) in _SHAPES


def content_base(cls: Value) -> Value | None:
    """The base of a class that is such a type."""
    return next((base for base in cls.mro if is_content(base)), None) if isinstance(cls, Class) else None


def has_content(machine: Machine, value: Value) -> bool:
    """Whether a value is an object with a content."""
    return isinstance(value, Ref) and CONTENT in machine.obj(value).attrs


def put(machine: Machine, ref: Ref, value: Value) -> bool:
    """An object has this content from now on; False where making that never ends."""
    if value is UNBOUND:
        return False
    machine.update(ref, machine.obj(ref).with_attr(CONTENT, value))
    return True


def within(machine: Machine, value: Value) -> Value:
    """Where the content of an object stands; any other value as it is."""
    found = options(read(machine, value))
    if not any(has_content(machine, option) for option in found):
        return value
    places: list[Value] = []
    for option in found:
        held = machine.obj(option).attrs.get(CONTENT) if isinstance(option, Ref) else None
        if held is None or not isinstance(option, Ref):
            places.append(option)
        else:
            is_object = all(isinstance(o, Ref) for o in options(held))
            places.append(held if is_object else Slot(option, "field", CONTENT))
    return join_all(places)
