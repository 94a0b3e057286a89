# SPDX-License-Identifier: Apache-2.0
"""Which functions and objects of a model lead to functions of the program, so that who calls them runs those?

@contextmanager                    what it gives is a function of the model, which holds the one of the program
@lru_cache                         what it gives is an object of the model; to call it is to call the function
partial(self.helper, 'a')          so is a partial of either
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.values import Class, Function, Ref, Value
from rosward.engine.unknown.havoc import contents

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_DEPTH: Final = 4
"""How deep functions of models, and what they hold, are looked into."""


def leads_to_program(machine: Engine, value: Value, depth: int = 0) -> bool:
    """Whether a value is, or holds where a call of it gets at it, a function of the program."""
    return depth <= _DEPTH and any(_leads(machine, option, depth + 1) for option in options(value))


def _leads(machine: Engine, value: Value, depth: int) -> bool:
    if isinstance(value, Function):
        return not value.code.is_model or any(
            leads_to_program(machine, held, depth) for cell in value.cells for held in machine.at(cell).attrs.values()
        )
    if isinstance(value, BoundMethod):
        return leads_to_program(machine, value.function, depth)
    if isinstance(value, Partial):
        given = (value.function, *value.arguments, *(v for _, v in value.keywords))
        return any(leads_to_program(machine, held, depth) for held in given)
    if isinstance(value, Tuple):
        return any(leads_to_program(machine, held, depth) for held in value.items)
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if obj.kind == "instance":
            return calls_program(machine, obj, depth)
        return obj.kind in ("list", "dict") and any(leads_to_program(machine, v, depth) for v in contents(obj))
    return False


def calls_program(machine: Engine, obj: Obj, depth: int = 0) -> bool:
    """Whether an object of a class of a model can be called, and holds a function of the program."""
    return _is_callable_of_model(machine, obj) and any(leads_to_program(machine, v, depth) for v in obj.attrs.values())


def _is_callable_of_model(machine: Engine, obj: Obj) -> bool:
    """Whether the class of an object, which a model defines, says what a call of it does."""
    cls = obj.cls
    return (
        isinstance(cls, Class)
        and cls.stub
        and any(isinstance(base, Class) and "__call__" in machine.at(base.address).attrs for base in cls.mro)
    )
