# SPDX-License-Identifier: Apache-2.0
"""May an object of a class be made, without saying so, of a value of another type?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import Class, ModuleValue, Value
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.types import dotted, pointee
from rosward.ir.arithmetic import INT, LONG
from rosward.ir.symbols import Symbol, SymbolKind
from rosward.models.cpp.values.number_conversions import OCTETS

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["NUMBERS", "TEXTS", "converts", "is_convertible"]

NUMBERS: Final = frozenset({INT, LONG, "bool", "double", *OCTETS.values()})
TEXTS: Final = frozenset({"std.string", "std.string_view", "string", "std.filesystem.path"})


def converts(machine: Engine, cls: Class, own: Value) -> bool:
    """Whether a class may be made of one value of a type."""
    info = linked(machine).info(cls)
    if info is None:
        return True
    found = linked(machine).members(info, info.symbol.name)
    constructors = [s for s in found if s.kind is SymbolKind.FUNCTION]
    return any(_takes_one(s) and not s.explicit and _may_be(machine, info.env, s, own) for s in constructors)


def _takes_one(symbol: Symbol) -> bool:
    least = sum(1 for p in symbol.parameters if not p.default and not p.pack)
    return least <= 1 <= len(symbol.parameters)


def _may_be(machine: Engine, env: ModuleValue, symbol: Symbol, own: Value) -> bool:
    pattern = symbol.parameters[0].type
    generic = frozenset(p.name for p in symbol.template or ())
    if any(n in generic for n in pattern.names):
        return True
    wanted = type_of_pattern(machine, env, pattern)
    name, have = dotted(wanted), dotted(own)
    if isinstance(wanted, Class):
        return False
    if have == "pointer":  # a literal: two conversions are one too many
        return pointee(wanted) is not None
    if have == "std.string":
        return name in TEXTS or pointee(wanted) is not None
    if have in NUMBERS:
        return pointee(wanted) is None and name not in TEXTS and name not in {"std.function", "function"}
    return name in {"std.function", "function"} if have == "function" else True


def is_convertible(machine: Engine, type_: Class, cls: Class) -> bool:
    """Whether an object of another class converts to one of a class, by a constructor of that."""
    info = linked(machine).info(type_)
    if info is None:
        return True
    for symbol in linked(machine).members(info, info.symbol.name):
        if symbol.kind is SymbolKind.FUNCTION and _takes_one(symbol) and not symbol.explicit:
            pattern = symbol.parameters[0].type
            if any(n in {p.name for p in symbol.template or ()} for n in pattern.names):
                return True
            if type_of_pattern(machine, info.env, pattern) in cls.mro:
                return True
    return False
