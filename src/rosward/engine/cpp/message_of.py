# SPDX-License-Identifier: Apache-2.0
"""What is a message made of: nothing, another one, an object of a class that derives from it?"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.domain.choice import lift
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Ref, Unknown, Value
from rosward.engine.cpp.converting import derives
from rosward.engine.cpp.linked import linked
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.typed import MESSAGE, typed

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["message_of"]


def message_of(machine: Engine, type_: Value, args: Sequence[Value]) -> Value:
    """A message; of one that is not known, one that may hold anything."""
    if len(args) != 1:
        return machine.allocate(Obj("instance", type_), "message")

    def one(option: Value) -> Value:
        if isinstance(option, Ref) and machine.obj(option).cls == type_:
            return copied(machine, option)
        if isinstance(option, Unknown):
            return typed(machine, option, type_, MESSAGE)
        if isinstance(option, Ref) and derives(machine.obj(option).cls, type_):
            return _message_in(machine, option, type_)
        if isinstance(option, Ref) and machine.obj(option).kind == "instance":  # a time as its message
            return typed(machine, machine.unknown(Cause.CALL, "conversion"), type_, MESSAGE)
        return machine.allocate(Obj("instance", type_), "message")

    return lift(one, read(machine, args[0]))


def _message_in(machine: Engine, ref: Ref, type_: Value) -> Value:
    """The message that an object is part of, of a class that derives from it."""
    obj = machine.obj(ref)
    infos = [linked(machine).info(cls) for cls in obj.cls.mro] if isinstance(obj.cls, Class) else []
    own = {key for info in infos if info is not None for key in info.keys.values()}
    fields = {name: copied(machine, value) for name, value in obj.attrs.items() if name not in own}
    return machine.allocate(Obj("instance", type_, fields, partial=obj.partial), "message")
