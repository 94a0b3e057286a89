# SPDX-License-Identifier: Apache-2.0
"""What is a node class made with that nothing in the sources makes, and why does making it fail?

    class Talker(Node):
        def __init__(self, name, topic='chatter', handler=None): …

name       anything
topic      'chatter', by an origin that is not settled: it names a `default` and decides no condition
handler    None, or anything
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import NONE, UNBOUND, Class, Function, Ref, Unknown, Value
from rosward.engine.arguments import ANY, MAYBE
from rosward.engine.unknown import declared
from rosward.findings import Finding
from rosward.location import Place
from rosward.models.python.plain import with_origins

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def make(machine: Engine, cls: Class) -> None:
    """Make an object of a class; where its constructor surely fails, say where."""
    machine.ended_at = {}
    if machine.call(cls, (), _arguments(machine, cls)) is not UNBOUND:
        return
    told = {f.place for f in machine.log.findings if f.code == "RW209"}
    verb = "raises" if len(machine.ended_at) == 1 else "may raise"
    for place, raised in machine.ended_at.items():
        if place not in told:
            message = f"{cls.name} cannot be created: its constructor {verb} {_named(raised)} here"
            machine.log.findings.add(Finding("RW209", message, place if place.file else cls.place))
    if not machine.ended_at and not machine.log.nodes:
        message = f"{cls.name} cannot be created: its constructor does not finish"
        machine.log.findings.add(Finding("RW209", message, cls.place))


def _arguments(machine: Engine, cls: Class) -> dict[str, Value]:
    """Whatever somebody may give, and the defaults where nobody gives anything."""
    found: dict[str, Value] = {ANY: UNBOUND}
    for constructor in options(machine.language.lookup(machine, cls, "__init__") or UNBOUND):
        if isinstance(constructor, Function) and not declared.is_model(constructor):
            place = Place(constructor.code.file, constructor.code.line)
            for name, default in _defaults(constructor):
                found[MAYBE + name] = _given(machine, name, default, place)
    return found


def _defaults(function: Function) -> Iterator[tuple[str, Value]]:
    names = function.code.parameters.positional
    yield from zip(names[len(names) - len(function.defaults) :], function.defaults, strict=True)
    yield from function.kwdefaults


def _given(machine: Engine, name: str, default: Value, place: Place) -> Value:
    """What may arrive in place of a default. One that says "nothing" says nothing of what there is otherwise."""
    if any(_is_nothing(machine, option) for option in options(default)):
        return Unknown((Reason(Cause.CALLER, name, place),))
    return with_origins(default, frozenset((Origin("argument", name),)))


def _is_nothing(machine: Engine, value: Value) -> bool:
    """None, or a container without anything in it."""
    if isinstance(value, Ref):
        obj = machine.obj(value)
        return obj.kind in ("list", "set", "dict") and obj.items == () and not obj.entries and obj.rest is None
    return value == NONE or value == Tuple(())


def _named(raised: Value) -> str:
    names = {getattr(cls, "name", "").removeprefix("builtins.") for cls in options(raised)}
    return " or ".join(sorted(names - {""})) or "an exception"
