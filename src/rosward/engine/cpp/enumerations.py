# SPDX-License-Identifier: Apache-2.0
"""Numbers that are values of an enumeration: functions and operators are chosen by it.

enum class Side { Left, Right };    std::ostream & operator<<(std::ostream & os, Side side);    os << Side::Left
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import lift
from rosward.domain.compound import External
from rosward.domain.slots import Enumerated
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Unknown, Value
from rosward.engine.cpp.linked import linked
from rosward.ir.symbols import SymbolKind

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["enumeration_of", "is_enumeration", "of_enumeration", "scope_of"]


def of_enumeration(machine: Engine, value: Value, enumeration: str) -> Value:
    """A number, or a value that is not known, as one of an enumeration."""

    def one(option: Value) -> Value:
        if isinstance(option, Const) and isinstance(option.value, int):
            return Const(Enumerated(int(option.value), enumeration), option.origins)
        return option if isinstance(option, Unknown) else machine.unknown(Cause.OPERATION, enumeration, "int")

    return lift(one, value) if enumeration else value


def enumeration_of(value: Value) -> str:
    """The dotted name of the enumeration that a value is of; '' for any other value."""
    return value.value.enumeration if isinstance(value, Const) and isinstance(value.value, Enumerated) else ""


def scope_of(enumeration: str) -> tuple[str, ...]:
    """The names around an enumeration."""
    return tuple(enumeration.split(".")[:-1])


def is_enumeration(machine: Engine, type_: Value) -> bool:
    """Whether a type is an enumeration of the program or a model."""
    if not isinstance(type_, External):
        return False
    known = linked(machine).enumerations
    found = known.get(type_.name)
    if found is None:
        *scope, name = type_.name.split(".")
        symbols = linked(machine).symbols.at(tuple(scope), name)
        found = known[type_.name] = any(s.kind is SymbolKind.ENUM for s in symbols)
    return found
