# SPDX-License-Identifier: Apache-2.0
"""Has a type a member? By that, specialisations and overloads are chosen for some types alone.

decltype(std::declval<T>().header)      the type of the field; no type where a T has none; not known where nobody knows the class
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import lift
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Value
from rosward.engine.cpp import names, static_types
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import is_message
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.values.traits import NO_TYPE, SOME_TYPE
from rosward.models.cpp.values.types import Shape, name_of, shape_of
from rosward.models.message_fields import has_field

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["lacks", "member_type"]

_PLAIN: Final = frozenset({Shape.INT, Shape.FLOAT, Shape.BOOL, Shape.CHAR, Shape.VOID})


def member_type(machine: Engine, type_: Value, name: str) -> Value:
    """The type of the member of a type; `NO_TYPE` where it has none."""
    if not name[0].isalpha() and name[0] != "_":
        return static_types.part(machine, type_, name)
    return lift(lambda each: _member_type(machine, each, name), type_)


def _member_type(machine: Engine, type_: Value, name: str) -> Value:
    if type_ == NO_TYPE:
        return NO_TYPE
    if is_message(type_):
        there = has_field(machine, type_, name)
        return _told(machine, name) if there is None else SOME_TYPE if there else NO_TYPE
    info = linked(machine).info(type_) if isinstance(type_, Class) else None
    if info is not None and info.cls is not None:
        found = names.in_class(machine, info, name)
        if found is None:
            return NO_TYPE if lacks(machine, info.cls, name) else _told(machine, name)
        symbol = found.symbols[0]
        is_field = symbol.kind is SymbolKind.VARIABLE and symbol.type is not None and len(found.symbols) == 1
        return evaluate(machine, symbol.type, found.env) if is_field and symbol.type is not None else SOME_TYPE
    if isinstance(type_, TypeOf) and shape_of(type_) in _PLAIN:
        return NO_TYPE
    native = machine.library.native(f"{name_of(type_)}.{name}")
    return SOME_TYPE if native is not None else _told(machine, name)


def lacks(machine: Engine, cls: Class, name: str) -> bool:
    """Whether a class surely has no such member: one of the sources, as all its bases are."""
    info = linked(machine).info(cls)
    is_known = info is not None and all(isinstance(each, Class) and not each.stub for each in cls.mro)
    return is_known and info is not None and names.in_class(machine, info, name) is None


def _told(machine: Engine, name: str) -> Value:
    return machine.unknown(Cause.CALL, f"whether there is a member {name}")
