# SPDX-License-Identifier: Apache-2.0
"""What do the methods of a variant or `any` do that holds an object of a class: `spec.emplace<Topic>("scan")`, `spec.index()`?"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rosward.domain.slots import Pointer, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, UNBOUND, Class, Const, Ref, Text, Value
from rosward.engine.cpp import as_type, assigning, construct, names
from rosward.engine.cpp.linked import linked
from rosward.models.cpp.containers.compounds import alternative
from rosward.models.cpp.values.boxes import unboxed
from rosward.models.cpp.values.types import method_types
from rosward.models.python.plain import int_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["of_variant"]


def of_variant(
    machine: Engine,
    slot: Value,
    value: Value,
    name: str,
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    declared: Callable[[], Value] | None,
) -> Value | None:
    """What a call gives that is one of a variant or `any`; None where it is not, as far as that can be told."""
    if name == "index" and declared is not None and not args:
        return alternative(machine, value, declared())
    if name == "valueless_by_exception":
        return FALSE
    if name in ("has_value", "type"):
        if args or not _is_known(machine, value) or _has_own(machine, value, name):
            return None
        # what it holds is still noted after `reset` and `std::move`, and null is what an empty `any` holds, and one of a pointer
        return machine.unknown(Cause.CALL, name, hint="bool" if name == "has_value" else "")
    return _emplaced(machine, slot, value, args, types, declared) if name == "emplace" and types else None


def _emplaced(
    machine: Engine,
    slot: Value,
    value: Value,
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    declared: Callable[[], Value] | None,
) -> Value | None:
    if _has_own(machine, value, "emplace"):
        return None
    type_, number = types[0], int_of(types[0])
    if number is not None:
        whole = declared() if declared is not None else None
        known = whole.arguments if isinstance(whole, TypeOf) else ()
        type_ = known[number] if number < len(known) else machine.unknown(Cause.CALL, "emplace")
    made = construct.make(machine, type_, args, "paren")
    made = made if made is UNBOUND else as_type.convert(machine, made, type_, "init")
    if made is UNBOUND or assigning.assign(machine, "=", slot, made) is UNBOUND:
        return UNBOUND
    return unboxed(machine, slot)


def _has_own(machine: Engine, value: Value, name: str) -> bool:
    """Whether the value itself has a method of that name, so that it is not one of a variant that holds it."""
    info = linked(machine).info(machine.obj(value).cls) if isinstance(value, Ref) else None
    if info is not None:
        return names.in_class(machine, info, name) is not None
    return any(machine.library.native(f"{each}.{name}") is not None for each in method_types(machine, value))


def _is_known(machine: Engine, value: Value) -> bool:
    """Whether a value is of a builtin type, one of the standard library, or a class all of whose bases are read."""
    cls = machine.obj(value).cls if isinstance(value, Ref) else None
    if isinstance(cls, Class):
        return all(isinstance(base, Class) for each in cls.mro if isinstance(each, Class) for base in each.bases)
    return isinstance(value, (Const, Text, Pointer)) or isinstance(cls, TypeOf)
