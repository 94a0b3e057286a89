# SPDX-License-Identifier: Apache-2.0
"""Which names in the body of an enumeration are members, and what does the body say of how they are made?

LEFT = 'left'            a member
def topic(self): …       none, but for `@member`
table = nonmember({})    none
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import BoundMethod, Descriptor, Native
from rosward.domain.values import NONE, UNBOUND, Class, Function, Ref, Value
from rosward.models.native import NativeCall
from rosward.models.python.builtins.attributes import of_python
from rosward.models.python.std.support import class_obj, is_since
from rosward.ros.distro import Distro

_NO_MEMBER: Final = (Function, Descriptor, BoundMethod)
"""What has a `__get__`: a method, not a member."""


def hook(call: NativeCall, cls: Class, name: str) -> Value | None:
    """The function that the sources give for a hook of an enumeration."""
    for base in cls.mro:
        if isinstance(base, Class) and not base.stub:
            found = call.machine.obj(class_obj(base)).attrs.get(name)
            if found is not None:
                return found.getter if isinstance(found, Descriptor) else found
    return None


def said(call: NativeCall, written: Value) -> tuple[str, Value]:
    """Whether the body says that something is a member, or none (`member(f)`, `nonmember(3)`), and what that is."""
    if isinstance(written, Ref):
        obj = call.machine.obj(written)
        if isinstance(obj.cls, Class) and obj.cls.stub and obj.cls.dotted in ("enum.member", "enum.nonmember"):
            return obj.cls.name, obj.attrs.get("value", NONE)
    return "", written


def is_member(call: NativeCall, cls: Class, name: str, value: Value) -> bool:
    """Whether a name of the body is a member: not what has a `__get__`, nor, from Python 3.13 on, a class that is written in the body."""
    if name.startswith("_") and (name.endswith("_") or name.startswith("__")):
        return False
    if isinstance(value, Class):
        return value.qualname != f"{cls.qualname}.{name}" or not is_since(call.machine, Distro.LYRICAL)
    if isinstance(value, Native):
        known = of_python(value.name)
        return known is not None and not hasattr(known, "__get__")
    if isinstance(value, Ref):
        kind = call.machine.obj(value).cls
        return not isinstance(kind, Class) or hook(call, kind, "__get__") is None
    return not isinstance(value, _NO_MEMBER) and value is not UNBOUND
