# SPDX-License-Identifier: Apache-2.0
"""Operators: those that classes define, then those of the language and its library.

a + b      a.operator+(b), operator+(a, b) of the namespaces of a and b, else numbers, strings, paths, iterators
x = y      an object stays where it is and takes over what the other holds
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import lift, options
from rosward.domain.compound import External, Tuple
from rosward.domain.enumerated import Enumerated, Whole
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf, is_char_text
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Ref, Unknown, Value
from rosward.engine.cpp import as_type, calls, construct, endings, members, names
from rosward.engine.cpp.categories import cast_to
from rosward.engine.cpp.constructors import constructors, is_copying
from rosward.engine.cpp.converting import by_operator
from rosward.engine.cpp.enumerations import enumeration_of, scope_of
from rosward.engine.cpp.handing import decayed
from rosward.engine.cpp.linked import linked, record
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.overloading import fitting
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import type_of
from rosward.engine.cpp.values import function_of, overloads
from rosward.models.cpp import operators as plain
from rosward.models.cpp.boxes import become_box, is_box, may_be_another, unboxed
from rosward.models.cpp.characters import as_string, is_text
from rosward.models.cpp.conversions import convert
from rosward.models.cpp.copies import ASSIGN, copied, write
from rosward.models.cpp.ranges import emit, is_inserter
from rosward.models.cpp.slots import plain_number, read
from rosward.models.cpp.types import Shape, argument, name_of, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["assign", "binary", "compare", "folded", "step", "truth", "unary"]


def _own(machine: Engine, operator: str, args: tuple[Value, ...]) -> Value | None:
    """What an operator that a class defines gives; None where none does."""
    first = read(machine, args[0])
    if not any(_is_object(machine, a) for a in args):
        return _of_enumeration(machine, operator, args)
    seen = next(iter(cast_to(machine, args)), None)
    info = linked(machine).info(seen) if seen is not None else None
    if info is not None and operator == "=" and names.in_class(machine, info, "operator=") is None:
        return None  # the part of it is copied that is of that class
    is_object = _is_object(machine, first)
    found = members.member(machine, first, f"operator{operator}", (), info) if is_object else None
    own = found if isinstance(found, Overloads) else None
    if own is not None and (len(own.functions) > 1 or len(args) > 1) and not fitting(machine, own.functions, args[1:]):
        free = _free(machine, operator, args)
        if free is not None and fitting(machine, free.functions, args):
            return calls.invoke(machine, free, args)
    if own is not None:
        return calls.invoke(machine, own, args[1:])
    free = _free(machine, operator, args)
    return None if free is None else calls.invoke(machine, free, args)


def _free(machine: Engine, operator: str, args: tuple[Value, ...]) -> Overloads | None:
    """The operators of the namespaces of the operands: the first that has some that take them, else the first that has any."""
    several: list[Overloads] = []
    for arg in args:
        cls = type_of(machine, arg)
        for each in cls.mro if isinstance(cls, Class) else ():
            info = linked(machine).info(each)
            scope = info.symbol.scope if info is not None else None
            if scope is None:
                continue
            found = names.in_namespace(machine, scope, f"operator{operator}", names.seeing(machine))
            if found is not None:
                several.append(overloads(machine, found, ()))
    if len(several) > 1:
        several = [each for each in several if fitting(machine, each.functions, args)] or several
    return several[0] if several else None


def _of_enumeration(machine: Engine, operator: str, args: tuple[Value, ...]) -> Value | None:
    """`os << side`: an operator that stands where the enumeration does, and is for that."""
    for arg in args:
        enumeration = enumeration_of(read(machine, arg))
        scope = scope_of(enumeration)
        found = (
            names.in_namespace(machine, scope, f"operator{operator}", names.seeing(machine)) if enumeration else None
        )
        if found is None:
            continue
        several = overloads(machine, found, ())
        wanted = External(enumeration)
        fitting = tuple(f for f in several.functions if _takes(machine, f, wanted))
        if fitting:
            return calls.invoke(machine, several.only(fitting), args)
    return None


def _takes(machine: Engine, function: Function, type_: Value) -> bool:
    signature = function.code.signature
    patterns = [p.type for p in signature.parameters] if signature is not None else []
    return any(type_of_pattern(machine, function.module, pattern) == type_ for pattern in patterns)


def _is_object(machine: Engine, value: Value) -> bool:
    value = read(machine, value)
    return isinstance(value, Ref) and isinstance(machine.obj(value).cls, Class)


def unary(machine: Engine, operator: str, value: Value) -> Value:
    """operator value."""
    written = "!" if operator == "not" else operator
    own = _own(machine, written, (value,))
    if own is not None:
        return own
    held = read(machine, value)
    if operator == "not":
        decided = truth(machine, held)
        if decided is None and held.__class__ in (Choice, Const):
            return plain.unary(machine, operator, held)
        return machine.unknown(Cause.OPERATION, "!", "bool") if decided is None else Const(not decided)
    return plain.unary(machine, operator, held)


def binary(machine: Engine, operator: str, left: Value, right: Value, *, inplace: bool = False) -> Value:
    """left operator right."""
    own = _own(machine, operator, (left, right)) if not inplace else None
    return own if own is not None else plain.binary(machine, operator, left, right)


def compare(machine: Engine, operator: str, left: Value, right: Value) -> Value:
    """left operator right; `!=` and the like follow from `==` and `<` where only these are defined."""
    own = _own(machine, operator, (left, right))
    if own is not None:
        return own
    if operator == "!=":
        equal = _own(machine, "==", (left, right))
        if equal is not None:
            return unary(machine, "not", equal)
    return plain.compare(machine, operator, read(machine, left), read(machine, right))


def truth(machine: Engine, value: Value) -> bool | None:
    """Whether a value counts as true; None where both may be."""
    held = read(machine, unboxed(machine, value))
    if isinstance(held, Overloads):
        return True
    if _is_object(machine, held):
        own = members.member(machine, held, "operator bool")
        if isinstance(own, Overloads):
            return truth(machine, calls.invoke(machine, own, ()))
        return None
    return plain.truth(machine, held)


def assign(machine: Engine, operator: str, slot: Value, src: Value) -> Value:
    """`slot operator src`; the slot, or UNBOUND where it never ends."""
    if operator == "=" and is_inserter(read(machine, slot)) and not is_inserter(read(machine, src)):  # `*out = x`
        emit(machine, slot, Series((read(machine, src),)))
        return slot
    own = _own(machine, operator, (slot, src)) if operator != "=" or _says_itself(machine, slot, src) else None
    if own is not None:
        return own if own is UNBOUND else slot
    if operator != "=":
        value = binary(machine, operator[:-1], read(machine, slot), read(machine, src), inplace=True)
        if value is UNBOUND:
            return UNBOUND
        if not isinstance(slot, Ref) or value != slot:
            write(machine, slot, _as_declared(machine, slot, value) if _is_whole(value) else value)
        return slot
    if isinstance(slot, Ref):
        return slot if _part(machine, slot, src) else _object(machine, slot, src)
    value = decayed(machine, src)
    if value.__class__ is not Unknown:
        value = copied(machine, value)
    if any(o.__class__ is Pointer or is_char_text(o) for o in options(value)) and not _holds_pointer(machine, slot):
        value = as_string(machine, value)
    before = read(machine, slot) if value.__class__ is Pointer or value == NONE else NONE
    write(machine, slot, _as_declared(machine, slot, value) if _is_whole(value) else value)
    is_left = before.__class__ is Pointer and before != value
    return UNBOUND if is_left and not endings.end(machine, before) else slot


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
    """A whole number as the field or element has it in which it is kept."""
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
    own = _own(machine, operator, (slot,) if prefix else (slot, Const(0)))
    if own is not None:
        return own
    before = copied(machine, slot)
    if is_inserter(before):
        return slot if prefix else before
    done = assign(machine, f"{operator[0]}=", slot, Const(1))
    return done if done is UNBOUND else slot if prefix else before


def _says_itself(machine: Engine, slot: Value, src: Value) -> bool:
    """Whether the class of an object says itself what is assigned to it: that of its bases assigns to their part alone."""
    info = linked(machine).info(machine.obj(slot).cls) if isinstance(slot, Ref) else None
    if info is None or info.cls is None or not linked(machine).symbols.at(info.scope, "operator="):
        return False
    return ASSIGN in record(machine, info.cls.address).attrs or not construct.is_one(machine, src, info.cls)


def _part(machine: Engine, ref: Ref, src: Value) -> bool:
    """`static_cast<Base &>(*this) = other`: the fields of that base alone are assigned, where its class does not say how itself."""
    cast = next(iter(cast_to(machine, (ref, src))), None)
    info = linked(machine).info(cast) if cast is not None else None
    whole, value = machine.obj(ref).cls, read(machine, src)
    if info is None or info.cls is None or info.cls == whole or not isinstance(value, Ref):
        return False
    if names.in_class(machine, info, "operator=") is not None:
        return False
    others = machine.obj(value).cls
    if not all(isinstance(cls, Class) and info.cls in cls.mro for cls in (whole, others)):
        return False
    for each in info.cls.mro:
        own = linked(machine).info(each)
        for field in own.fields if own is not None else ():
            key = own.keys[field.name] if own is not None else field.name
            write(machine, Slot(ref, "field", key), copied(machine, read(machine, Slot(value, "field", key))))
    return True


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
    given = value
    if isinstance(cls, Class) and not any(_is_related(machine, o, cls) for o in options(value)):
        value = _made_of(machine, value, cls)
    if value is UNBOUND:
        return UNBOUND
    if _is_another(machine, ref, cls, value):
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


_EMPTY: Final = {"&&": Const(True), "||": Const(False), ",": NONE}


def folded(machine: Engine, operator: str, values: Sequence[Value]) -> Value:
    """`(values operator …)`."""
    if not values:
        return _EMPTY.get(operator) or machine.unknown(Cause.OPERATION, f"{operator} of nothing")
    if operator in ("&&", "||"):
        decided = [truth(machine, v) for v in values]
        short = operator == "||"
        if short in decided:
            return Const(short)
        return machine.unknown(Cause.OPERATION, operator, "bool") if None in decided else Const(not short)
    if operator == ",":
        return values[-1]
    result = values[0]
    for value in values[1:]:
        comparing = operator in ("==", "!=", "<", "<=", ">", ">=")
        result = compare(machine, operator, result, value) if comparing else binary(machine, operator, result, value)
    return result
