# SPDX-License-Identifier: Apache-2.0
"""Which pointer owns what it leads to?

auto p = std::make_unique<Lamp>();      p, and nobody else
p.get(), &lamp                          does not
Box other = std::move(box);             what box owned alone is other's
"""

from __future__ import annotations

from rosward.domain.choice import lift
from rosward.domain.slots import Owner, Pointer
from rosward.domain.values import Choice, Ref, Value
from rosward.models.cpp.values.types import name_of
from rosward.models.native import Machine

__all__ = ["as_pointer", "give_away", "given_away", "is_sole", "owning"]


def owning(value: Value, owner: Owner) -> Value:
    """A pointer as one that owns what it leads to, or does not."""
    return lift(lambda v: Pointer(v.target, owner) if isinstance(v, Pointer) and v.owner != owner else v, value)


def as_pointer(value: Value, type_: Value) -> Value:
    """A pointer as one of a type: one that owned something alone shares it now, as does one of which nobody knew whether it owns."""
    shared = value.__class__ in (Pointer, Choice) and name_of(type_).endswith(".shared_ptr")
    return owning(value, "shared") if shared else value


def is_sole(value: Value) -> bool:
    """Whether a value is a pointer that owns what it leads to alone: what it is given to may share that."""
    return value.__class__ is Pointer and value.owner == "unique"


def given_away(value: Value) -> Value:
    """A value that owns nothing alone any more."""
    return lift(lambda v: Pointer(v.target) if isinstance(v, Pointer) and is_sole(v) else v, value)


def give_away(machine: Machine, ref: Ref) -> None:
    """What an object owned alone belongs to its copy from then on: such an object is moved, it cannot be copied."""

    obj = machine.obj(ref)
    for value in (*obj.attrs.values(), *(obj.items or ())):
        if is_sole(value):
            break
    else:
        return
    attrs = {name: given_away(value) for name, value in obj.attrs.items()}
    machine.update(
        ref, obj.replace(attrs=attrs, items=None if obj.items is None else tuple(map(given_away, obj.items)))
    )
