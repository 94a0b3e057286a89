# SPDX-License-Identifier: Apache-2.0
"""Which of several function templates that fit equally well is the most special one?

template<T> void add(T);    template<T> void add(T *);    template<T> void add(std::vector<T>);      add(&lamp): the second
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.values import Const, Function, Unknown, Value
from rosward.engine.cpp.categories import undominated
from rosward.engine.cpp.types import CHARACTERS, dotted, match, type_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.symbols import Signature, TypePattern

__all__ = ["is_of_functions", "mentions", "most_special"]

_ARRAYS: Final = frozenset({"array", "pointer"})


def most_special(machine: Engine, functions: list[Function], values: Sequence[Value]) -> list[Function]:
    """Those of several templates whose parameters say most of what they take, of those that take it; all where that is not known."""
    if len(functions) < 2 or any(f.code.signature is None or not f.code.signature.template for f in functions):
        return functions
    if any(type_of(machine, value).__class__ is Unknown for value in values):
        return functions
    possible = [f for f in functions if _may_take(machine, f.code.signature, values)] or functions
    said = [(f, _said(f.code.signature, len(values))) for f in possible]
    left = undominated({each for _, each in said}, _more)
    return [f for f, each in said if each in left]


def _may_take(machine: Engine, signature: Signature | None, values: Sequence[Value]) -> bool:
    if signature is None:
        return True
    names = frozenset(p.name for p in signature.template)
    bindings: dict[str, Value] = {}
    for parameter, value in zip(signature.parameters, values, strict=False):
        type_ = type_of(machine, value)
        if parameter.pack:
            return True
        if dotted(type_) == "function" and is_of_functions(parameter.type):  # whether it fits, is known
            continue
        if parameter.type.size:
            if not _is_array(value, type_):
                return False
        elif _points(parameter.type) and dotted(type_) == "array":  # which leads to its first element
            continue
        elif not match(machine, parameter.type, type_, names, bindings):
            return False
    return True


def _is_array(value: Value, type_: Value) -> bool:
    return dotted(type_) in _ARRAYS or (isinstance(value, Const) and type_ == CHARACTERS)


def is_of_functions(pattern: TypePattern) -> bool:
    """Whether a type as it is written is one of functions: a pointer to them, or `std::function<…>`."""
    return "function" in {pattern.builtin, *(each.builtin for each in pattern.arguments)}


def _points(pattern: TypePattern) -> bool:
    return pattern.pointers > 0


def _said(signature: Signature | None, count: int) -> tuple[int, ...]:
    """How much the parameters say that these many arguments are for; then whether they are none of a pack, and how many are the same."""
    if signature is None:
        return ()
    names = frozenset(p.name for p in signature.template)
    patterns = [p.type for p in signature.parameters[:count]]
    depths = [_depth(pattern, names) for pattern in patterns]
    depths += [0] * (count - len(depths))
    used = [name for pattern in patterns for name in _names(pattern, names)]
    return (*depths, int(not any(p.pack for p in signature.parameters)), len(used) - len(set(used)))


def _depth(pattern: TypePattern, names: frozenset[str]) -> int:
    """How many words of a type are no parameters."""
    own = pattern.pointers + bool(pattern.size) + (not (len(pattern.names) == 1 and pattern.names[0] in names))
    return own + sum(_depth(each, names) for each in pattern.arguments if not each.pack)


def _names(pattern: TypePattern, names: frozenset[str]) -> Iterator[str]:
    if len(pattern.names) == 1 and pattern.names[0] in names:
        yield pattern.names[0]
    for each in pattern.arguments:
        yield from _names(each, names)


def _more(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    return all(a >= b for a, b in zip(one, other, strict=True)) and one != other


def mentions(pattern: TypePattern, names: frozenset[str]) -> bool:
    """Whether one of these parameters stands in a type."""
    return any(n in names for n in pattern.names) or any(mentions(each, names) for each in pattern.arguments)
