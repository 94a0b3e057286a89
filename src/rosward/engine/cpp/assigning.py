# SPDX-License-Identifier: Apache-2.0
"""Assignments: an object stays where it is and takes over what another one holds, or as much as belongs to the class that it is seen as.

x = y; x += 1; ++x            an operator that the class defines, else the copy, or the operator of the language
Base & r = d1; r = d2;        what of d1 is a Base holds the same as that of d2; d1 stays a D1
spec = 7;                     a variant that held an object holds a number
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, lift, options
from rosward.domain.compound import Tuple
from rosward.domain.enumerated import Enumerated, Whole
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf, is_char_text
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.engine.cpp import as_type, calls, construct, endings, members, names
from rosward.engine.cpp.categories import cast_to
from rosward.engine.cpp.constructors import constructors, is_copying, is_one
from rosward.engine.cpp.converting import by_operator
from rosward.engine.cpp.enumerations import enumeration_of
from rosward.engine.cpp.handing import decayed
from rosward.engine.cpp.linked import linked, record
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.operators import binary, own_operator
from rosward.engine.cpp.overloading import fitting
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import is_message, pointee
from rosward.engine.cpp.values import function_of
from rosward.engine.running.frame import Frame
from rosward.ir import cpp
from rosward.ir.core import NO_REGISTER
from rosward.models.cpp.algorithms.ranges import emit, is_inserter
from rosward.models.cpp.values.boxes import become_box, is_box, may_be_another
from rosward.models.cpp.values.characters import as_string, beside, is_character, is_text
from rosward.models.cpp.values.chrono import as_duration, is_time
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.copies import ASSIGN, copied, write
from rosward.models.cpp.values.owners import as_pointer, is_sole
from rosward.models.cpp.values.slots import plain_number, read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.message_fields import definition_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["assign", "of_field", "perform", "put_in", "step"]


def perform(machine: Engine, op: cpp.Assign, frame: Frame) -> bool | None:
    """The operation; False where it never ends."""
    slot = frame.registers[op.slot]
    cls = machine.obj(slot).cls if op.static != NO_REGISTER and isinstance(slot, Ref) else NONE
    if isinstance(cls, Class) and machine.run(op.seen, frame):
        type_ = frame.registers[op.static]
        target = pointee(type_)
        frame.cast[op.slot] = type_ if target is None else target
    src = frame.registers[op.src]
    if op.static != NO_REGISTER and _is_cell(slot) and is_sole(read(machine, src)) and machine.run(op.seen, frame):
        src = as_pointer(read(machine, src), frame.registers[op.static])
    frame.op, frame.sequence = op, 0
    done = assign(machine, op.operator, slot, src)
    if op.dst != NO_REGISTER:
        frame.registers[op.dst] = done
    return False if done is UNBOUND else None


def _is_cell(slot: Value) -> bool:
    return isinstance(slot, Slot) and slot.kind == "cell"


def assign(machine: Engine, operator: str, slot: Value, src: Value) -> Value:
    """`slot operator src`; the slot, or UNBOUND where it never ends."""
    if operator == "=" and is_inserter(read(machine, slot)) and not is_inserter(read(machine, src)):  # `*out = x`
        emit(machine, slot, Series((read(machine, src),)))
        return slot
    own = own_operator(machine, operator, (slot, src)) if operator != "=" or _says_itself(machine, slot, src) else None
    if own is not None:
        return own if own is UNBOUND else slot
    if operator != "=":
        slot = within(machine, slot)
        before = read(machine, slot)
        if _is_whole(before) and _declared(machine, slot) is not None:  # the type of the place counts
            before = plain_number(before)
        value = binary(machine, operator[:-1], before, read(machine, src), inplace=True)
        if value is UNBOUND or slot.__class__ is Pointer:  # an iterator that nobody keeps: `++names.begin()`
            return value
        if not isinstance(slot, Ref) or value != slot:
            write(machine, slot, _as_declared(machine, slot, value))
        return slot
    if not isinstance(slot, Ref) or not isinstance(machine.obj(slot).cls, Class):
        src = _without_class(machine, slot, src)
    if isinstance(slot, Ref):
        part = _part(machine, slot, src)
        return part if part is not None else _object(machine, slot, src)
    value = decayed(machine, src)
    if value.__class__ is Tuple:
        value = _of_message(machine, slot, value)
    if value.__class__ is not Unknown:
        value = copied(machine, value)
    if any(o.__class__ is Pointer or is_char_text(o) for o in options(value)) and not _holds_pointer(machine, slot):
        value = as_string(machine, value)
    before = read(machine, slot) if value.__class__ is Pointer or value == NONE else NONE
    write(machine, slot, _as_declared(machine, slot, value))
    is_left = any(_is_left(machine, option, value) for option in options(before))
    return UNBOUND if is_left and not endings.end(machine, before) else slot


def _is_left(machine: Engine, before: Value, value: Value) -> bool:
    """Whether a place that has got another value had led to an object: to another one, or to another one of several."""
    if not isinstance(before, Pointer):
        return False
    return before != value or (isinstance(before.target, Ref) and machine.obj(before.target).many)


def _without_class(machine: Engine, slot: Value, src: Value) -> Value:
    """What is assigned to what is no object of a class: the content of one, where that is what stands there."""
    if not any(has_content(machine, option) for option in options(read(machine, src))):
        return src
    before = options(read(machine, slot))
    is_plain = all(not isinstance(machine.obj(o).cls, Class) if isinstance(o, Ref) else is_text(o) for o in before)
    return within(machine, src) if is_plain else src


def _of_message(machine: Engine, slot: Value, braces: Tuple) -> Value:
    """What braces make of a field of a message that holds no object yet: `msg.name = {"shoulder", "elbow"};`."""
    if not isinstance(slot, Slot) or slot.kind != "field" or not isinstance(slot.base, Ref):
        return braces
    cls = machine.obj(slot.base).cls
    definition = definition_of(machine, cls)
    field = definition.fields.get(str(slot.key)) if definition is not None else None
    if not is_message(cls) or (field is not None and not field.array):
        return braces
    return construct.make(machine, _VECTOR, (braces,), "brace-copy")


_VECTOR: Final = TypeOf("std.vector", ())
_BYTES: Final = frozenset({"char", "unsigned char", "std.byte", "uint8_t", "std.uint8_t"})


def put_in(machine: Engine, slot: Value, made: Value) -> Value:
    """The place in which `new (pointer) T(a)` puts an object: what stands there becomes it. In memory of bytes it is an object apart."""
    return made if all(_is_byte(machine, option) for option in options(slot)) else assign(machine, "=", slot, made)


def _is_byte(machine: Engine, place: Value) -> bool:
    """Whether a place is one of an array of characters or bytes."""
    if not isinstance(place, Slot) or place.kind != "item":
        return False
    return not isinstance(place.base, Ref) or name_of(argument(machine.obj(place.base).cls, 0)) in _BYTES


def _is_whole(value: Value) -> bool:
    return value.__class__ is Const and value.value.__class__ in (int, Whole, Enumerated)


def _as_declared(machine: Engine, slot: Value, value: Value) -> Value:
    """A duration in the unit of the place in which it is kept, a whole number and a pointer as the field or element has them."""
    if is_sole(value):
        type_ = _declared(machine, slot)
        return value if type_ is None else as_pointer(value, type_)
    if is_time(machine, value):
        before = read(machine, slot)
        type_ = machine.obj(before).cls if isinstance(before, Ref) and is_time(machine, before) else None
        type_ = _declared(machine, slot) if type_ is None else type_
        return value if type_ is None else as_duration(machine, value, type_)
    if not _is_whole(value):
        return value
    type_ = _declared(machine, slot)
    if type_ is None:
        return value
    is_enumerator = bool(enumeration_of(value))
    if shape_of(type_) is Shape.INT or (is_enumerator and shape_of(type_) in {Shape.BOOL, Shape.FLOAT}):
        return convert(machine, value, type_)
    return value if is_enumerator else plain_number(value)


def _declared(machine: Engine, slot: Value) -> Value | None:
    """The type of a field or element; None for any other place."""
    if not isinstance(slot, Slot) or not isinstance(slot.base, Ref):
        return None
    cls = machine.obj(slot.base).cls
    if slot.kind == "field" and isinstance(cls, Class) and isinstance(slot.key, str):
        return _field_type(machine, cls, slot.key)
    if slot.kind == "item" and isinstance(cls, TypeOf):
        return argument(cls, 1 if machine.obj(slot.base).kind == "dict" else 0)
    return None


def _holds_pointer(machine: Engine, slot: Value) -> bool:
    """Whether what is assigned is kept as a pointer to characters, and not as the text from there: by the type, or what is there before."""
    type_ = _declared(machine, slot)
    if type_ is not None and shape_of(type_) in (Shape.POINTER, Shape.TEXT):
        return shape_of(type_) is Shape.POINTER
    held = options(read(machine, slot))
    return all(o == NONE or is_char_text(o) or not (o.__class__ is Const or is_text(o)) for o in held)


def of_field(machine: Engine, name: str, owner: Value) -> Value:
    """The type that a field is declared with, of an object or of what a pointer leads to; none where that is not known."""
    held = read(machine, owner)
    held = read(machine, held.target) if isinstance(held, Pointer) else held
    cls = machine.obj(held).cls if isinstance(held, Ref) else NONE
    if not isinstance(cls, Class):
        return NONE
    keys = [info.keys[name] for each in cls.mro if (info := linked(machine).info(each)) and name in info.keys]
    return _field_type(machine, cls, keys[0]) if keys else NONE


def _field_type(machine: Engine, cls: Class, key: str) -> Value:
    """The type that a field is declared with, by the name under which it stands in an object."""
    program = linked(machine)
    known = program.fields.get((cls.address, key))
    if known is None:
        infos = [info for each in cls.mro if (info := program.info(each)) is not None]
        found = [(info, f) for info in infos for f in info.fields if info.keys[f.name] == key]
        info, symbol = found[0] if found else (None, None)
        written = symbol.type if symbol is not None else None
        known = evaluate(machine, written, info.env) if info is not None and written is not None else NONE
        program.fields[cls.address, key] = known
    return known


def step(machine: Engine, operator: str, slot: Value, *, prefix: bool) -> Value:
    """`++slot`, `slot++`: the slot, or the value before; UNBOUND where it never ends."""
    own = own_operator(machine, operator, (slot,) if prefix else (slot, Const(0)))
    if own is not None:
        return own
    before = copied(machine, slot)
    if is_inserter(before):
        return slot if prefix else before
    held = read(machine, slot)
    if all(is_character(option) for option in options(held)):
        done = assign(machine, "=", slot, lift(lambda option: beside(option, 1 if operator == "++" else -1), held))
    else:
        done = assign(machine, f"{operator[0]}=", slot, Const(1))
    return done if done is UNBOUND or prefix else before


def _says_itself(machine: Engine, slot: Value, src: Value) -> bool:
    """Whether the class of an object says itself what is assigned to it: that of its bases assigns to their part alone."""
    info = linked(machine).info(machine.obj(slot).cls) if isinstance(slot, Ref) else None
    if info is None or info.cls is None or not linked(machine).members(info, "operator="):
        return False
    return ASSIGN in record(machine, info.cls.address).attrs or not is_one(machine, src, info.cls)


def _part(machine: Engine, ref: Ref, src: Value) -> Value | None:
    """`static_cast<Base &>(*this) = other`: as the base says itself, else its fields alone are assigned. None where that is not what happens."""
    cast = next(iter(cast_to(machine, (ref, src))), None)
    info = linked(machine).info(cast) if cast is not None else None
    whole = machine.obj(ref).cls
    if (
        info is None
        or info.cls is None
        or info.cls == whole
        or not isinstance(whole, Class)
        or info.cls not in whole.mro
    ):
        return None
    found = members.member(machine, ref, "operator=", (), info) if names.in_class(machine, info, "operator=") else None
    own = tuple(f for f in found.functions if not f.code.is_stub) if isinstance(found, Overloads) else ()
    if isinstance(found, Overloads) and fitting(machine, own, (src,)):
        done = calls.invoke(machine, found.only(own), (src,))
        return done if done is UNBOUND else ref
    others = options(read(machine, src))
    if not all(isinstance(o, Ref) and _derives(machine.obj(o).cls, info.cls) for o in others):
        return None
    _take_over(machine, ref, others, info.cls)
    return ref


def _take_over(machine: Engine, ref: Ref, others: Sequence[Value], base: Class) -> None:
    """The fields of a base of an object become as those of others are."""
    for each in base.mro:
        info = linked(machine).info(each)
        for field in info.fields if info is not None else ():
            key = info.keys[field.name] if info is not None else field.name
            held = join_all(read(machine, Slot(o, "field", key)) for o in others)
            write(machine, Slot(ref, "field", key), copied(machine, held))


def _siblings(machine: Engine, ref: Ref, value: Value) -> bool:
    """Objects of classes with a common base, where nobody sees how the place is declared: a variant, or a reference to that base, of either."""
    cls, others = machine.obj(ref).cls, options(value)
    for base in cls.mro if isinstance(cls, Class) else ():
        if (
            isinstance(base, Class)
            and not base.stub
            and all(isinstance(o, Ref) and _derives(machine.obj(o).cls, base) for o in others)
        ):
            own = {key for each in base.mro if (info := linked(machine).info(each)) for key in info.keys.values()}
            unknown = machine.unknown(Cause.OPERATION, "an object that one of another class is assigned to")
            attrs = machine.obj(ref).attrs
            for key in [name for name in attrs if name not in own and not name.startswith("<")]:
                write(machine, Slot(ref, "field", key), join(attrs[key], unknown), weak=True)
            _take_over(machine, ref, others, base)
            may_be_another(machine, ref)
            return True
    return False


def _derives(cls: Value, base: Class) -> bool:
    return isinstance(cls, Class) and base in cls.mro


def _object(machine: Engine, ref: Ref, src: Value) -> Value:
    """An object takes over what another holds; anything else is made one of its type first."""
    cls = machine.obj(ref).cls
    native = machine.library.native(f"{name_of(cls)}.operator=")
    if native is not None:
        return run_native(machine, native, f"{name_of(cls)}.operator=", (ref, src), {})
    value = read(machine, src)
    if isinstance(value, (Tuple, Const, Pointer)) or not all(isinstance(o, Ref) for o in options(value)):
        if not isinstance(value, Unknown):
            value = as_type.convert(machine, value, cls, "init")
            if isinstance(value, Tuple):
                value = construct.make(machine, cls, (value,), "brace-copy")
    elif shape_of(cls) in {Shape.PAIR, Shape.OPTIONAL}:
        value = convert(machine, value, cls)
    elif is_time(machine, ref):
        value = as_duration(machine, value, cls)
    given = value
    if isinstance(cls, Class) and not any(_is_related(machine, o, cls) for o in options(value)):
        value = _made_of(machine, value, cls)
    if value is UNBOUND:
        return UNBOUND
    if _is_another(machine, ref, cls, value):
        if (
            next(iter(cast_to(machine, (ref, src))), None) is not None
            or is_box(machine, ref)
            or not _siblings(machine, ref, value)
        ):
            become_box(machine, ref, value)
    else:
        write(machine, ref, value)
        if value is not given or any(isinstance(o, Unknown) for o in options(value)):
            may_be_another(machine, ref)
    return ref


def _made_of(machine: Engine, value: Value, cls: Class) -> Value:
    """An object of a class that is made, without saying so, of what is assigned to one; the value itself where that cannot be."""
    info = linked(machine).info(cls)
    if info is None:
        return value
    implicit = [s for s in constructors(machine, info) if not s.explicit and (s.template or not is_copying(info, s))]
    functions = [function_of(machine, s, info.env) for s in implicit]

    def one(option: Value) -> Value:
        if not isinstance(option, Ref):
            return option
        if fitting(machine, functions, (option,)):
            return construct.make(machine, cls, (option,), "copy")
        return by_operator(machine, option, cls)

    return lift(one, value)


def _is_another(machine: Engine, ref: Ref, cls: Value, value: Value) -> bool:
    """Whether no object of its class can hold what is assigned: so it stands for a variant, `any` or `function`, which hold anything."""
    if is_box(machine, ref):
        return True
    if (
        not isinstance(cls, Class)
        or (cls.stub and cls.name != "monostate")
        or not all(isinstance(each, Class) for each in cls.mro)
    ):
        return False
    info = linked(machine).info(cls)
    if info is None or names.in_class(machine, info, "operator=") is not None:
        return False
    return not any(_is_related(machine, o, cls) for o in options(value))


def _is_related(machine: Engine, value: Value, cls: Class) -> bool:
    """Whether a value may be an object of a class, of one that derives from it, or of one that it derives from."""
    if isinstance(value, Unknown):
        return value.hint not in {"bool", "int", "float", "str"}
    other = machine.obj(value).cls if isinstance(value, Ref) else None
    return isinstance(other, Class) and (cls in other.mro or other in cls.mro)
