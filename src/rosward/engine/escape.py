# SPDX-License-Identifier: Apache-2.0
"""What reaches code that is not known: it may call what is callable, and use any node that it can get hold of.

lib.on_key(self.stop)         stop may be called from now on, with anything
lib.run(self)                 RW202: on this node the library may create what it likes
lib.run(App(node=self))       RW202 too: it has the node by an attribute
lib.serve(Handler)            it may make a Handler, and call what nothing else calls of it
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.heap import Obj
from rosward.domain.values import BoundMethod, Class, Function, Partial, Ref, Tuple, Unknown, Value
from rosward.engine import declared

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter

BY_LIBRARY: Final = "call by a library"
BY_BASE: Final = "call by the base class"
"""Events whose callbacks give their results to code that is not known."""

_DEPTH: Final = 4
"""How many containers deep callables and nodes are looked for."""
_ATTRIBUTES: Final = 2
"""How many objects deep a node is looked for by attributes."""


def escape(machine: Interpreter, values: Iterable[Value], library: str) -> None:
    """Values reach `library`: callables may be called with anything, later, any number of times; a node may get entities."""
    seen: set[int] = set()
    for value in values:
        _reach(machine, value, library, 0, seen)


def name_of(value: Value) -> str:
    """What stands behind a value that is not known, for a finding."""
    if value.__class__ is Unknown and value.reasons:
        reason = value.reasons[0]
        return f"something unknown ({reason.cause.value}{': ' if reason.subject else ''}{reason.subject})"
    return getattr(value, "name", "") or "something unknown"


def _reach(machine: Interpreter, value: Value, library: str, depth: int, seen: set[int]) -> None:
    for option in options(value):
        if isinstance(option, (Function, BoundMethod, Partial)):
            if not _is_library(option):
                machine.schedule_book.add(machine, option, None, BY_LIBRARY)
        elif isinstance(option, Class):
            if not option.stub:
                machine.handed.setdefault(option, machine.place)
        elif isinstance(option, Tuple):
            if depth < _DEPTH:
                for item in option.items:
                    _reach(machine, item, library, depth + 1, seen)
        elif isinstance(option, Ref) and option.address not in seen:
            seen.add(option.address)
            _reach_object(machine, option, library, depth, seen)


def _is_library(value: Value) -> bool:
    while isinstance(value, (BoundMethod, Partial)):
        value = value.function
    return not isinstance(value, Function) or declared.is_model(value)


def _reach_object(machine: Interpreter, ref: Ref, library: str, depth: int, seen: set[int]) -> None:
    obj = machine.obj(ref)
    if obj.kind == "generator":
        machine.schedule_book.add(machine, ref, (), BY_LIBRARY)
    elif obj.kind == "instance":
        machine.handed.setdefault(ref, machine.place)
        if machine.log.is_node(ref.address):
            machine.report("RW202", f"a node is handed to {library}, of which it is not known what it creates")
        elif _holds_node(machine, obj, _ATTRIBUTES, {ref.address}):
            machine.report(
                "RW202", f"an object that holds a node is handed to {library}, of which it is not known what it creates"
            )
    elif depth < _DEPTH:
        for item in _contents(obj):
            _reach(machine, item, library, depth + 1, seen)


def _contents(obj: Obj) -> list[Value]:
    """The elements of a list, set or dict."""
    return [*(obj.items or ()), *obj.entries.values(), *([obj.rest] if obj.rest is not None else [])]


def _holds_node(machine: Interpreter, obj: Obj, depth: int, seen: set[int]) -> bool:
    """Whether a node is among the attributes of an object, or in what they hold."""
    work = list(obj.attrs.values()) if obj.kind == "instance" else _contents(obj)
    for value in work:
        for option in options(value):
            if isinstance(option, Tuple):
                work.extend(option.items)
            elif isinstance(option, Ref) and option.address not in seen:
                seen.add(option.address)
                if machine.log.is_node(option.address):
                    return True
                if depth > 0 and _holds_node(machine, machine.obj(option), depth - 1, seen):
                    return True
    return False
