# SPDX-License-Identifier: Apache-2.0
"""A class that inherits from its template arguments, made of functions: each call of it goes to the one that fits.

std::visit(overloaded{[](const Image & i) {…}, [](const Cloud & c) {…}}, stream);
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, External, Partial, Tuple, function_behind
from rosward.domain.values import Function, Value
from rosward.engine.cpp.linked import Info
from rosward.engine.cpp.overloading import choose
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["chosen", "is_visitor", "visitor"]

_VISITOR: Final = External("<overloaded>")


def visitor(machine: Engine, info: Info, args: Sequence[Value]) -> Partial | None:
    """What is made of functions by a class that inherits from all of them; None for any other object."""
    if not args or not any(base.pack for base in info.symbol.bases):
        return None
    held = tuple(read(machine, a) for a in args)
    if not all(isinstance(v, (Function, Partial, BoundMethod)) for v in held):
        return None
    return Partial(_VISITOR, (Tuple(held),), ())


def is_visitor(value: Partial) -> bool:
    """Whether a value is made of functions to choose from."""
    return value.function == _VISITOR


def chosen(machine: Engine, value: Partial, args: tuple[Value, ...]) -> list[Value]:
    """Those of the functions that a call means."""
    several = value.arguments[0]
    assert isinstance(several, Tuple)
    inner = [function_behind(each) for each in several.items]
    known = [f for f in inner if f is not None]
    if len(known) < len(inner):
        return list(several.items)
    meant = choose(machine, known, args, ())
    return [each for each, function in zip(several.items, inner, strict=True) if function in meant]
