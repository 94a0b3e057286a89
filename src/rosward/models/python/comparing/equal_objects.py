# SPDX-License-Identifier: Apache-2.0
"""To what is an object equal by its class: by an `__eq__` of the program, as a named tuple, or as the number or text that it is?

class Mode(IntEnum): AUTO = 1        {1: 'a'}[Mode.AUTO], {Mode.AUTO: 'a'}[1], names[Mode.AUTO], '%d' % Mode.AUTO
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import BoundMethod, Native, Tuple
from rosward.domain.values import Class, Const, Function, Ref, Value
from rosward.models.native import Machine

_MEMBERS_COMPARE: Final = Native("enum.member.__eq__")
OF_OBJECT: Final = Native("object.__eq__")
"""By which objects are the same or differ."""


def member_value(machine: Machine, value: Value, by: str = "__eq__") -> Const | None:
    """The number or text that a member of an enumeration surely is (`IntEnum`, `class Side(str, Enum)`), and by which it compares.

    `by`: what else must not be a method of the program.
    """
    if not isinstance(value, Ref):
        return None
    obj = machine.obj(value)
    if obj.kind != "instance" or not isinstance(obj.cls, Class) or not obj.cls.enumeration or obj.many:
        return None
    if not isinstance(obj.payload, Const):
        return None
    for base in obj.cls.mro:
        if isinstance(base, Class) and not base.stub:
            own = machine.obj(Ref(base.address)).attrs
            if isinstance(own.get(by), Function):
                return None
            if "__eq__" in own or "__hash__" in own:
                return obj.payload if own.get("__eq__") == _MEMBERS_COMPARE and "__hash__" not in own else None
    return None


def row_of(machine: Machine, value: Value) -> Tuple | None:
    """A tuple, or what a named tuple holds where it is one object of a class without an `__eq__` of its own."""
    if not isinstance(value, Ref):
        return value if isinstance(value, Tuple) else None
    obj = machine.obj(value)
    is_row = isinstance(obj.cls, Class) and any(map(_is_row, obj.cls.mro))
    if not is_row or obj.many or obj.partial or has_equality(machine, obj.cls):
        return None
    fields = machine.load_attr(obj.cls, "_fields")
    names = [str(n.value) for n in fields.items if isinstance(n, Const)] if isinstance(fields, Tuple) else []
    held = [obj.attrs[n] for n in names if n in obj.attrs]
    return Tuple(tuple(held)) if names and len(held) == len(names) else None


def compares(machine: Machine, value: Value) -> bool:
    """Whether the program says by `__eq__` to what an object is equal."""
    if not isinstance(value, Ref) or member_value(machine, value) is not None:
        return False
    return has_equality(machine, machine.obj(value).cls)


def is_of_many(machine: Machine, key: Value) -> bool:
    """Whether a key is an object, or a method of one, that stands for several."""
    owner = key.receiver if isinstance(key, BoundMethod) else key
    return isinstance(owner, Ref) and machine.obj(owner).many


def has_equality(machine: Machine, cls: Value) -> bool:
    """Whether a class, or one above it, has an `__eq__` in the program, or in a model that says it in Python (`pathlib.Path`).

    A named tuple is equal to what holds the same: that is known without asking."""
    for base in cls.mro if isinstance(cls, Class) else ():
        if not isinstance(base, Class) or _is_row(base):
            continue
        own = machine.obj(Ref(base.address)).attrs.get("__eq__")
        if own == OF_OBJECT:
            return False
        if isinstance(own, Function) or (own is not None and not base.stub):
            return True
    return False


def _is_row(cls: Value) -> bool:
    return isinstance(cls, Class) and cls.stub and cls.name == "_NamedTuple"
