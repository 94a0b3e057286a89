# SPDX-License-Identifier: Apache-2.0
"""What is a value as one of a type: by its own constructor, by a cast, as the part of it that belongs to the type?

f(const QoS & qos), f(10)       a QoS, made of 10
Base b = derived;               the part of it that is a Base
dynamic_cast<Lamp &>(x)         x, or std::bad_cast is thrown
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Ref, Unknown, Value
from rosward.engine.cpp.construct import make, part_of
from rosward.engine.cpp.constructors import constructors, is_one, least
from rosward.engine.cpp.converting import as_value, as_wanted, buffer, by_operator, cast, derives, enumerator
from rosward.engine.cpp.enumerations import is_enumeration
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted, is_message, pointee
from rosward.ir.arithmetic import UNSIGNED, WRAPPING, same_type
from rosward.models.cpp.iteration.exceptions import may_raise, raises
from rosward.models.cpp.values.conversions import convert as convert_plain
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.number_conversions import OCTETS
from rosward.models.cpp.values.owners import as_pointer
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame

__all__ = ["as_one", "convert", "copy_of_result", "is_of_another"]


def convert(machine: Engine, value: Value, type_: Value, kind: str) -> Value:
    """A value as one of a type: what a parameter or variable of that type holds, or a cast makes."""
    held = read(machine, value)
    if kind == "buffer":
        return buffer(value, held)
    if kind == "again":
        return _again(machine, value, held, type_)
    if kind in ("wrapped", "size"):
        return _wrapped(machine, held, type_, kind)
    if kind == "value":
        kind = "init"
        if held.__class__ in (Ref, Choice) and is_of_another(machine, held, type_):
            held = lift(lambda o: as_one(machine, o, type_) if is_of_another(machine, o, type_) else o, held)
    target = pointee(type_)
    if target is not None:
        held = as_wanted(machine, as_value(machine, value), type_)
    if kind == "dynamic" or (target is not None and isinstance(target, Class)):
        made = as_pointer(cast(machine, held, target if target is not None else type_, kind), type_)
        return made if kind != "dynamic" or target is not None else _of_reference(machine, made)
    if not isinstance(type_, Class):
        if isinstance(type_, Unknown) or is_message(type_):
            return _message_of(machine, held, type_)
        if is_enumeration(machine, type_):
            return enumerator(machine, dotted(type_), (held,), "copy")
        return convert_plain(machine, lift(lambda v: by_operator(machine, v, type_), held), type_, kind)
    found: list[Value] = []
    for option in options(held):
        if is_one(machine, option, type_) or isinstance(option, Unknown):
            found.append(option)
        elif kind != "init":
            found.append(by_operator(machine, option, type_) if kind == "static" else option)
        else:
            found.append(_converted(machine, option, type_))

    return join_all(found)


_SIZE: Final = TypeOf("size_t", ())
_BEYOND: Final = 2**32
"""What a number of type `unsigned int` does not reach."""


def _wrapped(machine: Engine, held: Value, type_: Value, kind: str) -> Value:
    """A whole number that an unsigned type does not hold as one of that type; a class of the program may count in another one."""
    if kind == "size":
        if any(isinstance(o, Ref) and isinstance(machine.obj(o).cls, Class) for o in options(read(machine, type_))):
            return held
        type_ = _SIZE

    def one(value: Value) -> Value:
        if not isinstance(value, Const) or type(value.value) is not int:
            return value
        leaves = value.value < 0 or (value.value >= _BEYOND and dotted(type_) == UNSIGNED)
        return convert_plain(machine, value, type_, "init") if leaves else value

    return lift(one, held)


def _again(machine: Engine, slot: Value, held: Value, type_: Value) -> Value:
    """What a variable of a type holds where that is a short or unsigned number: one that the type does not hold is written as one of it."""
    name = same_type(dotted(type_).removeprefix("std."))
    if name not in WRAPPING and name not in OCTETS:
        return held
    made = lift(lambda v: convert_plain(machine, v, type_, "init") if _is_whole(v) else v, held)
    if made != held:
        write(machine, slot, made)
    return made


def _is_whole(value: Value) -> bool:
    return isinstance(value, Const) and type(value.value) is int


def _of_reference(machine: Engine, found: Value) -> Value:
    """What `dynamic_cast<T &>(x)` gives, or throws."""
    left = [option for option in options(found) if option != NONE]
    if not left:
        return raises(machine, "bad_cast", "std::bad_cast")
    if len(left) < len(options(found)):
        may_raise(machine, "bad_cast", "std::bad_cast")
    return join_all(left)


def is_of_another(machine: Engine, value: Value, type_: Value) -> bool:
    """Whether a value may be an object of a class that derives from a type."""
    held = read(machine, value) if isinstance(type_, Class) or is_message(type_) else UNBOUND
    return any(isinstance(o, Ref) and derives(machine.obj(o).cls, type_) for o in options(held))


def as_one(machine: Engine, value: Value, type_: Value) -> Value:
    """A value of its own of a type: of an object of a class that derives from it, what belongs to the type."""

    def one(option: Value) -> Value:
        sliced = isinstance(option, Ref) and derives(machine.obj(option).cls, type_)
        return make(machine, type_, (option,), "copy") if sliced else copied(machine, option)

    return lift(one, read(machine, value))


def copy_of_result(machine: Engine, frame: Frame, value: Value) -> Value:
    """A copy of what a call gives by reference: of the type that the function is declared with."""
    if frame.returned is not None and frame.returned[0] == value and value.__class__ in (Ref, Choice):
        function = frame.returned[1]
        symbol = linked(machine).declared.get(function.code.key)  # None of a lambda
        type_: Value = NONE
        if symbol is not None and symbol.type is not None and not symbol.template:
            type_ = evaluate(machine, symbol.type, function.module)
        if is_of_another(machine, value, type_):
            return lift(
                lambda o: part_of(machine, o, type_) if is_of_another(machine, o, type_) else copied(machine, o), value
            )
    return copied(machine, value)


def _message_of(machine: Engine, value: Value, type_: Value) -> Value:
    return make(machine, type_, (), "default") if isinstance(value, Tuple) and is_message(type_) else value


def _converted(machine: Engine, value: Value, type_: Class) -> Value:
    """An object that is made of a value implicitly; the value itself where no constructor takes it."""
    if isinstance(value, Tuple):
        return make(machine, type_, (value,), "brace-copy")
    made = by_operator(machine, value, type_)
    info = linked(machine).info(type_)
    if made != value or info is None or isinstance(value, Slot):
        return made
    fitting = any(
        least(s) <= 1 <= len(s.parameters) or any(p.pack for p in s.parameters) for s in constructors(machine, info)
    )
    return make(machine, type_, (value,), "copy") if fitting else value
