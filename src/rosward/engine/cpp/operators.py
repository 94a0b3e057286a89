# SPDX-License-Identifier: Apache-2.0
"""Operators: those that classes define, then those of the language and its library.

a + b      a.operator+(b), operator+(a, b) of the namespaces of a and b, else numbers, strings, paths, iterators
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.domain.compound import External
from rosward.domain.enumerated import Whole
from rosward.domain.slots import Overloads, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Choice, Class, Const, Function, Ref, Value
from rosward.engine.cpp import calls, members, names
from rosward.engine.cpp.categories import cast_to
from rosward.engine.cpp.comparing import by_members, is_ordered_by_members
from rosward.engine.cpp.enumerations import enumeration_of, scope_of
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.overloading import fitting
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.types import type_of
from rosward.engine.cpp.values import overloads
from rosward.models.cpp import operators as plain
from rosward.models.cpp.values.boxes import unboxed
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["binary", "compare", "folded", "own_operator", "truth", "unary"]


def own_operator(machine: Engine, operator: str, args: tuple[Value, ...]) -> Value | None:
    """What an operator that a class defines gives; None where none does."""
    first = read(machine, args[0])
    if not any(_is_object(machine, a) for a in args):
        return _of_enumeration(machine, operator, args)
    seen = next(iter(cast_to(machine, args)), None)
    info = linked(machine).info(seen) if seen is not None else None
    if info is not None and operator == "=" and names.in_class(machine, info, "operator=") is None:
        return None  # the part of it is copied that is of that class
    is_object = _is_object(machine, first)
    found = members.member(machine, first, f"operator{operator}", (), info) if is_object else None
    own = found if isinstance(found, Overloads) else None
    if own is not None and (len(own.functions) > 1 or len(args) > 1) and not fitting(machine, own.functions, args[1:]):
        free = _free(machine, operator, args)
        if free is not None:
            return calls.invoke(machine, free, args)
    if own is not None:
        return calls.invoke(machine, own, args[1:])
    free = _free(machine, operator, args)
    return None if free is None else calls.invoke(machine, free, args)


def _free(machine: Engine, operator: str, args: tuple[Value, ...]) -> Overloads | None:
    """The operators of the first of the namespaces of the operands that has some that take them.

    Else those that are written with the name of a class of theirs: a friend calls the instance of a template by the name of the template.
    """
    several: list[Overloads] = []
    called: set[str] = set()
    for arg in args:
        cls = type_of(machine, arg)
        for each in cls.mro if isinstance(cls, Class) else ():
            info = linked(machine).info(each)
            scope = info.symbol.scope if info is not None else None
            if info is None or scope is None:
                continue
            found = names.in_namespace(machine, scope, f"operator{operator}", names.seeing(machine))
            if found is not None:
                several.append(overloads(machine, found, ()))
                called.add(info.symbol.name)
    taking = next((each for each in several if fitting(machine, each.functions, args)), None)
    if taking is not None:
        return taking
    written = (each.only(tuple(f for f in each.functions if _is_written_with(f, called))) for each in several)
    return next((each for each in written if each.functions), None)


def _is_written_with(function: Function, called: set[str]) -> bool:
    """Whether a parameter of a function is of a class of one of these names, as it is written."""
    signature = function.code.signature
    return signature is not None and any(not called.isdisjoint(p.type.names[-1:]) for p in signature.parameters)


def _of_enumeration(machine: Engine, operator: str, args: tuple[Value, ...]) -> Value | None:
    """`os << side`: an operator that stands where the enumeration does, and is for that."""
    for arg in args:
        enumeration = enumeration_of(read(machine, arg))
        scope = scope_of(enumeration)
        found = (
            names.in_namespace(machine, scope, f"operator{operator}", names.seeing(machine)) if enumeration else None
        )
        if found is None:
            continue
        several = overloads(machine, found, ())
        wanted = External(enumeration)
        fitting = tuple(f for f in several.functions if _takes(machine, f, wanted))
        if fitting:
            return calls.invoke(machine, several.only(fitting), args)
    return None


def _takes(machine: Engine, function: Function, type_: Value) -> bool:
    signature = function.code.signature
    patterns = [p.type for p in signature.parameters] if signature is not None else []
    return any(type_of_pattern(machine, function.module, pattern) == type_ for pattern in patterns)


def _is_object(machine: Engine, value: Value) -> bool:
    value = read(machine, value)
    return isinstance(value, Ref) and isinstance(machine.obj(value).cls, Class)


def unary(machine: Engine, operator: str, value: Value) -> Value:
    """operator value."""
    written = "!" if operator == "not" else operator
    own = own_operator(machine, written, (value,))
    if own is not None:
        return own
    held = read(machine, within(machine, value))
    if operator == "not":
        decided = truth(machine, held)
        if decided is None and held.__class__ in (Choice, Const):
            return plain.unary(machine, operator, held)
        return machine.unknown(Cause.OPERATION, "!", "bool") if decided is None else Const(not decided)
    return plain.unary(machine, operator, held)


def binary(machine: Engine, operator: str, left: Value, right: Value, *, inplace: bool = False) -> Value:
    """left operator right."""
    own = own_operator(machine, operator, (left, right)) if not inplace else None
    if own is not None:
        return own
    value = plain.binary(machine, operator, within(machine, left), within(machine, right))
    before = left.value if inplace and isinstance(left, Const) else None
    if isinstance(before, Whole) and isinstance(value, Const):  # `auto u = bytes[0]; u += 255;`
        return convert(machine, value, TypeOf(before.named, ()))
    return value


def compare(machine: Engine, operator: str, left: Value, right: Value) -> Value:
    """left operator right; `!=` and the like follow from `==` and `<=>` where only these are defined."""
    own = own_operator(machine, operator, (left, right))
    if own is None and (_is_object(machine, left) or _is_object(machine, right)):
        own = _equal(machine, operator, left, right) if operator in ("==", "!=") else None
        own = _ordered(machine, operator, left, right) if own is None and operator != "==" else own
    if own is not None:
        return own
    return plain.compare(machine, operator, read(machine, within(machine, left)), read(machine, within(machine, right)))


def _equal(machine: Engine, operator: str, left: Value, right: Value) -> Value | None:
    """What follows from an `==`, also of the operands in turn; None where there is none."""
    equal = own_operator(machine, "==", (left, right)) if operator == "!=" else None
    if equal is None:
        equal = own_operator(machine, "==", (right, left))
    if equal is None and is_ordered_by_members(machine, read(machine, left)):
        equal = by_members(machine, "==", read(machine, left), read(machine, right))
    return unary(machine, "not", equal) if equal is not None and operator == "!=" else equal


def _ordered(machine: Engine, operator: str, left: Value, right: Value) -> Value | None:
    """What follows from a `<=>`, also of the operands in turn; None where there is none."""
    order = own_operator(machine, "<=>", (left, right)) if operator != "<=>" else None
    if order is not None:
        return compare(machine, operator, order, Const(0))
    order = own_operator(machine, "<=>", (right, left))
    if order is None:
        return None
    return unary(machine, "-", order) if operator == "<=>" else compare(machine, operator, Const(0), order)


def truth(machine: Engine, value: Value) -> bool | None:
    """Whether a value counts as true; None where both may be."""
    held = read(machine, unboxed(machine, value))
    if isinstance(held, Overloads):
        return True
    if _is_object(machine, held):
        own = members.member(machine, held, "operator bool")
        if isinstance(own, Overloads):
            return truth(machine, calls.invoke(machine, own, ()))
        return truth(machine, within(machine, held)) if has_content(machine, held) else None
    return plain.truth(machine, held)


def folded(machine: Engine, operator: str, values: Sequence[Value], *, right: bool = False) -> Value:
    """`(values operator …)`; `right`: `(… operator values)` is done last."""
    if not values:
        return NONE if operator == "," else machine.unknown(Cause.OPERATION, f"{operator} of nothing")
    if operator == ",":
        return values[-1]
    first, *others = reversed(values) if right else values
    comparing = operator in ("==", "!=", "<", "<=", ">", ">=")
    result = first
    for value in others:
        pair = (value, result) if right else (result, value)
        result = compare(machine, operator, *pair) if comparing else binary(machine, operator, *pair)
    return result
