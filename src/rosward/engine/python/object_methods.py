# SPDX-License-Identifier: Apache-2.0
"""What do the methods do that every class has from `object`?

object.__setattr__(self, 'x', 1)      sets it past the class's own `__setattr__`
super().__eq__(other)                 True for the object itself, else NotImplemented
super().setup()                       where a class behind may have one that is not known
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, Class, Const, Ref, Value
from rosward.engine.python import assignment, attributes, classes, removal
from rosward.engine.python.specials import NOT_IMPLEMENTED
from rosward.engine.unknown.escape import escape

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_MOST: Final = {"__getattribute__": 2, "__delattr__": 2, "__setattr__": 3, "__eq__": 2, "__ne__": 2}
"""How many arguments those take that do something here."""
_REFUSE: Final = frozenset({"__lt__", "__le__", "__gt__", "__ge__", "__subclasshook__"})
_NOTHING: Final = frozenset({"__init__", "__init_subclass__"})
_DIFFER: Final = {"__repr__": "str", "__str__": "str", "__format__": "str", "__hash__": "int"}
"""What an address shows in."""


def call(machine: Engine, name: str, args: tuple[Value, ...]) -> Value:
    """What `object`, or `object.__method__` with the receiver first, gives."""
    if name == "object":
        return machine.allocate(Obj("instance", Native("builtins.object")))
    method = name.partition(".")[2]
    if method == "__new__" and args and args[0].__class__ is Class:
        return classes.new_instance(machine, args[0], tuple(args[1:]))
    wanted = _MOST.get(method)
    if wanted is not None and len(args) != wanted:
        return machine.die("TypeError", f"{name}() takes {wanted} arguments but {len(args)} were given")
    if method == "__getattribute__":
        return _attribute(machine, args[0], args[1])
    if method == "__setattr__":
        return _set(machine, args[0], args[1], args[2])
    if method == "__delattr__":
        return _delete(machine, args[0], args[1])
    if method in ("__eq__", "__ne__"):
        return _equal(machine, method, args[0], args[1])
    if method in _DIFFER:
        return machine.unknown(Cause.RANDOM, name, _DIFFER[method])
    if method in _REFUSE:
        return NOT_IMPLEMENTED
    if method in _NOTHING:
        return NONE
    escape(machine, args, name)
    if hasattr(object, method):
        return machine.unknown(Cause.CALL, name)
    return machine.unknown(Cause.ERROR, f"no attribute {method} in any base")


def _attribute(machine: Engine, target: Value, name: Value) -> Value:
    if target.__class__ is Ref and machine.obj(target).kind == "instance" and name.__class__ is Const:
        return attributes.plain_attribute(machine, target, str(name.value))
    return machine.unknown(Cause.OPERATION, "object.__getattribute__")


def _set(machine: Engine, target: Value, name: Value, value: Value) -> Value:
    known = [str(n.value) for n in options(name) if n.__class__ is Const]
    several = len(options(name)) > 1 or len(options(target)) > 1
    if len(known) < len(options(name)):
        machine.report("RW203", "object.__setattr__ with an unknown name")
        escape(machine, (value,), "object.__setattr__")
    for option in options(target):
        for each in known:
            if option.__class__ is Ref:
                assignment.store_past_hook(machine, option, each, value, weak=several)
    return NONE


def _delete(machine: Engine, target: Value, name: Value) -> Value:
    if name.__class__ is Const and len(options(target)) == 1:
        removal.remove(machine, target, str(name.value))
    return NONE


def _equal(machine: Engine, method: str, left: Value, right: Value) -> Value:
    """Identity; for any two others NotImplemented, whose place Python gives to the other operand, and then to identity again."""
    same = machine.compare("is", left, right)
    if same == TRUE:
        return TRUE if method == "__eq__" else FALSE
    if same == FALSE:
        return NOT_IMPLEMENTED
    return join(NOT_IMPLEMENTED, machine.unknown(Cause.OPERATION, f"object.{method}", "bool"))
