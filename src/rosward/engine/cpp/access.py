# SPDX-License-Identifier: Apache-2.0
"""Where does a part of something stand: a field, an element, what a pointer leads to?"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import KIND
from rosward.domain.slots import Overloads, Pointer, Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.engine.cpp import calls, members
from rosward.engine.cpp.categories import class_cast_to, of_constness
from rosward.engine.cpp.converting import as_value
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.types import pointee
from rosward.engine.running.frame import Frame
from rosward.models.cpp.memory import pointer_to
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.slots import plain_number, read
from rosward.models.cpp.values.types import is_reference, name_of
from rosward.models.python.plain import text_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_ZERO: Final = Const(0)

__all__ = ["address", "deref", "fields_of", "item", "member", "types_of", "value"]


def types_of(frame: Frame, arguments: tuple[int, ...] | None) -> tuple[Value, ...]:
    """The template arguments in registers; a pack is several."""
    found: list[Value] = []
    for register in arguments or ():
        value_ = frame.registers[register]
        found += value_.items if isinstance(value_, Tuple) else (value_,)
    return tuple(found)


def value(machine: Engine, found: Value) -> Value:
    """The value at a slot; of an array of characters a pointer to the first."""
    return found if isinstance(found, Overloads) else as_value(machine, found)


def member(
    machine: Engine,
    frame: Frame,
    owner: Value,
    name: str,
    types: tuple[Value, ...],
    *,
    own: bool,
    declared: Callable[[], Value] | None = None,
) -> Value:
    """`owner.name`; `own`: of `this`, as its class sees it; `declared` gives the type that it, or the pointer to it, is declared with."""
    program = linked(machine)
    lexical = (
        program.info(frame.module)
        if own and frame.code.signature is not None and frame.code.signature.leading
        else None
    )
    if isinstance(owner, Slot) and owner.kind == "entry":  # a pair of a map: what is under the key is that of the map
        return Slot(owner.base, "item", owner.key) if name == "second" else _first(machine, owner)
    found: list[Value] = []
    for option in _led(machine, read(machine, owner), name):
        if option != NONE or len(options(owner)) == 1:
            seen = lexical if declared is None else _seen(machine, option, name, declared) or lexical
            found.append(members.member(machine, option, name, types, seen))
    return join_all(found) if found else machine.unknown(Cause.OPERATION, f"member {name} of a null pointer")


def _led(machine: Engine, value: Value, name: str) -> tuple[Value, ...]:
    """The alternatives of a value; a plain reference to a `std::reference_wrapper` is one to what that refers to."""
    several = options(value)
    if name == "get" or not any(map(is_reference, several)):
        return several
    return tuple(
        o for held in several for o in (options(read(machine, held.arguments[0])) if is_reference(held) else (held,))
    )


def _seen(machine: Engine, value: Value, name: str, declared: Callable[[], Value]) -> Info | None:
    """The class that an object is declared as, where its classes have several fields of that name."""
    program = linked(machine)
    info = program.info(machine.obj(value).cls) if isinstance(value, Ref) else None
    if info is None or name not in info.hidden:
        return None
    type_ = declared()
    target = pointee(type_)
    return program.info(target if target is not None else type_)


def _first(machine: Engine, entry: Slot) -> Value:
    pair = read(machine, entry)
    return read(machine, Slot(pair, "field", "first")) if isinstance(pair, Ref) else pair


def item(machine: Engine, owner: Value, index: Value, *, constant: bool = False) -> Value:
    """The slot of `owner[index]`; `constant`: of an object that is so."""
    held = read(machine, owner)
    found: list[Value] = []
    for option in options(held):
        if isinstance(option, Pointer):
            found.append(_beyond(machine, option, index))
        elif isinstance(option, Ref) and isinstance(machine.obj(option).cls, Class):
            operator = members.member(machine, option, "operator[]", (), class_cast_to(machine, option))
            if isinstance(operator, Overloads):
                operator = of_constness(operator, constant=constant)
            elif has_content(machine, option):
                found.append(item(machine, within(machine, option), index, constant=constant))
                continue
            found.append(calls.invoke(machine, operator, (index,)))
        elif isinstance(option, Ref):
            found.append(_element(machine, option, index))
        elif isinstance(option, Tuple):
            number = getattr(index, "value", None)
            known = isinstance(number, int) and 0 <= number < len(option.items)
            found.append(option.items[number] if known and isinstance(number, int) else join_all(option.items))
        elif isinstance(option, Unknown) or option == NONE:
            found.append(
                option if isinstance(option, Unknown) else machine.unknown(Cause.OPERATION, "element of nothing")
            )
        else:
            found.append(Slot(owner if isinstance(owner, Slot) else option, "item", plain_number(read(machine, index))))
    return join_all(found) if all(f is not UNBOUND for f in found) else UNBOUND


def _element(machine: Engine, ref: Ref, index: Value) -> Value:
    obj = machine.obj(ref)
    kind = {"list": "std.vector", "dict": "std.map"}.get(obj.kind, "")
    for name in (name_of(obj.cls), kind):
        native = machine.library.native(f"{name}.operator[]")
        if native is not None:
            return run_native(machine, native, f"{name}.operator[]", (ref, index), {})
    return Slot(ref, "item", plain_number(read(machine, index)))


def _beyond(machine: Engine, pointer: Pointer, index: Value) -> Value:
    """`p[i]`: an element of the array that a pointer leads into."""
    moved = machine.binary("+", pointer, read(machine, index))
    return moved.target if isinstance(moved, Pointer) else machine.unknown(Cause.OPERATION, "element behind a pointer")


def deref(machine: Engine, pointer: Value) -> Value:
    """What a pointer leads to, or something that works like one; of a null pointer nothing, since no execution goes on there."""
    found: list[Value] = []
    several = options(read(machine, pointer))
    for option in several:
        if isinstance(option, Pointer):
            found.append(option.target)
        elif isinstance(option, Ref):
            found.append(_object(machine, option))
        elif option == NONE:
            if len(several) == 1:
                found.append(machine.unknown(Cause.ERROR, "null pointer"))
        elif isinstance(option, Const) and text_of(option) is not None:
            found.append(Slot(option, "item", _ZERO))
        else:
            found.append(option)
    return join_all(found)


def _object(machine: Engine, ref: Ref) -> Value:
    """`*object`: of a class with that operator, an optional; else the object, for what is no pointer here may be one in the source."""
    obj = machine.obj(ref)
    if name_of(obj.cls).endswith("optional") and obj.kind == "list":
        return Slot(ref, "item", _ZERO)
    if isinstance(obj.cls, Class):
        for name in ("operator*", "operator->"):
            operator = members.member(machine, ref, name)
            if isinstance(operator, Overloads):
                given = calls.invoke(machine, operator, ())
                return deref(machine, given) if name == "operator->" else given
        if has_content(machine, ref):
            return deref(machine, within(machine, ref))
    if obj.kind == "list":
        return Slot(ref, "item", _ZERO)
    return ref


def address(machine: Engine, slot: Value) -> Value:
    """`&x`; of functions, themselves without an object; of what `new` has made that is no object, a place of its own."""
    found: list[Value] = []
    for option in options(slot):
        if isinstance(option, Overloads):
            plain = option.of(None)
            found.append(plain.functions[0] if len(plain.functions) == 1 and not plain.types else plain)
        elif isinstance(option, Ref) and name_of(machine.part(option, KIND).cls) == "array":
            found.append(Pointer(Slot(option, "item", _ZERO)))
        elif isinstance(option, (Ref, Slot)):
            found.append(Pointer(option))
        else:
            found.append(pointer_to(machine, option) if isinstance(option, (Const, Text, Pointer)) else option)
    return join_all(found)


def fields_of(machine: Engine, value_: Value) -> tuple[str, ...] | None:
    """The names of the fields of an object of a class of the program; None for anything else."""
    held = read(machine, value_)
    info = linked(machine).info(machine.obj(held).cls) if isinstance(held, Ref) else None
    return tuple(f.name for f in info.fields) if info is not None else None
