# SPDX-License-Identifier: Apache-2.0
"""What do properties, class methods and static methods give of themselves, where a program has one in its hands?

Base.state.fset(self, value)            calls the setter, as `self.state = value` does
super(type(self), type(self)).state     the property of the base, not what it gives
vars(cls)['make'].__func__              the function of a class method
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Partial
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Ref, Value
from rosward.engine.python import members

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

Arguments = tuple[Value, ...]

_PREFIX: Final = "descriptor."
_READ_BY: Final = frozenset({"property", "cached_property"})
"""The kinds of which an object gives what their function returns, and a class gives them."""
_FUNCTIONS: Final = {"property": ("fget",), "cached_property": ("func",)}
_WRAPPED: Final = ("__func__", "__wrapped__")
_METHODS: Final = frozenset({"getter", "setter", "deleter", "__get__", "__set__", "__delete__", "__set_name__"})
_OF_FUNCTION: Final = frozenset({"__doc__", "__isabstractmethod__"})


def through_class(machine: Engine, found: Value, cls: Value) -> Value:
    """What stands in a class, where the class itself is asked for it: a property as it is, since its function needs an object."""
    if found.__class__ is Descriptor and found.kind not in _READ_BY:
        return _function_of(found, cls)
    return members.bind(machine, found, NONE, cls) if found.__class__ is Ref else found


def _function_of(found: Descriptor, cls: Value) -> Value:
    return found.getter if found.kind == "staticmethod" else BoundMethod(cls, found.getter)


def load(machine: Engine, value: Descriptor, name: str) -> Value:
    """value.name"""
    if name in _FUNCTIONS.get(value.kind, _WRAPPED):
        return value.getter
    if value.kind == "property" and name in ("fset", "fdel"):
        found = value.setter if name == "fset" else value.deleter
        return NONE if found is None else found
    if name in _METHODS:
        return Partial(Native(f"{_PREFIX}{name}"), (value,), ())
    if name == "__class__":
        return Native(f"builtins.{value.kind}")
    if value.kind in _READ_BY and name not in _OF_FUNCTION:
        return machine.unknown(Cause.ERROR, f"no attribute {name} of {value.kind}")
    return machine.load_attr(value.getter, name)


def call(machine: Engine, name: str, args: Arguments) -> Value:
    """`x.setter(f)`, `x.__get__(object, class)`, `x.__set__(object, value)`: the descriptor is the first argument."""
    found, method = args[0], name.removeprefix(_PREFIX)
    if found.__class__ is not Descriptor:
        return found
    first = args[1] if len(args) > 1 else NONE
    if method == "getter":
        return Descriptor(found.kind, first, found.setter, found.deleter)
    if method == "setter":
        return Descriptor(found.kind, found.getter, first, found.deleter)
    if method == "deleter":
        return Descriptor(found.kind, found.getter, found.setter, first)
    if method == "__get__":
        return join_all(_get(machine, found, o, args[2:]) for o in options(first))
    if method in ("__set__", "__delete__"):
        return _change(machine, found.setter if method == "__set__" else found.deleter, args[1:])
    return NONE


def _get(machine: Engine, found: Descriptor, receiver: Value, owner: Arguments) -> Value:
    if receiver == NONE:
        return found if found.kind in _READ_BY else _function_of(found, owner[0] if owner else NONE)
    return members.bind(machine, found, receiver, owner[0] if owner else machine.load_attr(receiver, "__class__"))


def _change(machine: Engine, function: Value | None, args: Arguments) -> Value:
    if function is None:
        return machine.die("AttributeError", "a property without setter or deleter", sure=True)
    return UNBOUND if machine.call(function, args) is UNBOUND else NONE
