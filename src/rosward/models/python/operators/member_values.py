# SPDX-License-Identifier: Apache-2.0
"""Which number or text is a member of an enumeration, so that it stands for it as a key, as an index and in a format?

class Mode(IntEnum): AUTO = 1        {1: 'a'}[Mode.AUTO], {Mode.AUTO: 'a'}[1], names[Mode.AUTO], '%d' % Mode.AUTO
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Native
from rosward.domain.values import Class, Const, Ref, Value
from rosward.models.native import Machine

_MEMBERS_COMPARE: Final = Native("enum.member.__eq__")


def member_value(machine: Machine, value: Value) -> Const | None:
    """The number or text that a member of an enumeration surely is (`IntEnum`, `class Side(str, Enum)`), and by which it compares."""
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
            if "__eq__" in own or "__hash__" in own:
                return obj.payload if own.get("__eq__") == _MEMBERS_COMPARE and "__hash__" not in own else None
    return None
