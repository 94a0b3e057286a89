# SPDX-License-Identifier: Apache-2.0
"""Which of its alternatives does a variant or `any` hold?

std::variant<std::shared_ptr<Lamp>, int> v = 3;      no pointer, an int
"""

from __future__ import annotations

from rosward.domain.choice import options
from rosward.domain.compound import External
from rosward.domain.slots import Pointer, is_char_text
from rosward.domain.values import NONE, Class, Ref, Value
from rosward.models.cpp.values.boxes import is_open, unboxed
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, argument, hint_of, shape_of
from rosward.models.native import Machine
from rosward.models.python.comparing.compare import kind_of

__all__ = ["is_of_type"]


def is_of_type(machine: Machine, value: Value, type_: Value) -> bool | None:
    """Whether a variant holds a value of a type, as far as values tell."""
    value = read(machine, unboxed(machine, value))
    if len(options(value)) > 1:
        answers = {is_of_type(machine, option, type_) for option in options(value)}
        return answers.pop() if len(answers) == 1 else None
    shape = shape_of(type_)
    if isinstance(value, Ref):
        cls = machine.obj(value).cls
        if is_open(machine, value):
            return None
        if isinstance(cls, Class) or isinstance(type_, Class):
            return type_ in cls.mro if isinstance(cls, Class) else False
        return cls == type_ or (None if shape_of(cls) is shape else False)
    if isinstance(value, Pointer) and shape is Shape.POINTER:
        return _leads_to(machine, value, argument(type_, 0))
    kind = {"NoneType": ""}.get(kind_of(machine, value), kind_of(machine, value))
    if not kind:
        return shape in (Shape.POINTER, Shape.ANY) if value == NONE or isinstance(value, Pointer) else None
    if shape is Shape.POINTER and is_char_text(value):  # or it has become a string
        return None
    return hint_of(type_) == kind


def _leads_to(machine: Machine, pointer: Pointer, type_: Value) -> bool | None:
    """Whether a pointer is one to objects of a type; of one to a base of the object nobody knows as what it is declared."""
    target = read(machine, pointer.target)
    cls = machine.obj(target).cls if isinstance(target, Ref) else None
    if cls == type_:
        return True
    if isinstance(cls, Class) and isinstance(type_, Class):
        return None if type_ in cls.mro or cls in type_.mro else False
    return False if isinstance(cls, External) and isinstance(type_, (External, Class)) else None
