# SPDX-License-Identifier: Apache-2.0
"""What do the members of a union hold after one of them was asked for, which may be written in parts?

union {struct {int x, y;} point; int parts[2];} u;
u.point.x = 5; u.parts[0] = 1;      what is in both is not known from then on
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import options
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Value
from rosward.models.cpp.values.copies import opened, several
from rosward.models.cpp.values.shared_storage import overlapping
from rosward.models.native import Machine

__all__ = ["take_member"]

_ACTIVE: Final = "<member of a union>"
"""Of an object of a union, the member that was asked for last."""


def take_member(machine: Machine, ref: Ref, name: str) -> None:
    """A member of a union is asked for, which may be written in parts, or be read after parts of another one were: what is in objects
    that share their storage with others is not known from then on."""
    obj = machine.obj(ref)
    cls = machine.obj(Ref(obj.cls.address)) if isinstance(obj.cls, Class) else None
    others = overlapping(cls, name)
    if not others or not any(isinstance(o, Ref) for key in (*others, name) for o in options(obj.attrs.get(key, NONE))):
        return
    before = obj.attrs.get(_ACTIVE)
    if before is None or before == Const(name):
        if before is None:
            machine.update(ref, obj.with_attr(_ACTIVE, Const(name)))
        return
    unknown = machine.unknown(Cause.OPERATION, f"member of a union: {name}")
    changed: dict[str, Value] = {_ACTIVE: unknown}
    for key in (*others, name):
        held = obj.attrs.get(key, UNBOUND)
        objects = [o for o in options(held) if isinstance(o, Ref)]
        for each in objects:
            opened(machine, each, unknown)
            several(machine, each)
        changed[key] = held if objects else unknown
    machine.update(ref, machine.obj(ref).replace(attrs={**machine.obj(ref).attrs, **changed}))
