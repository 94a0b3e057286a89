# SPDX-License-Identifier: Apache-2.0
"""What do members of an enumeration do as the str or int that they are, and flags among themselves?"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Native
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Ref, Value
from rosward.models.native import NativeCall
from rosward.models.python.plain import int_of
from rosward.models.python.std.support import class_obj

OPERATORS: Final = {
    "__add__": "+",
    "__sub__": "-",
    "__mul__": "*",
    "__mod__": "%",
    "__truediv__": "/",
    "__floordiv__": "//",
    "__and__": "&",
    "__or__": "|",
    "__xor__": "^",
    "__radd__": "+",
    "__rsub__": "-",
    "__rmul__": "*",
    "__ror__": "|",
    "__rand__": "&",
}
COMPARISONS: Final = {"__eq__": "==", "__ne__": "!=", "__lt__": "<", "__le__": "<=", "__gt__": ">", "__ge__": ">="}
CONVERSIONS: Final = {"__int__": "int", "__float__": "float", "__index__": "int", "__bool__": "bool", "__len__": "len"}
_FLAG_OPERATORS: Final = ("__or__", "__and__", "__xor__", "__ror__", "__rand__")


def derives(cls: Class, *names: str) -> bool:
    """Whether a class derives from one of these."""
    return any((c.dotted if isinstance(c, Class) else getattr(c, "name", "")) in names for c in cls.mro)


def is_flag(cls: Value) -> bool:
    """Whether a class is one of flags."""
    return isinstance(cls, Class) and derives(cls, "enum.Flag", "enum.IntFlag")


def attach_operators(call: NativeCall, cls: Class, data: str) -> None:
    """What the members do as the str or int that they are, and flags among themselves."""
    own: set[str] = set()
    for base in cls.mro:
        if isinstance(base, Class) and not base.stub:
            own |= call.machine.obj(class_obj(base)).attrs.keys()
    flag = is_flag(cls)
    names: tuple[str, ...] = ()
    if data:
        names = (*OPERATORS, *COMPARISONS, *(CONVERSIONS if data != "str" else ("__len__",)))
    elif flag:
        names = (*_FLAG_OPERATORS, "__bool__")
    for name in names:
        if name not in own:
            call.machine.store_attr(cls, name, Native(f"enum.member.{name}"))


def _value_of(call: NativeCall, operand: Value) -> Value:
    """The value of a member, any other value as it is."""
    found: list[Value] = []
    for option in options(operand):
        if isinstance(option, Ref):
            obj = call.machine.obj(option)
            if obj.kind == "instance" and "_value_" in obj.attrs:
                found.append(obj.attrs["_value_"])
                continue
        found.append(option)
    return join_all(found)


def member_operation(call: NativeCall) -> Value:
    """enum.member.__add__ and the like: the operation on the values."""
    name = call.name.rpartition(".")[2]
    values = [_value_of(call, a) for a in call.args]
    if name in CONVERSIONS:
        return call.machine.call_native(f"builtins.{CONVERSIONS[name]}", values[:1])
    if len(values) < 2:
        return call.machine.unknown(Cause.OPERATION, name)
    if name in COMPARISONS:
        return call.machine.compare(COMPARISONS[name], values[0], values[1])
    if name.startswith("__r"):
        values.reverse()
    made = call.machine.binary(OPERATORS[name], values[0], values[1])
    flag = _flag_of(call) if name in _FLAG_OPERATORS else None
    if flag is None:
        return made
    if any(int_of(option) is None for option in options(made)):
        return call.machine.unknown(Cause.OPERATION, name)
    return call.machine.call_native("enum.lookup", (flag, made))


def _flag_of(call: NativeCall) -> Class | None:
    """The class of flags of which an operand is."""
    for option in (o for a in call.args for o in options(a)):
        cls = call.machine.obj(option).cls if isinstance(option, Ref) else None
        if isinstance(cls, Class) and is_flag(cls):
            return cls
    return None
