# SPDX-License-Identifier: Apache-2.0
"""The beginning of a constructor that is written: `: Node("talker"), topic_("chatter")`, bases first, then fields as they are declared."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, UNBOUND, Class, Ref, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp import construct
from rosward.engine.cpp.constructors import constructors
from rosward.engine.cpp.converting import decaying
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.running.frame import Frame
from rosward.ir import cpp
from rosward.ir.symbols import Symbol
from rosward.models.cpp.values.conversions import COMPOUND
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["initialise", "is_fresh", "made"]

Given = Callable[[Frame, tuple[cpp.Argued, ...]], tuple[Value, ...]]


def is_fresh(frame: Frame, arguments: tuple[cpp.Argued, ...], args: tuple[Value, ...]) -> bool:
    """Whether nobody else has the only argument."""
    if len(args) != 1 or len(arguments) != 1:
        return False
    return arguments[0].kind == "value" or (arguments[0].kind == "result" and args[0] == frame.fresh)


def made(machine: Engine, type_: Value, args: tuple[Value, ...], form: cpp.Form, *, fresh: bool) -> Value:
    """A value of a type; `fresh`: the only argument is one that nobody else has, so that it need not be copied."""
    if len(args) == 1:
        held = read(machine, args[0])
        if isinstance(held, Ref) and machine.obj(held).cls == type_:
            return held if fresh else copied(machine, held)
        if isinstance(type_, TypeOf) and type_.name == "auto":
            return held if fresh else copied(machine, args[0])
    return construct.make(machine, type_, _of_first(machine, type_, args) if form.startswith("brace") else args, form)


def _of_first(machine: Engine, type_: Value, args: tuple[Value, ...]) -> tuple[Value, ...]:
    """`Line line{{start, 2}}`: of an aggregate, the inner braces are those of its first field where that consists of something."""
    only = args[0] if len(args) == 1 else NONE
    if not isinstance(only, Tuple) or only.items[:1] == (construct.DESIGNATED,) or not isinstance(type_, Class):
        return args
    info = linked(machine).info(type_)
    if info is None or info.cls is None or len(info.cls.mro) > 2 or constructors(machine, info):
        return args
    first = next(iter(info.fields), None)
    if first is None or first.type is None:
        return args
    held = evaluate(machine, first.type, info.env)
    parts = isinstance(held, Class) or shape_of(held) in COMPOUND
    return (Tuple(args),) if parts else args


def initialise(machine: Engine, op: cpp.Initialise, frame: Frame, given: Given) -> bool:
    """Bases and fields of `this`; False where control does not come out."""
    info = linked(machine).info(frame.module)
    this = frame.registers[0]
    objects = [o for o in options(this) if isinstance(o, Ref)]
    if info is None or info.cls is None or not objects:
        return True

    def one(ref: Ref) -> Value:
        frame.registers[0] = ref
        return NONE if _initialise(machine, op, frame, given, ref, info) else UNBOUND

    lives = each_apart(machine, objects, one) is not UNBOUND
    frame.registers[0] = this
    return lives


def _initialise(machine: Engine, op: cpp.Initialise, frame: Frame, given: Given, this: Ref, info: Info) -> bool:
    """The same for one object: a constructor that is followed for many calls at once has several."""
    fields = {f.name for f in info.fields}
    for_fields = {m.name: m for m in op.members if m.name in fields}
    others = [m for m in op.members if m.name not in fields]
    for_bases: list[tuple[Value, cpp.MemberInit]] = []
    for member in others:
        if not machine.run(member.type_body, frame):
            return False
        type_ = frame.registers[member.type]
        if type_ == info.cls:  # another constructor of the class does it all
            if not machine.run(member.body, frame):
                return False
            with _initialising(frame, member):
                return construct.construct_in_place(machine, this, info, given(frame, member.arguments))
        for_bases += [(t, member) for t in (type_.items if isinstance(type_, Tuple) else (type_,))]
    return _bases(machine, this, info, for_bases, frame, given) and _fields(
        machine, this, info, for_fields, frame, given
    )


def _bases(
    machine: Engine, this: Ref, info: Info, inits: list[tuple[Value, cpp.MemberInit]], frame: Frame, given: Given
) -> bool:
    assert info.cls is not None
    for base in linked(machine).bases_to_make(this, info):
        init = next((m for t, m in inits if t == base), None)
        if init is None:
            made = construct.make_base(machine, this, base, (), "default")
        elif not machine.run(init.body, frame):
            return False
        else:
            with _initialising(frame, init):
                made = construct.make_base(machine, this, base, given(frame, init.arguments), init.form)
        if not made:
            return False
    return True


@contextmanager
def _initialising(frame: Frame, init: cpp.MemberInit) -> Iterator[None]:
    """While a base or field is made, its arguments are those of the call that runs."""
    frame.initialising = init.arguments
    try:
        yield
    finally:
        frame.initialising = ()


def _fields(
    machine: Engine, this: Ref, info: Info, inits: dict[str, cpp.MemberInit], frame: Frame, given: Given
) -> bool:
    for symbol in info.fields:
        init = inits.get(symbol.name)
        if init is None:
            value = construct.field_default(machine, this, info, symbol)
        else:
            if not machine.run(init.body, frame):
                return False
            with _initialising(frame, init):
                value = _field(machine, info, symbol, init, decaying(machine, given(frame, init.arguments)), frame)
        if value is UNBOUND:
            return False
        if value is not None:
            construct.set_field(machine, this, info, symbol.name, value)
    return True


def _field(
    machine: Engine, info: Info, symbol: Symbol, init: cpp.MemberInit, args: tuple[Value, ...], frame: Frame
) -> Value:
    if symbol.name in info.references:
        return args[0] if args else UNBOUND
    type_ = evaluate(machine, symbol.type, info.env) if symbol.type is not None else TypeOf("auto", ())
    fresh = is_fresh(frame, init.arguments, args)
    return made(machine, type_, args, init.form, fresh=fresh)
