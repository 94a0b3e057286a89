# SPDX-License-Identifier: Apache-2.0
"""What is a variant, `any` or `function` that held an object of a class, and was assigned something else?

std::variant<Topic, int> spec = Topic{"scan"};      the object
spec = 7;                                           a box, which stands where the object stood, and holds 7
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.heap import Obj
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.values import TRUE, Ref, Value
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine

__all__ = ["become_box", "is_box", "is_open", "may_be_another", "unboxed"]

_BOX: Final = TypeOf("std.variant", ())
_HELD: Final = "<held>"
_WAS: Final = "<was>"
_ANYTHING: Final = "<anything>"


def is_box(machine: Machine, value: Value) -> bool:
    """Whether an object has become a box, or may have."""
    return isinstance(value, Ref) and _HELD in machine.obj(value).attrs


def become_box(machine: Machine, ref: Ref, value: Value) -> None:
    """An object is no more, and something else is in its place."""
    value = copied(machine, value)
    obj = machine.obj(ref)
    if obj.many:  # another one may still be what it was
        value = join(value, _whole(machine, ref) if is_box(machine, ref) else _what_it_was(machine, obj))
    was = obj.attrs.get(_WAS, obj.cls)
    machine.update(ref, obj.replace(cls=_BOX, attrs={_HELD: value, _WAS: was}, partial=frozenset()))


def _what_it_was(machine: Machine, obj: Obj) -> Value:
    """The object that stood where a box may stand now, as one of its own."""
    attrs = {name: value for name, value in obj.attrs.items() if name not in (_HELD, _WAS)}
    partial = frozenset(name for name in obj.partial if name in attrs and obj.cls != _BOX)
    return machine.allocate(obj.replace(cls=obj.attrs.get(_WAS, obj.cls), attrs=attrs, partial=partial), "alternative")


def _whole(machine: Machine, ref: Ref) -> Value:
    """What is in a box; where one way has made it a box, and another one has not, also the object that it was."""
    obj = machine.obj(ref)
    if _HELD in obj.partial:
        held = join(obj.attrs[_HELD], _what_it_was(machine, obj))
        attrs = {_HELD: held, _WAS: obj.attrs.get(_WAS, obj.cls)}
        machine.update(ref, obj.replace(cls=_BOX, attrs=attrs, partial=frozenset()))
    return machine.obj(ref).attrs[_HELD]


def may_be_another(machine: Machine, ref: Ref) -> None:
    """Something was assigned to an object of which nobody knows the type: where that is a variant, it may hold anything now."""
    obj = machine.obj(ref)
    if obj.kind == "instance":
        machine.update(ref, obj.with_attr(_ANYTHING, TRUE))


def is_open(machine: Machine, value: Value) -> bool:
    """Whether an object may be one of another class, if a variant or `any` holds it."""
    return isinstance(value, Ref) and _ANYTHING in machine.obj(value).attrs


def unboxed(machine: Machine, value: Value) -> Value:
    """A place, or what is in the box that stands there."""
    if not any(is_box(machine, option) for option in options(read(machine, value))):
        return value
    places: list[Value] = []
    for option in options(read(machine, value)):
        if isinstance(option, Ref) and is_box(machine, option):
            held = _whole(machine, option)
            is_objects = all(isinstance(o, Ref) for o in options(held))
            places.append(held if is_objects else Slot(option, "field", _HELD))
        else:
            places.append(option)
    return join_all(places)
