# SPDX-License-Identifier: Apache-2.0
"""What is a value as one of a type, where no constructor makes it: by its own operator, a cast, a number of an enumeration?

std::string(topic)          topic.operator std::string()
dynamic_cast<Node *>(p)     p, or null where the object is no Node
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External, Tuple
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Choice, Class, Const, Ref, Text, Unknown, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.categories import class_cast_to
from rosward.engine.cpp.enumerations import of_enumeration
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted
from rosward.engine.cpp.values import value_of
from rosward.ir.cpp import Form
from rosward.ir.symbols import Symbol
from rosward.models.cpp.values.contents import content_base, within
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "as_value",
    "as_wanted",
    "buffer",
    "by_operator",
    "by_operators",
    "cast",
    "decayed",
    "decaying",
    "derives",
    "enumerator",
]


def enumerator(machine: Engine, enumeration: str, args: Sequence[Value], form: Form) -> Value:
    """A value of an enumeration."""
    given = read(machine, args[0]) if args else Tuple(())
    if isinstance(given, Tuple):
        given = read(machine, given.items[0]) if given.items else NONE if form == "default" else Const(0)
    if given == NONE:
        return machine.unknown(Cause.OPERATION, f"{enumeration} without a value", "int")
    return of_enumeration(machine, given, enumeration)


def as_wanted(machine: Engine, value: Value, type_: Value) -> Value:
    """An argument; of an object that converts itself to the type, what it gives."""
    held = read(machine, value)
    if not any(isinstance(o, Ref) and isinstance(machine.obj(o).cls, Class) for o in options(held)):
        return value
    made = lift(lambda v: by_operator(machine, v, type_), held)
    return value if made == held else made


def by_operator(machine: Engine, value: Value, type_: Value) -> Value:
    """What the conversion operator of an object to a type gives; the value itself where it has none."""
    info = linked(machine).info(machine.obj(value).cls) if isinstance(value, Ref) else None
    if info is None or info.cls is None:
        return value
    base = content_base(info.cls)
    if base is not None and not isinstance(type_, Class) and shape_of(type_) is shape_of(base):
        return read(machine, within(machine, value))
    if type_ in info.cls.mro:
        return value  # never to its own class or a base of it
    wanted = dotted(type_).rpartition(".")[2]
    cast = class_cast_to(machine, value)
    seen = cast.cls if cast is not None and cast.cls is not None and cast.cls in info.cls.mro else info.cls
    for cls in seen.mro:
        own = linked(machine).info(cls)
        for symbol in own.symbol.members if own is not None else ():
            if own is None or not symbol.name.startswith("operator "):
                continue
            if symbol.name.rstrip("& ").rpartition(":")[2].split()[-1] == wanted or _gives(machine, own, symbol, type_):
                functions = linked(machine).members(own, symbol.name)
                found = value_of(machine, names.Found(tuple(functions), own.env, own), None)
                return machine.call(found.of(value), ()) if isinstance(found, Overloads) else value
    return value


def _gives(machine: Engine, own: Info, symbol: Symbol, type_: Value) -> bool:
    """Whether a conversion operator gives a type that its name does not end with: `operator std::vector<int>()`, `operator Lamp::SharedPtr()`."""
    found = evaluate(machine, symbol.type, own.env) if symbol.type is not None and not symbol.template else NONE
    while isinstance(found, TypeOf) and found.name in _AROUND:
        found = argument(found, 0)
    return found == type_


_AROUND: Final = frozenset({"const", "reference"})


def by_operators(machine: Engine, args: tuple[Value, ...], type_: Value) -> tuple[Value, ...]:
    """What is given to make an object; of one that converts itself to the type, what it gives."""
    return (as_wanted(machine, args[0], type_),) if len(args) == 1 else args


def cast(machine: Engine, value: Value, target: Value, kind: str) -> Value:
    """A pointer or reference to another class of the same object; `dynamic_cast` gives null where the object is none of that class,
    of a reference as well: nothing goes on there."""
    if kind != "dynamic":
        return value
    kept: list[Value] = []

    for option in options(value):
        ref = option.target if isinstance(option, Pointer) else option
        cls = machine.obj(ref).cls if isinstance(ref, Ref) else None
        known = isinstance(cls, Class) and not any(isinstance(b, (External, Unknown)) for b in cls.mro)
        if isinstance(cls, Class) and target in cls.mro:
            kept.append(option)
        elif known and isinstance(target, Class):
            kept.append(NONE)
        else:
            kept += [option, NONE]
    return join_all(kept)


def decayed(machine: Engine, value: Value) -> Value:
    """An array as a pointer is one to its first element."""
    is_array = isinstance(value, Ref) and dotted(machine.obj(value).cls) == "array"
    return Pointer(Slot(value, "item", Const(0))) if is_array and isinstance(value, Ref) else value


def buffer(value: Value, held: Value) -> Value:
    """A pointer to the first character of an array that is kept as a text; anything else as it is."""
    return Pointer(Slot(value, "item", Const(0))) if isinstance(value, Slot) and _is_text(held) else held


def as_value(machine: Engine, place: Value) -> Value:
    """The value at a slot; where that is an array of characters, in a field or an array or of a namespace, a pointer to the first."""
    if place.__class__ is Choice and any(_is_buffer(machine, option) for option in place.options):
        return join_all(as_value(machine, option) for option in place.options)
    held = read(machine, place)
    return buffer(place, held) if _is_buffer(machine, place) else held


def decaying(machine: Engine, args: tuple[Value, ...]) -> tuple[Value, ...]:
    """Arguments; of an array of characters a pointer to the first."""
    if not any(_is_buffer(machine, arg) for arg in args):
        return args
    return tuple(as_value(machine, arg) if _is_buffer(machine, arg) else arg for arg in args)


def _is_buffer(machine: Engine, place: Value) -> bool:
    """Whether a field, a variable of a namespace or an element of an array is declared as an array of characters."""
    if place.__class__ is not Slot or place.base.__class__ is not Ref:
        return False
    if place.kind == "item":
        cls = machine.obj(place.base).cls
        inner = argument(cls, 0) if cls.__class__ is TypeOf and cls.name == "array" else NONE
        return name_of(inner) == "array" and shape_of(inner) is Shape.TEXT
    buffers = linked(machine).buffers
    if place.kind != "field" or not buffers:
        return False
    cls = machine.obj(place.base).cls
    return (cls.address if cls.__class__ is Class else place.base.address, place.key) in buffers


def _is_text(value: Value) -> bool:
    """Whether a value is a text that is kept as one, of an array of characters."""
    return all(
        isinstance(o, Text)
        or (isinstance(o, Const) and isinstance(o.value, str))
        or (isinstance(o, Unknown) and o.hint == "str")
        for o in options(value)
    )


def derives(cls: Value, type_: Value) -> bool:
    """Whether a class has another one as a base."""
    return isinstance(cls, Class) and cls != type_ and type_ in cls.mro
