# SPDX-License-Identifier: Apache-2.0
"""What is a value of which only the type is known?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Ref, Unknown, Value
from rosward.engine.cpp.types import dotted, pointee

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["opaque"]

_HINTS: Final = {
    "std.string": "str", "std.string_view": "str", "char": "str", "int": "int", "bool": "bool", "double": "float", "float": "float",
    "size_t": "int", "long": "int", "unsigned int": "int", "std.size_t": "int",
}  # fmt: skip


def opaque(machine: Engine, type_: Value, name: str) -> Value:
    """An object of a class on which no constructor was run, or something unknown of a type."""
    target = pointee(type_)
    if target is not None:
        found = opaque(machine, target, name)
        return Pointer(found) if isinstance(found, Ref) else machine.unknown(Cause.CALL, name)
    if isinstance(type_, Class):
        return machine.allocate(Obj("instance", type_), "opaque")
    if isinstance(type_, Unknown):
        return type_
    return NONE if dotted(type_) == "void" else machine.unknown(Cause.CALL, name, _HINTS.get(dotted(type_), ""))
