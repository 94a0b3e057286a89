# SPDX-License-Identifier: Apache-2.0
"""How does a value of a type come to be: an object by its constructor, bases first, then fields as they are declared?

class Talker : public rclcpp::Node { Talker() : Node("talker"), topic_("chatter") {…} };
    Node("talker"), then each field, then the body; while the constructor of Node runs, the object is a Node
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import takewhile
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp import handing, visitors
from rosward.engine.cpp.classes import copies, is_copied
from rosward.engine.cpp.constructors import (
    closed,
    constructors,
    inherited_constructors,
    inheriting,
    is_copy,
    is_copying,
    outside,
    takes,
    takes_list,
)
from rosward.engine.cpp.converting import as_wanted, by_operator, by_operators, decayed, enumerator
from rosward.engine.cpp.enumerations import is_enumeration
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.message_of import message_of
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.overloading import choose, fitting
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted, is_message, is_of_language, pointee
from rosward.engine.cpp.values import function_of, versions
from rosward.engine.unknown.escape import name_of
from rosward.ir.cpp import Form
from rosward.ir.symbols import Symbol
from rosward.models.cpp.values.contents import CONTENT, content_base, is_content, put
from rosward.models.cpp.values.conversions import convert as convert_plain
from rosward.models.cpp.values.conversions import default_value
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, shape_of
from rosward.models.cpp.values.unions import take_member

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "DESIGNATED",
    "construct_in_place",
    "field_default",
    "make",
    "make_base",
    "make_of_anything",
    "part_of",
    "set_field",
]

DESIGNATED: Final = External("<designated>")
"""The first item of the braces `{.a = 1}`: the others are pairs of a name and a value."""


_OWNING: Final = frozenset({Shape.ARRAY, Shape.LIST, Shape.MAP, Shape.PAIR})
"""Containers that make what is in braces their own: an element may be an object that refers to something (`{{lamp, "a"}}`)."""


def _is_node(machine: Engine, value: Value) -> bool:
    """Whether a value is a node, or a pointer to one."""
    found = [o.target if isinstance(o, Pointer) else o for o in options(read(machine, value))]
    return any(isinstance(o, Ref) and machine.is_node(o.address) for o in found)


def make(machine: Engine, type_: Value, args: Sequence[Value], form: Form) -> Value:
    """A new value of a type."""
    if isinstance(type_, Class):
        return _object(machine, type_, tuple(args), form)
    if len(options(type_)) > 1 or isinstance(type_, Unknown):
        handing.give_to(machine, args, type_)
        return machine.unknown(Cause.CALL, name_of(type_)) if not isinstance(type_, Unknown) else type_
    if is_message(type_):
        return message_of(machine, type_, args)
    if is_enumeration(machine, type_) and len(args) <= 1:
        return enumerator(machine, dotted(type_), args, form)
    name = dotted(type_)
    native = machine.library.native(f"{name}.new")
    if native is not None:
        if len(args) == 1:
            args = (as_wanted(machine, args[0], type_),)
        return run_native(machine, native, f"{name}.new", (type_, *args), {"form": Const(form)})
    is_foreign = isinstance(type_, External) or (isinstance(type_, TypeOf) and not is_of_language(type_))
    if is_foreign and "." not in name and any(_is_node(machine, arg) for arg in args):
        handing.give_to(machine, args, type_)  # a class of another library, no number
    if pointee(type_) is not None or shape_of(type_) is not Shape.OTHER or "." not in name:
        if not args or (len(args) == 1 and args[0] == Tuple(())):
            return default_value(machine, type_) if form != "default" or pointee(type_) is None else NONE
        listed = form.startswith("brace") and (name == "array" or not _is_list(args))
        value = Tuple(tuple(args)) if listed else args[0]
        if pointee(type_) is not None:
            return convert_plain(machine, lift(lambda v: decayed(machine, v), read(machine, value)), type_, "init")
        if not (isinstance(value, Tuple) and shape_of(type_) in _OWNING):
            value = lift(lambda v: by_operator(machine, v, type_), copied(machine, value))
        return convert_plain(machine, value, type_, "init")
    if len(args) == 1 and form in ("copy", "brace-copy") and not isinstance(args[0], Tuple):
        return copied(machine, args[0])  # a value of a library's type from another one
    handing.give_to(machine, args, type_)
    return machine.unknown(Cause.CALL, name)


def _is_list(args: Sequence[Value]) -> bool:
    return len(args) == 1 and isinstance(args[0], Tuple)


def _object(machine: Engine, cls: Class, args: tuple[Value, ...], form: Form) -> Value:
    info = linked(machine).info(cls)
    if info is None or info.cls is None:
        return machine.unknown(Cause.CALL, cls.name)
    cls = info.cls  # what is named in its own bases is not whole
    if len(args) == 1 and isinstance(args[0], Tuple) and form != "paren" and not takes_list(machine, info):
        args = args[0].items
    else:
        args = _braced(machine, info, args, form)
    args = by_operators(machine, args, cls)
    of_functions = visitors.visitor(machine, info, args)
    if of_functions is not None:
        return of_functions
    if info.open:
        cls, info = closed(machine, cls, info, args)
    if is_copy(machine, info, args) and not copies(machine, info):
        if not is_copied(machine, cls) and all(
            isinstance(o, Ref) and machine.obj(o).cls == cls for o in options(read(machine, args[0]))
        ):
            return copied(machine, args[0])
        return _part(machine, cls, args[0])
    machine.trace.instantiated.add(cls.place)
    ref = machine.allocate(Obj("instance", cls), "object")
    if not construct_in_place(machine, ref, info, args):
        return UNBOUND
    handing.watch(machine, cls, ref)
    return ref


def make_base(machine: Engine, ref: Ref, base: Value, args: tuple[Value, ...], form: Form) -> bool:
    """Make what of an object belongs to a base; False where that never ends."""
    own = linked(machine).info(base)
    if own is not None:
        return construct_in_place(machine, ref, own, _braced(machine, own, args, form))
    if is_content(base):
        return put(machine, ref, make(machine, base, args, form))
    if args:
        handing.give_to(machine, args, base)
    return True


def _braced(machine: Engine, info: Info, args: tuple[Value, ...], form: Form) -> tuple[Value, ...]:
    """What stands in braces is one list, where a constructor of the class takes such a one."""
    is_list = args and form == "brace" and not _is_list(args) and takes_list(machine, info)
    return (Tuple(args),) if is_list and not is_copy(machine, info, args) else args


def part_of(machine: Engine, value: Value, type_: Value) -> Value:
    """A copy of what of an object belongs to a base, where the object is seen as one: no constructor for what derives from that is asked."""
    info = linked(machine).info(type_) if isinstance(type_, Class) else None
    if info is None or info.cls is None or copies(machine, info):
        return make(machine, type_, (value,), "copy")
    return _part(machine, info.cls, value)


def _part(machine: Engine, cls: Class, value: Value) -> Value:
    ref = machine.allocate(Obj("instance", cls), "object")
    _take_over(machine, ref, cls, value)
    return ref


def make_of_anything(machine: Engine, cls: Class, keywords: Mapping[str, Value]) -> Value:
    """An object that code makes of which nothing is known: by each of its constructors, with anything."""
    info = linked(machine).info(cls)
    if info is None:
        return machine.unknown(Cause.CALL, cls.name)
    machine.trace.instantiated.add(cls.place)
    own = [s for s in constructors(machine, info) if not is_copying(info, s) and s.code is not None]
    if not own:
        return make(machine, cls, (), "default")

    def one(function: Value) -> Value:
        ref = machine.allocate(Obj("instance", cls), "object")
        with _as_class(machine, ref, cls):
            made = machine.call(function, (ref,), keywords) is not UNBOUND
        if made:
            handing.watch(machine, cls, ref)
        return ref if made else UNBOUND

    return each_apart(machine, [function_of(machine, s, info.env) for s in own], one)


@contextmanager
def _as_class(machine: Engine, ref: Ref, cls: Class) -> Iterator[None]:
    """While a constructor runs, the object is of its class."""
    constructing = linked(machine).constructing
    constructing.append((ref.address, cls))
    try:
        yield
    finally:
        constructing.pop()


def construct_in_place(
    machine: Engine, ref: Ref, info: Info, args: tuple[Value, ...], *, copying: bool = False
) -> bool:
    """Run the constructor of a class on an object; False where it never ends. `copying`: of the part of an object that is one."""
    assert info.cls is not None
    if (copying or is_copy(machine, info, args)) and not copies(machine, info):
        _take_over(machine, ref, info.cls, args[0])
        return True
    is_delegated = linked(machine).constructing[-1:] == [(ref.address, info.cls)]
    with _as_class(machine, ref, info.cls):
        written = constructors(machine, info)
        functions = [function_of(machine, s, info.env) for s in written]
        elsewhere = outside(info)
        if elsewhere is not None and not fitting(machine, _making(machine, info, written, args), args):
            return initialise(machine, ref, info, (), {dotted(elsewhere): args})
        bases = inheriting(machine, info) if args else []
        inherited = inherited_constructors(machine, bases)
        if bases and not any(takes(f, len(args)) for f in (*functions, *inherited)):
            return initialise(machine, ref, info, (), {bases[0].env.name: args})
        if not functions and not inherited:
            return initialise(machine, ref, info, args, {})
        own = _not_delegating(machine, functions) if is_delegated else functions
        chosen = choose(machine, [*own, *inherited], args, ())

        def run(function: Function) -> bool:
            base = inherited.get(function)
            if base is not None:
                return initialise(machine, ref, info, (), {base.env.name: args})
            return _run(machine, function, ref, info, args)

        if len(chosen) == 1:
            return run(chosen[0])

        def one(function: Value) -> Value:
            assert isinstance(function, Function)
            return NONE if run(function) else UNBOUND

        return each_apart(machine, list(chosen), one) is not UNBOUND


def _making(machine: Engine, info: Info, written: list[Symbol], args: tuple[Value, ...]) -> list[Function]:
    """The constructors that what is given may mean: one that copies takes no list, which is what the base from elsewhere is made of."""
    is_copied = is_copy(machine, info, args)
    return [function_of(machine, s, info.env) for s in written if is_copied or not is_copying(info, s)]


def _not_delegating(machine: Engine, functions: list[Function]) -> list[Function]:
    """The constructors that do not wait for one that they delegate to: none delegates to itself, by whatever way.

    So `Sensor(double rate) : Sensor(static_cast<float>(rate))` means another one, although a value does not say which number type it has.
    """
    own = {f.code.key for f in functions}
    waiting = set(takewhile(own.__contains__, (frame.code.key for frame in reversed(machine.frames))))
    return [f for f in functions if f.code.key not in waiting] or functions


def _take_over(machine: Engine, ref: Ref, cls: Class, source: Value) -> None:
    """What a copy constructor that nobody writes does: the fields of the class and its bases become those of an object that may have more."""
    apart: set[Value] = set()
    whole = linked(machine).info(cls)
    for base in linked(machine).bases_to_make(ref, whole) if whole is not None else ():
        inner = linked(machine).info(base)
        if inner is not None and isinstance(base, Class) and is_copied(machine, base):
            construct_in_place(machine, ref, inner, (source,), copying=True)
            apart.update(base.mro)
    objects = [(o, machine.obj(o)) for o in options(read(machine, source)) if isinstance(o, Ref)]
    if content_base(cls) not in (None, *apart):
        put(machine, ref, copied(machine, join_all(obj.attrs.get(CONTENT, UNBOUND) for _, obj in objects)))
    for each in cls.mro:
        if each in apart:
            continue
        own = linked(machine).info(each)
        if own is None:
            continue
        for symbol in own.fields:
            keys = [(obj, linked(machine).key_in(machine, o, own, symbol.name)) for o, obj in objects]
            values = [obj.attrs[key] for obj, key in keys if key is not None and key in obj.attrs]
            if values:
                value = join_all(values) if symbol.name in own.references else copied(machine, join_all(values))
                set_field(machine, ref, own, symbol.name, value)


def _run(machine: Engine, function: Function, ref: Ref, info: Info, args: tuple[Value, ...]) -> bool:
    if function.code.is_stub:  # `= default`, or defined where nobody sees it
        symbol = linked(machine).declared[function.code.key]
        if not symbol.defined and "default" not in symbol.marks and args:
            handing.give_to(machine, args, External(f"{info.env.name}.{symbol.name}"))
        return initialise(machine, ref, info, (), {})
    return machine.call(function, (ref, *args)) is not UNBOUND


def initialise(
    machine: Engine, ref: Ref, info: Info, args: tuple[Value, ...], for_bases: dict[str, tuple[Value, ...]]
) -> bool:
    """What a class without a constructor of its own does: bases, then fields, of an aggregate in the order of the arguments."""
    assert info.cls is not None
    given = list(args)
    named: dict[str, Value] = {}
    if given and given[0] == DESIGNATED:
        named = {
            str(p.items[0].value): p.items[1]
            for p in given[1:]
            if isinstance(p, Tuple) and isinstance(p.items[0], Const)
        }
        given = []
    for base in linked(machine).bases_to_make(ref, info):
        own = linked(machine).info(base)
        inner = for_bases.get(dotted(base) if own is None else own.env.name, ())
        form: Form = "paren" if inner else "default"
        if given and not inner:
            first = given.pop(0)
            form = "brace" if isinstance(first, Tuple) else "paren"
            inner = first.items if isinstance(first, Tuple) else (first,)
        if not make_base(machine, ref, base, inner, form):
            return False
    chosen = False  # of the members of a union, the first is given
    for symbol in info.fields:
        if chosen and symbol.overlaps:
            continue
        if symbol.name in named:
            value: Value | None = _field_of(machine, info, symbol, named[symbol.name])
        elif given:
            value = _field_of(machine, info, symbol, given.pop(0))
        else:
            value = field_default(machine, ref, info, symbol)
            if (
                value is None
                and args
                and symbol.type is not None
                and not (symbol.name in info.references or symbol.overlaps)
            ):
                value = default_value(machine, evaluate(machine, symbol.type, info.env))
        if value is UNBOUND:
            return False
        if value is not None:
            set_field(machine, ref, info, symbol.name, value)
            if symbol.overlaps and args:
                chosen = True
                take_member(machine, ref, info.keys[symbol.name])
    return True


def _field_of(machine: Engine, info: Info, symbol: Symbol, value: Value) -> Value:
    if symbol.name in info.references:
        return value
    type_ = evaluate(machine, symbol.type, info.env) if symbol.type is not None else TypeOf("auto", ())
    if not isinstance(value, Tuple):
        return make(machine, type_, (value,), "copy")
    several = dotted(type_) == "array" or shape_of(type_) is Shape.LIST
    return make(machine, type_, value.items if several else (value,), "brace-copy")


def field_default(machine: Engine, ref: Ref, info: Info, symbol: Symbol) -> Value | None:
    """What a field holds that no constructor mentions: its own first value, or that of its type; None where it has none."""
    if symbol.sure:
        return _first_of_field(machine, ref, info, symbol)
    found = [_first_of_field(machine, ref, info, each) for each in versions(info.symbol.members, symbol)]
    return join_all(each for each in found if each is not None) if any(each is not None for each in found) else None


def _first_of_field(machine: Engine, ref: Ref, info: Info, symbol: Symbol) -> Value | None:
    if symbol.code is not None:
        return evaluate(machine, symbol.code, info.env, leading=(ref,))
    if symbol.type is None or symbol.name in info.references:
        return None
    type_ = evaluate(machine, symbol.type, info.env)
    if dotted(type_) == "array":
        return default_value(machine, type_)
    if "." not in dotted(type_) and not isinstance(type_, Class):
        return NONE if pointee(type_) is not None else None
    return make(machine, type_, (), "default")


def set_field(machine: Engine, ref: Ref, info: Info, name: str, value: Value) -> None:
    """The first value of a field."""
    program = linked(machine)
    key = program.key_in(machine, ref, info, name) if program.clashes else info.keys.get(name)
    machine.update(ref, machine.obj(ref).with_attr(key or name, value))
