# SPDX-License-Identifier: Apache-2.0
"""Which methods of an object may be called from outside of its class?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, Descriptor, Partial
from rosward.domain.heap import Obj
from rosward.domain.values import Class, Function, Ref, Value
from rosward.engine.unknown.wrapped import calls_program

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

AT_MAKING: Final = frozenset({"__init__", "__new__", "__init_subclass__", "__set_name__", "__class_getitem__"})
"""Called when a class or an object is made, never later."""


def is_open(_machine: Engine, _obj: Obj) -> bool:
    """Whoever has an object may set its attributes."""
    return True


def own_methods(machine: Engine, cls: Class, ref: Ref) -> Iterator[tuple[str, Value]]:
    """The methods that sources, not models, define for an object and that others may call on it: name and bound method."""
    for base in cls.mro:
        if base.__class__ is Class and not base.stub:
            for name, value in machine.at(base.address).attrs.items():
                if name in AT_MAKING:
                    continue
                if value.__class__ is Function:
                    yield name, BoundMethod(ref, value)
                elif value.__class__ is Descriptor:
                    if value.kind in ("staticmethod", "classmethod"):
                        yield name, machine.language.bind(machine, value, ref, cls)
                    elif value.getter.__class__ is Function:
                        yield name, BoundMethod(ref, value.getter)
                elif value.__class__ is Ref and calls_program(machine, machine.obj(value)):
                    yield name, Partial(value, (ref,), ())
