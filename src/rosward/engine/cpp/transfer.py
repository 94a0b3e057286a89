# SPDX-License-Identifier: Apache-2.0
"""What the operations do that C++ alone has: one handler per operation, in a table by its class.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Const, Function, Ref, Value
from rosward.engine.cpp import (
    access,
    again,
    as_type,
    assigning,
    calls,
    construct,
    detection,
    endings,
    initialising,
    methods,
    naming,
    narrowing,
    spreading,
)
from rosward.engine.cpp.binding import instance
from rosward.engine.cpp.classes import instance_of
from rosward.engine.cpp.converting import as_value, decaying
from rosward.engine.cpp.packs import items_of
from rosward.engine.cpp.types import plain_type, pointee, pointer_to, type_of
from rosward.engine.machine import Handler
from rosward.engine.python import exceptions as python_exceptions
from rosward.engine.python.transfer import OWN as PYTHON_OWN
from rosward.engine.running.frame import Frame
from rosward.engine.throwing import throw
from rosward.ir import cpp, ops
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.iteration.elements import elements, parts
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["OWN", "given"]

DEAD: Final = False


def given(frame: Frame, arguments: tuple[cpp.Argued, ...]) -> tuple[Value, ...]:
    """The arguments of a call; packs are spread."""
    values: list[Value] = []
    for argument in arguments:
        value = frame.registers[argument.register]
        items = items_of(value) if argument.kind == "pack" else None
        values += (value,) if items is None else items
    return tuple(values)


def _declared(machine: Engine, op: cpp.Declared, frame: Frame) -> None:
    own = op.obj == ops.NO_REGISTER
    owner = NONE if own else frame.registers[op.obj]
    found = naming.declared_type(machine, op.name, frame) if own else assigning.of_field(machine, op.name, owner)
    frame.registers[op.dst] = found


def _kept(frame: Frame, dst: int, value: Value) -> bool | None:
    frame.registers[dst] = value
    return DEAD if value is UNBOUND else None


def _name(machine: Engine, op: cpp.Name, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    naming.note_reached(machine, op.parts[-1].name, frame)
    return _kept(frame, op.dst, naming.name(machine, op, frame))


def _cell_slot(machine: Engine, op: cpp.CellSlot, frame: Frame) -> None:
    cell = Ref(frame.cells[op.cell])
    held = machine.obj(cell).attrs.get("value", UNBOUND)
    frame.registers[op.dst] = held if isinstance(held, (Ref, Slot)) else Slot(cell, "cell", None)


def _member(machine: Engine, op: cpp.Member, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    types = access.types_of(frame, op.arguments)

    def declared() -> Value:
        return frame.registers[op.static] if machine.run(op.seen, frame) else UNBOUND

    seen = declared if op.static != ops.NO_REGISTER else None
    found = access.member(machine, frame, frame.registers[op.obj], op.name, types, own=op.obj == 0, declared=seen)
    return _kept(frame, op.dst, found if op.slot else access.value(machine, found))


def _item(machine: Engine, op: cpp.Item, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    found = access.item(machine, frame.registers[op.obj], frame.registers[op.index], constant=op.constant)
    return _kept(frame, op.dst, found if op.slot or found is UNBOUND else access.value(machine, found))


def _deref(machine: Engine, op: cpp.Deref, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    found = access.deref(machine, frame.registers[op.src])
    return _kept(frame, op.dst, found if op.slot or found is UNBOUND else access.value(machine, found))


def _address_of(machine: Engine, op: cpp.AddressOf, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = access.address(machine, frame.registers[op.src])


def _read(machine: Engine, op: cpp.Read, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = read(machine, frame.registers[op.src])


def _step(machine: Engine, op: cpp.Step, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    done = assigning.step(machine, op.operator, frame.registers[op.slot], prefix=op.prefix)
    if op.dst == ops.NO_REGISTER:
        return DEAD if done is UNBOUND else None
    return _kept(frame, op.dst, done)


def _copy(machine: Engine, op: cpp.Copy, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = frame.registers[op.src]
    if value is UNBOUND:
        return None
    type_ = NONE if op.type == ops.NO_REGISTER else frame.registers[op.type]
    if type_.__class__ is TypeOf:
        type_ = pointee(type_) or type_
    if type_ is NONE or type_.__class__ is TypeOf:
        return _kept(frame, op.dst, copied(machine, as_value(machine, value)))
    held = read(machine, value)
    sliced = held.__class__ in (Ref, Choice) and as_type.is_of_another(machine, held, type_)
    return _kept(frame, op.dst, as_type.as_one(machine, held, type_) if sliced else copied(machine, held))


def _convert(machine: Engine, op: cpp.Convert, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = frame.registers[op.src]
    if value is UNBOUND:
        frame.registers[op.dst] = value
        return None
    if op.kind == "placed":
        return _kept(frame, op.dst, assigning.put_in(machine, frame.registers[op.type], value))
    frame.cast[op.dst] = frame.registers[op.type]
    return _kept(frame, op.dst, as_type.convert(machine, value, frame.registers[op.type], op.kind))


def _construct(machine: Engine, op: cpp.Construct, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    type_ = frame.registers[op.type]
    args = decaying(machine, given(frame, op.arguments))
    frame.handed = frame.fresh
    value = again.made(machine, op, type_, args, fresh=initialising.is_fresh(frame, op.arguments, args))
    frame.op, frame.sequence = op, 0
    return _kept(frame, op.dst, value)


def _initialise(machine: Engine, op: cpp.Initialise, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    return None if initialising.initialise(machine, op, frame, given) else DEAD


def _invoke(machine: Engine, op: cpp.Invoke, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    args = decaying(machine, given(frame, op.arguments))
    frame.handed, frame.fresh, frame.returned = frame.fresh, UNBOUND, None
    value = calls.invoke(machine, frame.registers[op.func], args)
    return _result(machine, frame, op, value)


def _invoke_member(machine: Engine, op: cpp.InvokeMember, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    naming.note_reached(machine, op.name, frame)
    args = decaying(machine, given(frame, op.arguments))
    types = access.types_of(frame, op.types)
    scope = frame.registers[op.scope] if op.scope != ops.NO_REGISTER else None
    frame.handed, frame.fresh, frame.returned = frame.fresh, UNBOUND, None
    obj = frame.registers[op.obj]

    def declared() -> Value:
        return frame.registers[op.static] if machine.run(op.seen, frame) else UNBOUND

    value = methods.invoke(
        machine,
        frame,
        obj,
        op.name,
        args,
        types,
        scope=scope,
        own=op.obj == 0 and bool(naming.this_of(frame)),
        constant=op.constant,
        declared=declared if op.static != ops.NO_REGISTER else None,
        given=op.given,
    )
    return _result(machine, frame, op, value)


def _result(machine: Engine, frame: Frame, op: cpp.Invoke | cpp.InvokeMember, value: Value) -> bool | None:
    """What a call gives: a copy of it, where it may be a reference and a value is wanted."""
    frame.op, frame.sequence = op, 0
    is_copied = op.copied and value is not UNBOUND and value != frame.fresh
    return _kept(frame, op.dst, as_type.copy_of_result(machine, frame, value) if is_copied else value)


def _make_lambda(machine: Engine, op: cpp.MakeLambda, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    cells = tuple([frame.cells[c] for c in op.captures])
    function = Function(op.code, frame.module, cells, (), ())
    machine.log.add_function(op.code, stub=frame.stub)
    copies = tuple([frame.registers[r] for r in op.copies])
    frame.registers[op.dst] = Partial(function, copies, ()) if copies else function


def _make_type(_machine: Engine, op: cpp.MakeType, frame: Frame) -> None:
    inner = tuple([frame.registers[r] for r in op.inner])
    if op.kind == "pointer":
        made: Value = pointer_to(inner[0])
    elif op.kind == "reference":
        made = inner[0]
    elif op.kind == "array":
        made = TypeOf("array", inner)
    else:
        made = TypeOf(op.kind, inner)
    frame.registers[op.dst] = made


def _type_of_value(machine: Engine, op: cpp.TypeOfValue, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    src = frame.registers[op.src]
    frame.registers[op.dst] = detection.member_type(machine, src, op.member) if op.member else plain_type(machine, src)


def _braces(_machine: Engine, op: cpp.Braces, frame: Frame) -> None:
    values = given(frame, op.items)
    if any(op.names):
        pairs = tuple(Tuple((Const(n), v)) for n, v in zip(op.names, values, strict=False))
        frame.registers[op.dst] = Tuple((construct.DESIGNATED, *pairs))
    else:
        frame.registers[op.dst] = Tuple(values)


def _default(machine: Engine, op: cpp.Default, frame: Frame) -> bool | None:
    if frame.registers[op.dst] is UNBOUND:
        return None if machine.run(op.body, frame) else DEAD
    return None


def _static_local(machine: Engine, op: cpp.StaticLocal, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    address = machine.place_key(("static", frame.code.key, op.number, frame.module.address, *instance(frame)))
    if machine.own(address) is None:
        if not machine.run(op.body, frame):
            return DEAD
        machine.lasting.add(address)
        machine.put(address, Obj("cell", NONE, {"value": frame.registers[op.result]}))
    held = machine.at(address).attrs.get("value", NONE)
    frame.registers[op.dst] = held if isinstance(held, (Ref, Slot)) else Slot(Ref(address), "cell", None)
    return None


def _end_scope(machine: Engine, op: cpp.EndScope, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    for register in reversed(op.variables):
        if not endings.end(machine, read(machine, frame.registers[register])):
            return DEAD
    return None


_CAUSES: Final = {"macro": Cause.ENVIRONMENT, "syntax": Cause.OPERATION, "language": Cause.OPERATION}


def _unknown_value(machine: Engine, op: cpp.UnknownValue, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    if op.cause == "syntax" and not frame.stub:
        machine.report("RW206", f"this statement is not understood: {op.subject}")
    if op.subject == "goto" and not frame.stub:
        machine.report(
            "RW206", "goto is not followed: what comes behind it, and behind its label, may do something else"
        )
    frame.registers[op.dst] = machine.unknown(_CAUSES[op.cause], op.subject)


def _elements(machine: Engine, op: cpp.Elements, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    found = methods.iterated(machine, frame.registers[op.src])
    return _kept(frame, op.dst, elements(machine, found, slots=op.slot))


def _destructure(machine: Engine, op: cpp.Destructure, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    source = frame.registers[op.src]
    fields = access.fields_of(machine, source)
    if fields is not None and not has_content(machine, read(machine, source)):
        found = [access.member(machine, frame, source, name, (), own=False) for name in fields[: len(op.dsts)]]
        found += [machine.unknown(Cause.OPERATION, "structured binding")] * (len(op.dsts) - len(found))
        values = found if op.slot else [read(machine, v) for v in found]
    else:
        values = list(parts(machine, within(machine, source), len(op.dsts), slots=op.slot))
    for register, value in zip(op.dsts, values, strict=True):
        frame.registers[register] = value


def _local_symbol(machine: Engine, op: cpp.LocalSymbol, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    symbol = op.symbol
    if symbol.kind is SymbolKind.CLASS:
        held = [frame.registers[r] for r in op.registers]
        around = dict(zip(op.names, held, strict=True))
        cls = instance_of(machine, symbol, frame.module, (), {}, around, apart=tuple(held[: op.types]))
        frame.registers[op.dst] = cls
    else:
        frame.registers[op.dst] = External(".".join(n for n in (*symbol.scope, symbol.name) if n))


def _raise(machine: Engine, op: ops.Raise, frame: Frame) -> bool:
    frame.op, frame.sequence = op, 0
    if op.src == ops.NO_REGISTER:
        python_exceptions.again(machine)
        return DEAD
    thrown = read(machine, frame.registers[op.src])
    kept = [
        o if isinstance(o, Ref) else machine.allocate(Obj("instance", type_of(machine, o)), "thrown")
        for o in options(thrown)
    ]
    throw(machine, join_all(kept))
    return DEAD


OWN: Final[dict[type[ops.Op], Handler]] = {
    ops.Assume: narrowing.assume,
    ops.Raise: _raise,
    ops.Try: python_exceptions.attempt,
    ops.NewCell: PYTHON_OWN[ops.NewCell],
    ops.ForEach: PYTHON_OWN[ops.ForEach],
    cpp.Name: _name,
    cpp.CellSlot: _cell_slot,
    cpp.Member: _member,
    cpp.Item: _item,
    cpp.Declared: _declared,
    cpp.Deref: _deref,
    cpp.AddressOf: _address_of,
    cpp.Read: _read,
    cpp.Assign: assigning.perform,
    cpp.Narrow: narrowing.narrow,
    cpp.Step: _step,
    cpp.Copy: _copy,
    cpp.Convert: _convert,
    cpp.Construct: _construct,
    cpp.Initialise: _initialise,
    cpp.Invoke: _invoke,
    cpp.InvokeMember: _invoke_member,
    cpp.MakeLambda: _make_lambda,
    cpp.MakeType: _make_type,
    cpp.TypeOfValue: _type_of_value,
    cpp.Braces: _braces,
    cpp.Spread: spreading.spread,
    cpp.Placed: spreading.place,
    cpp.Default: _default,
    cpp.StaticLocal: _static_local,
    cpp.EndScope: _end_scope,
    cpp.UnknownValue: _unknown_value,
    cpp.Elements: _elements,
    cpp.Destructure: _destructure,
    cpp.LocalSymbol: _local_symbol,
}
