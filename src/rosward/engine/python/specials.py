# SPDX-License-Identifier: Apache-2.0
"""Which special method of two operands goes first, and what if it gives NotImplemented?

a + b      type(a).__add__(a, b), else type(b).__radd__(b, a); the other way round where b is of a subclass that has one of its own
a < b      type(a).__lt__(a, b), else type(b).__gt__(b, a)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Native
from rosward.domain.heap import CLASSES
from rosward.domain.values import Choice, Class, Ref, Value
from rosward.engine.python import members, metaclasses

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

NOT_IMPLEMENTED: Final = Native("builtins.NotImplemented")

Try = tuple[Value, str, Value]
"""An operand, its method, and what that is called with."""


def special(machine: Engine, value: Value, name: str) -> Value | None:
    """The special method of an instance of a class, or of a class of a metaclass, bound; None where there is none."""
    if value.__class__ is Class:
        return metaclasses.method(machine, value, name)
    if value.__class__ is Ref:
        obj = machine.obj(value)
        if obj.kind == "instance" and obj.cls.__class__ is Class:
            ways = [(c, members.lookup(machine, c, name)) for c in options(obj.attrs.get(CLASSES, obj.cls))]
            found = [members.bind(machine, method, value, c) for c, method in ways if method is not None]
            return join_all(found) if found else None
    return None


def one_has(machine: Engine, value: Value, *names: str) -> bool:
    """Whether a value is one of several objects of which one has such a method: what that does, the others do not (`each_apart`)."""
    return value.__class__ is Choice and any(special(machine, o, n) is not None for o in value.options for n in names)


def goes_first(machine: Engine, left: Value, right: Value, name: str) -> bool:
    """Whether the right operand is asked first: its class derives from that of the left one."""
    if not isinstance(left, Ref) or not isinstance(right, Ref):
        return False
    ours, theirs = machine.obj(left).cls, machine.obj(right).cls
    if not isinstance(ours, Class) or not isinstance(theirs, Class) or ours == theirs or ours not in theirs.mro:
        return False
    return members.lookup(machine, theirs, name) != members.lookup(machine, ours, name)


def first_of(machine: Engine, tries: list[Try]) -> Value | None:
    """What the first method gives that does not refuse; NotImplemented where all refuse, None where there is none."""
    found: list[Value] = []
    for operand, name, argument in tries:
        method = special(machine, operand, name)
        if method is None:
            continue
        made = machine.call(method, (argument,))
        answers = [o for o in options(made) if o != NOT_IMPLEMENTED]
        found += answers
        if len(answers) == len(options(made)):
            return join_all(found)
    return (join_all(found) if found else NOT_IMPLEMENTED) if found or _any(machine, tries) else None


def refused(made: Value) -> bool:
    """Whether every method that was asked gave NotImplemented."""
    return made == NOT_IMPLEMENTED


def _any(machine: Engine, tries: list[Try]) -> bool:
    return any(special(machine, operand, name) is not None for operand, name, _ in tries)
