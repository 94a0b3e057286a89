# SPDX-License-Identifier: Apache-2.0
"""What is a value that can be called: which function is behind it, and which parameters does it take, as they are written?

[this](const Msg & m) {…}                       a lambda with one parameter
std::bind(&Talker::on, this, _1, _2)            of `Talker::on`, the parameters in whose places _1 and _2 stand
"""

from __future__ import annotations

import re
from typing import Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer
from rosward.domain.values import NONE, Function, Value
from rosward.ir.symbols import TypePattern
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine

__all__ = ["function_behind", "leading", "mentions", "parameters", "plain_callable"]

_DEPTH: Final = 8
_PLACEHOLDER: Final = re.compile(r"(?:(?:std|boost)\.)?(?:placeholders\.)?_(\d)")


def plain_callable(machine: Machine, value: Value) -> Value:
    """The callable itself: what stands at a slot, the functions of one name as functions with their object."""

    def one(option: Value) -> Value:
        if isinstance(option, Pointer):
            option = read(machine, option.target)
        if not isinstance(option, Overloads):
            return option
        several: list[Value] = [
            BoundMethod(option.receiver, f) if option.receiver is not None and leading(f) else f
            for f in option.functions
        ]
        return join_all(several) if several else NONE

    return lift(one, read(machine, value))


def parameters(machine: Machine, value: Value, depth: int = 0) -> tuple[TypePattern, ...] | None:
    """The types of the arguments that a callable takes, as they are written; None where that is not known."""
    value = plain_callable(machine, value)
    if len(options(value)) > 1:
        found = {parameters(machine, option, depth + 1) for option in options(value) if option != NONE}
        return found.pop() if len(found) == 1 else None
    if depth > _DEPTH:
        return None
    if isinstance(value, Function):
        signature = value.code.signature
        return None if signature is None else tuple(p.type for p in signature.parameters)
    if isinstance(value, BoundMethod):
        return parameters(machine, value.function, depth + 1)
    if isinstance(value, Partial):
        bound = _of_bind(value)
        if bound is not None:
            return _bound(machine, bound, depth)
        inner = parameters(machine, value.function, depth + 1)
        own = max(0, len(value.arguments) - leading(value.function))
        return None if inner is None else inner[own:]
    return None


def _of_bind(value: Partial) -> tuple[Value, ...] | None:
    """The function and the arguments of what `std::bind` made, where its placeholders do not simply stand behind the rest."""
    first = value.arguments[0] if value.arguments else None
    is_bind = isinstance(value.function, External) and isinstance(first, Tuple) and bool(first.items)
    return first.items if is_bind and isinstance(first, Tuple) else None


def function_behind(machine: Machine, value: Value) -> Value:
    """The function that a callable comes to in the end."""
    value = plain_callable(machine, value)
    for _ in range(_DEPTH):
        bound = _of_bind(value) if isinstance(value, Partial) else None
        if bound is None:
            break
        value = plain_callable(machine, bound[0])
    return value


def _bound(machine: Machine, value: tuple[Value, ...], depth: int) -> tuple[TypePattern, ...] | None:
    """Those of `std::bind(function, arguments…)`: where its placeholders stand, in their order."""
    function, *given = value
    inner = parameters(machine, function, depth + 1)
    places = {number: index for index, a in enumerate(given) if (number := _placeholder(read(machine, a)))}
    skip = leading(plain_callable(machine, function))
    found: list[TypePattern] = []
    for number in range(1, max(places, default=0) + 1):
        index = places.get(number, -1) - skip
        found.append(inner[index] if inner is not None and 0 <= index < len(inner) else TypePattern())
    return tuple(found)


def _placeholder(value: Value) -> int:
    """The number of `std::placeholders::_1`; 0 for anything else."""
    match = _PLACEHOLDER.fullmatch(value.name) if isinstance(value, (External, Native)) else None
    return int(match[1]) if match is not None else 0


def leading(function: Value) -> int:
    """How many arguments come before those that are written: the object, and what is captured by copy."""
    signature = function.code.signature if isinstance(function, Function) else None
    return signature.leading if signature is not None else 0


def mentions(pattern: TypePattern, word: str) -> bool:
    """Whether a type is written with a word in it."""
    return word in pattern.names or any(mentions(inner, word) for inner in pattern.arguments)
