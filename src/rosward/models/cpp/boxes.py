# SPDX-License-Identifier: Apache-2.0
"""What is a variant, `any` or `function` that held an object of a class, and was assigned something else?

std::variant<Topic, int> spec = Topic{"scan"};      the object
spec = 7;                                           a box, which stands where the object stood, and holds 7
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, TRUE, Ref, Value
from rosward.models.cpp.copies import copied
from rosward.models.cpp.slots import read
from rosward.models.native import Machine

__all__ = ["become_box", "is_box", "is_open", "may_be_another", "unboxed"]

_BOX: Final = TypeOf("std.variant", ())
_HELD: Final = "<held>"
_ANYTHING: Final = "<anything>"


def is_box(machine: Machine, value: Value) -> bool:
    """Whether an object has become a box."""
    return isinstance(value, Ref) and machine.obj(value).cls == _BOX and _HELD in machine.obj(value).attrs


def become_box(machine: Machine, ref: Ref, value: Value) -> None:
    """An object is no more, and something else is in its place."""
    obj, value = machine.obj(ref), copied(machine, value)
    if obj.many:  # another one may still be what it was
        value = join(value, machine.unknown(Cause.OPERATION, "="))
    machine.update(ref, obj.replace(cls=_BOX, attrs={_HELD: value}, partial=frozenset()))


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
    found = [Slot(o, "field", _HELD) if is_box(machine, o) else o for o in options(read(machine, value))]
    places = [read(machine, place) if isinstance(read(machine, place), Ref) else place for place in found]
    return join_all(places) if places else NONE
