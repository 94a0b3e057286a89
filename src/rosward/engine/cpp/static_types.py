# SPDX-License-Identifier: Apache-2.0
"""Which type has a part of something, as it is declared: a field, what a function returns, an element, what an iterator leads to?

table.find("top")->second      for `std::map<std::string, std::shared_ptr<Sensor>> table` a pointer to a Sensor, whatever it leads to
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import lift
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.values import NONE, Class, Ref, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.names import Found
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import POINTERS, pointee, pointer_to
from rosward.ir.cpp_names import ARROW, CALLED, DOT, ELEMENT, LED, NUMBERED, UNDER
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["number_at", "of_found", "part"]

_MAPS: Final = frozenset({"std.map", "std.multimap", "std.unordered_map", "std.unordered_multimap"})
_ARRAYS: Final = frozenset({"array", "std.array", "std.deque", "std.span", "std.vector"})
_SEQUENCES: Final = _ARRAYS | {"std.initializer_list", "std.list", "std.multiset", "std.set", "std.unordered_set"}
_NUMBERS: Final = frozenset({Shape.BOOL, Shape.CHAR, Shape.FLOAT, Shape.INT})
_OF_ONE: Final = frozenset({"at", "back", "front", "top", "value", "value_or"})
_PLACES: Final = frozenset(
    f"{const}{reverse}{end}" for const in ("", "c") for reverse in ("", "r") for end in ("begin", "end")
) | {"data", "find", "lower_bound", "upper_bound"}
_SAME: Final = frozenset({"get", "lock", "release"})


def part(machine: Engine, type_: Value, which: str) -> Value:
    """The type of a part of what has a type: `.field`, `.function()`, and the others of `TypeOfValue`; none where that is not known."""
    return lift(lambda each: _part(machine, each, which), type_)


def number_at(machine: Engine, value: Value) -> Value | None:
    """The type of numbers with which a field or element is declared that a slot leads to; None where it is not known to be one."""
    if not isinstance(value, Slot) or not isinstance(value.base, Ref) or value.kind not in ("field", "item"):
        return None
    cls = machine.obj(value.base).cls
    found = _part(machine, cls, f"{DOT}{value.key}" if value.kind == "field" else ELEMENT)
    return found if shape_of(found) in _NUMBERS else None


def _numbered(type_: Value, number: int) -> Value:
    """The type of `std::get<number>(x)`: of a pair or tuple."""
    is_one = isinstance(type_, TypeOf) and type_.name in ("std.pair", "std.tuple")
    return argument(type_, number) if is_one else NONE


def _bound(machine: Engine, type_: Value, number: int) -> Value:
    """The type of that name in `auto [a, b] = x`: of a pair, a tuple, an array, or of a field of a class."""
    if not isinstance(type_, Class):
        return argument(type_, 0) if name_of(type_) in ("array", "std.array") else _numbered(type_, number)
    info = linked(machine).info(type_)
    return _part(machine, type_, f"{DOT}{info.fields[number].name}") if info and number < len(info.fields) else NONE


def of_found(machine: Engine, found: Found, *, called: bool) -> Value:
    """The type of a variable, or of what functions of that name return, where all return the same."""
    kind = SymbolKind.FUNCTION if called else SymbolKind.VARIABLE
    if any(s.kind is not kind or s.type is None or s.template for s in found.symbols):
        return NONE
    types = {evaluate(machine, s.type, found.env) for s in found.symbols if s.type is not None}
    return types.pop() if len(types) == 1 else NONE


def _part(machine: Engine, type_: Value, which: str) -> Value:
    if which.startswith(ARROW):
        return part(machine, _led(type_), f"{DOT}{which.removeprefix(ARROW)}")
    if which == LED:
        return _led(type_)
    if which == ELEMENT:
        return _each(type_)
    if which == UNDER:
        return _under(type_)
    if which.startswith(NUMBERED):
        return _bound(machine, type_, int(which.removeprefix(NUMBERED)))
    name = which.removeprefix(DOT).removesuffix(CALLED)
    called = which.endswith(CALLED)
    if isinstance(type_, Class):
        info = linked(machine).info(type_)
        found = names.in_class(machine, info, name) if info is not None else None
        return of_found(machine, found, called=called) if found is not None else NONE
    if called:
        return _of_library(type_, name)
    return _numbered(type_, 0 if name == "first" else 1) if name in ("first", "second") else NONE


def _of_library(type_: Value, name: str) -> Value:
    """What a function of a container, a pointer or an optional returns."""
    if name_of(type_) in POINTERS:
        return type_ if name in _SAME else NONE
    if name in ("size", "length") and name_of(type_).startswith("std."):
        return TypeOf("size_t", ())
    if name in _OF_ONE:
        return argument(type_, 0) if name_of(type_) in {"std.optional", "std.queue", "std.stack"} else _under(type_)
    each = _each(type_) if name in _PLACES else NONE
    return each if each == NONE else pointer_to(each)


def _led(type_: Value) -> Value:
    target = pointee(type_)
    if target is not None:
        return target
    return argument(type_, 0) if name_of(type_) == "std.optional" else NONE


def _each(type_: Value) -> Value:
    name = name_of(type_)
    if not isinstance(type_, TypeOf):
        return NONE
    if name in _MAPS:
        return TypeOf("std.pair", type_.arguments[:2]) if len(type_.arguments) > 1 else NONE
    return argument(type_, 0) if name in _SEQUENCES else NONE


def _under(type_: Value) -> Value:
    if not isinstance(type_, TypeOf):
        return NONE
    if type_.name in _MAPS:
        return argument(type_, 1)
    return argument(type_, 0) if type_.name in _SEQUENCES else _led(type_) if type_.name == "pointer" else NONE
