# SPDX-License-Identifier: Apache-2.0
"""C++, as the engine asks for it: what it shares with Python is Python's, the rest stands in the modules beside this one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, External, Tuple
from rosward.domain.series import Series
from rosward.domain.values import Class, Ref, Value
from rosward.engine.cpp import access, calls, methods, narrowing, operators, unaware
from rosward.engine.cpp.handing import is_open, own_functions
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.packs import body_of
from rosward.engine.cpp.program import named
from rosward.engine.cpp.transfer import OWN
from rosward.engine.python.language import PYTHON
from rosward.engine.transfer import CORE
from rosward.ir.program import CPP as NAME
from rosward.models.cpp.iteration.elements import elements
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame

__all__ = ["CPP"]


def _series(machine: Engine, value: Value) -> Series:
    """The elements of a value, in order as far as that is known."""
    if isinstance(value, Tuple):
        return Series(value.items)
    found = elements(machine, value, slots=False)
    return Series(found.items) if isinstance(found, Tuple) else PYTHON.series(machine, found)


def _iterate(machine: Engine, value: Value) -> Items:
    series = _series(machine, value)
    return Items(series.head, None) if series.exact else Items(series.head, series.behind_head())


def _call_method(machine: Engine, value: Value, name: str, args: tuple[Value, ...]) -> Value:
    return methods.invoke(machine, machine.frames[-1], value, name, args, (), scope=None, own=False)


def _load_attr(machine: Engine, value: Value, name: str) -> Value:
    if isinstance(value, External) and linked(machine).symbols.is_namespace(tuple(value.name.split("."))):
        return named(machine, f"{value.name}.{name}".replace(".", "::"))
    if isinstance(value, Ref) or not machine.frames:
        return read(machine, access.member(machine, machine.frames[-1], value, name, (), own=False))
    return PYTHON.load_attr(machine, value, name)


def _store_attr(machine: Engine, target: Value, name: str, value: Value) -> bool:
    write(machine, access.member(machine, machine.frames[-1], target, name, (), own=False), value)
    return True


def _load_item(machine: Engine, value: Value, index: Value) -> Value:
    return read(machine, access.item(machine, value, index))


def _store_item(machine: Engine, target: Value, index: Value, value: Value) -> None:
    write(machine, access.item(machine, target, index), value)


def _is_stepped(_machine: Engine, _value: Value) -> bool:
    return False


def _situation(machine: Engine) -> tuple[tuple[int, Value], ...]:
    return tuple(linked(machine).constructing)


def _truth(machine: Engine, value: Value) -> bool | None:
    return operators.truth(machine, value)


def _load_module(machine: Engine, name: str, _frame: Frame | None, _level: int) -> Value:
    """A namespace, or what else there is of a dotted name."""
    return named(machine, name.replace(".", "::"))


def _implicit_calls(machine: Engine) -> tuple[Value, ...]:
    unaware.follow_left(machine)
    return ()


def _own_methods(machine: Engine, cls: Class, ref: Ref) -> Iterator[tuple[str, Value]]:
    return ((symbol.name, BoundMethod(ref, function)) for symbol, function in own_functions(machine, cls))


CPP: Final = replace(
    PYTHON,
    name=NAME,
    load_module=_load_module,
    table={**CORE, **OWN},
    run_noting=None,
    situation=_situation,
    instance=body_of,
    cells_outlive=False,
    recalls=True,
    truth=_truth,
    unary=operators.unary,
    binary=operators.binary,
    compare=operators.compare,
    may=narrowing.may,
    load_attr=_load_attr,
    store_attr=_store_attr,
    load_item=_load_item,
    store_item=_store_item,
    call=calls.call,
    call_native=calls.call_native,
    call_function=calls.call_function,
    call_method=_call_method,
    is_open=is_open,
    own_methods=_own_methods,
    implicit_calls=_implicit_calls,
    iterate=_iterate,
    series=_series,
    is_stepped=_is_stepped,
)
