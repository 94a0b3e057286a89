# SPDX-License-Identifier: Apache-2.0
"""Which of many functions does a call mean, of whose arguments nothing is known?

Forty functions `convert(…)`, each for a message or a part of one, that call each other with parts of messages of which nobody knows the types:
a call may mean any of them. Followed as any others they would run in each order, one within the other. So each runs once within such a call,
and never again where it told the log nothing: it does nothing that the first call did not show.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Const, Function, Text, Unknown, Value
from rosward.engine.alternatives import each_apart
from rosward.engine.cpp.linked import linked
from rosward.engine.throwing import note_sources
from rosward.models.cpp.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["each", "is_guess"]

_FEW: Final = 3
"""So many functions that may be meant are followed as any others."""
_PLAIN: Final = (Const, Text, Unknown)


def is_guess(machine: Engine, chosen: Sequence[Function], args: tuple[Value, ...]) -> bool:
    """Whether a call may mean many functions, because nothing is known of what it gives them."""
    return len(chosen) > _FEW and all(isinstance(read(machine, arg), Unknown) for arg in args)


def each(machine: Engine, name: str, chosen: Sequence[Function], call: Callable[[Value], Value]) -> Value:
    """What such a call gives: of functions that run already, or that need not run again, what they gave, or anything."""
    guessed = linked(machine).guessed
    new = [function for function in chosen if function.code.key not in guessed]
    known = [guessed[function.code.key] for function in chosen if function.code.key in guessed]
    value: Value = UNBOUND
    if new:
        guessed.update(dict.fromkeys(function.code.key for function in new))
        telling: set[str] = set()
        try:
            value = each_apart(machine, new, lambda function: _run(machine, function, call, telling))
        finally:
            for key in telling:
                del guessed[key]
    if known:
        note_sources(machine)
        anything = machine.unknown(Cause.LIMIT, f"recursion of {name}")
        value = join_all([value, *(anything if each is None else each for each in known)])
    return value


def _run(machine: Engine, function: Function, call: Callable[[Value], Value], telling: set[str]) -> Value:
    """What one of them gives, which is kept where it has done nothing else; None stands for anything."""
    key, before = function.code.key, _told(machine)
    value: Value = UNBOUND
    try:
        value = call(function)
    finally:
        if _told(machine) != before:
            telling.add(key)
        elif value is not UNBOUND and all(isinstance(option, _PLAIN) for option in options(value)):
            linked(machine).guessed[key] = value
    return value


def _told(machine: Engine) -> tuple[int, ...]:
    log = machine.log
    effects = len(log.nodes), len(log.entities), len(log.sent), len(log.parameters)
    return (*effects, len(log.classes), len(machine.schedule_book.entries), len(machine.trace.handed))
