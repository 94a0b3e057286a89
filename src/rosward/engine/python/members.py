# SPDX-License-Identifier: Apache-2.0
"""What has a class under a name, and what becomes of it when it is read through an object?"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Partial, Range, Slice, Tuple
from rosward.domain.heap import CLASSES
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Ref, Text, Value
from rosward.models.python.contents import KINDS
from rosward.models.python.exceptions import is_exception

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_TYPE_NAMES: Final[dict[type, str]] = {Text: "str", Tuple: "tuple", Range: "range", Slice: "slice", Partial: "partial"}


def type_name(value: Value) -> str:
    """The name of the builtin type of a value that is not an object of the heap."""
    if value.__class__ is Const:
        return value.value.__class__.__name__
    return _TYPE_NAMES.get(value.__class__, "object")


def lookup(machine: Engine, cls: Value, name: str) -> Value | None:
    """The attribute of a class along its mro, as it stands there; None where no known class has it."""
    if cls.__class__ is not Class:
        return (
            of_native_class(machine, cls.name, name) if isinstance(cls, Native) and is_builtin_exception(cls) else None
        )
    perhaps: Value = UNBOUND
    for base in cls.mro:
        if base.__class__ is Class:
            record = machine.at(base.address)
            found: Value | None = record.attrs.get(name)
            if found is not None and found is not UNBOUND:
                if name not in record.partial:
                    return found if perhaps is UNBOUND else join(perhaps, found)
                perhaps = join(perhaps, found)  # where this class has none, that of the next one
        elif base.__class__ is Native:
            inherited = of_native_class(machine, base.name, name)
            if inherited is not None:
                return join(perhaps, inherited)
    return None if perhaps is UNBOUND else perhaps


def surely_has(machine: Engine, cls: Value, name: str) -> bool:
    """Whether a class has an attribute on each way that leads here."""
    if cls.__class__ is not Class:
        return lookup(machine, cls, name) is not None
    for base in cls.mro:
        if base.__class__ is Class:
            if machine.at(base.address).surely_has(name):
                return True
        elif base.__class__ is Native and of_native_class(machine, base.name, name) is not None:
            return True
    return False


def classes_of(machine: Engine, value: Value) -> list[Class]:
    """The classes of an object that may have been given another one; of any other, none."""
    given = machine.obj(value).attrs.get(CLASSES) if value.__class__ is Ref else None
    return [] if given is None else [c for c in options(given) if isinstance(c, Class)]


def is_builtin_exception(cls: Value) -> bool:
    """Whether a class is one of Python's own exceptions."""
    return cls.__class__ is Native and is_exception(cls.name)


def of_native_class(machine: Engine, cls: str, name: str) -> Native | None:
    """The method of a builtin class that a model in code knows; those of exceptions are inherited as in Python."""
    short = cls.removeprefix("builtins.")
    if short in KINDS:
        short = KINDS[short] if name != "__next__" else ""  # iterators are lists in models only
    bases = [b.__name__ for b in getattr(builtins, short).__mro__] if is_exception(short) else [short]
    return next((Native(f"{b}.{name}") for b in bases if machine.library.native(f"{b}.{name}")), None)


def bind(machine: Engine, found: Value, receiver: Value, cls: Value) -> Value:
    """What a class attribute becomes when read through an instance (or, for class methods, the class)."""
    if found.__class__ is Native and hasattr(builtins, found.name.removeprefix("builtins.")):
        return found  # `size = len` in a class: no function of Python, but a builtin, which takes no `self`
    if found.__class__ is Function or found.__class__ is Native:
        return BoundMethod(receiver, found)
    if found.__class__ is Descriptor:
        if found.kind == "staticmethod":
            return found.getter
        if found.kind == "classmethod":
            return BoundMethod(cls, found.getter)
        if found.getter == NONE:
            return machine.die("AttributeError", "a property without getter", sure=True)
        return machine.call(found.getter, (receiver,))
    if found.__class__ is Choice:
        return join_all(bind(machine, o, receiver, cls) for o in found.options)
    if found.__class__ is Partial and found.function.__class__ is Native:
        return BoundMethod(receiver, found)
    if found.__class__ is Ref:
        obj = machine.obj(found)
        getter = lookup(machine, obj.cls, "__get__") if obj.kind == "instance" else None
        if getter is not None:
            return machine.call(getter, (found, receiver, cls))
    return found


def is_computed(machine: Engine, value: Value, name: str, *, written: bool = False) -> bool:
    """Whether code of a class runs where an attribute of its object is asked for, or written: a property, a descriptor, `__getattr__`."""
    obj = machine.obj(value) if value.__class__ is Ref else None
    if obj is None or obj.kind != "instance" or obj.cls.__class__ is not Class:
        return False
    found = lookup(machine, obj.cls, name)
    if found is None or written:
        hook = lookup(machine, obj.cls, "__setattr__" if written else "__getattr__")
        if hook is not None and (written or name not in obj.attrs):
            return True
    return found.__class__ is Ref or (found.__class__ is Descriptor and found.kind in ("property", "cached_property"))
