# SPDX-License-Identifier: Apache-2.0
"""What each operation does to the state: one handler per operation, in a table by its class.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

import builtins
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import join
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Const, Function, Ref, Slice, Value
from rosward.engine import control, narrowing
from rosward.engine.frame import Frame
from rosward.engine.python import (
    assignment,
    attributes,
    calls,
    classes,
    contexts,
    equality,
    exceptions,
    items,
    iteration,
    modules,
    removal,
    suspending,
)
from rosward.ir import ops
from rosward.models.python.strings.formatting import joined
from rosward.models.python.strings.methods import format_value
from rosward.models.ros import parameter_table

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

Handler = Callable[["Engine", Any, Frame], bool | None]
DEAD: Final = False


def _const(machine: Engine, op: ops.Const, frame: Frame) -> None:
    frame.registers[op.dst] = machine.library.constant(op)


def _move(_machine: Engine, op: ops.Move, frame: Frame) -> None:
    frame.registers[op.dst] = frame.registers[op.src]


def _load_global(machine: Engine, op: ops.LoadGlobal, frame: Frame) -> None:
    record = machine.at(frame.module.address)
    found = record.attrs.get(op.name)
    if found is None or found is UNBOUND:
        frame.op, frame.sequence = op, 0
        found = modules.load_global(machine, frame.module, op.name)
    elif op.name in record.partial and hasattr(builtins, op.name):
        found = join(found, modules.load_global(machine, frame.module, op.name))
    frame.registers[op.dst] = found


def _store_global(machine: Engine, op: ops.StoreGlobal, frame: Frame) -> None:
    modules.store_global(machine, frame.module, op.name, frame.registers[op.src])


def _load_name(machine: Engine, op: ops.LoadName, frame: Frame) -> None:
    found = machine.at(frame.namespace).attrs.get(op.name) if frame.namespace >= 0 else None
    if found is None and op.cell != ops.NO_REGISTER:
        found = machine.at(frame.cells[op.cell]).attrs.get("value")
    if found is None or found is UNBOUND:
        found = machine.at(frame.module.address).attrs.get(op.name)
    if found is None or found is UNBOUND:
        frame.op, frame.sequence = op, 0
        found = modules.load_global(machine, frame.module, op.name)
    frame.registers[op.dst] = found


def _store_name(machine: Engine, op: ops.StoreName, frame: Frame) -> None:
    machine.put(frame.namespace, machine.at(frame.namespace).with_attr(op.name, frame.registers[op.src]))


def _load_cell(machine: Engine, op: ops.LoadCell, frame: Frame) -> None:
    found = machine.at(frame.cells[op.cell]).attrs.get("value", UNBOUND)
    if found is UNBOUND:
        frame.op, frame.sequence = op, 0
        found = machine.unknown(Cause.ERROR, "variable without a value")
    frame.registers[op.dst] = found


def _store_cell(machine: Engine, op: ops.StoreCell, frame: Frame) -> None:
    ref = Ref(frame.cells[op.cell])
    machine.update(ref, machine.obj(ref).with_attr("value", frame.registers[op.src]))


def _new_cell(machine: Engine, op: ops.NewCell, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    cell = machine.allocate(Obj("cell", NONE), op.cell)
    cells = list(frame.cells)
    cells[op.cell] = cell.address
    frame.cells = tuple(cells)


def _load_attr(machine: Engine, op: ops.LoadAttr, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    if op.name in machine.library.creating:
        machine.reached.add((frame.code.key, op.number))
    value = attributes.load(machine, frame.registers[op.obj], op.name)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _store_attr(machine: Engine, op: ops.StoreAttr, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    if op.narrowing:
        narrowing.narrow_attribute(machine, frame.registers[op.obj], op.name, frame.registers[op.src])
        return None
    alive = assignment.store(machine, frame.registers[op.obj], op.name, frame.registers[op.src])
    return None if alive else DEAD


def _load_item(machine: Engine, op: ops.LoadItem, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = items.load(machine, frame.registers[op.obj], frame.registers[op.index])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _store_item(machine: Engine, op: ops.StoreItem, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    if op.narrowing:
        narrowing.narrow_item(machine, frame.registers[op.obj], frame.registers[op.index], frame.registers[op.src])
        return
    items.store(machine, frame.registers[op.obj], frame.registers[op.index], frame.registers[op.src])


def _delete(machine: Engine, op: ops.Delete, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    if op.kind == "local":
        frame.registers[op.obj] = UNBOUND
    elif op.kind == "global":
        modules.store_global(machine, frame.module, op.name, UNBOUND)
    elif op.kind == "item":
        items.delete(machine, frame.registers[op.obj], frame.registers[op.index])
    elif op.kind == "name" and op.name in machine.at(frame.namespace).attrs:
        machine.put(frame.namespace, machine.at(frame.namespace).with_attr(op.name, UNBOUND))
    elif op.kind == "attr":
        removal.delete(machine, frame.registers[op.obj], op.name)


def _unary(machine: Engine, op: ops.Unary, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = equality.unary(machine, op.operator, frame.registers[op.src])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _binary(machine: Engine, op: ops.Binary, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    registers = frame.registers
    value = equality.binary(machine, op.operator, registers[op.left], registers[op.right], inplace=op.inplace)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _compare(machine: Engine, op: ops.Compare, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = equality.compare(machine, op.operator, frame.registers[op.left], frame.registers[op.right])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _call(machine: Engine, op: ops.Call, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    registers = frame.registers
    function = registers[op.func]
    if op.simple is not None:
        value = calls.call(machine, function, tuple([registers[r] for r in op.simple]), {})
    else:
        value = calls.call_with(machine, function, op.arguments, registers)
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _build(machine: Engine, op: ops.Build, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = items.build(machine, op, frame)


def _format(machine: Engine, op: ops.Format, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    registers = frame.registers
    known: list[Value] = []
    for part in op.parts:
        if isinstance(part, str):
            known.append(Const(part))
            continue
        register, conversion, spec = part
        spec_value = registers[spec] if spec != ops.NO_REGISTER else None
        known.append(format_value(machine, registers[register], conversion, spec_value))
    frame.registers[op.dst] = joined(machine, known)


def _make_function(machine: Engine, op: ops.MakeFunction, frame: Frame) -> None:
    registers = frame.registers
    frame.registers[op.dst] = Function(
        op.code,
        frame.module,
        tuple([frame.cells[c] for c in op.captures]),
        tuple([registers[r] for r in op.defaults]),
        tuple([(name, registers[r]) for name, r in op.kwdefaults]),
    )
    machine.log.seen(op.code, stub=frame.stub)


def _make_class(machine: Engine, op: ops.MakeClass, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = classes.make(machine, op, frame)


def _import(machine: Engine, op: ops.Import, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = modules.import_module(machine, op, frame)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _import_from(machine: Engine, op: ops.ImportFrom, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = modules.import_from(machine, op, frame)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _import_star(machine: Engine, op: ops.ImportStar, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    return None if modules.import_star(machine, op, frame) else DEAD


def _unpack(machine: Engine, op: ops.Unpack, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    return None if items.unpack(machine, op, frame) else DEAD


def _intrinsic(machine: Engine, op: ops.Intrinsic, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    arguments = [frame.registers[r] for r in op.arguments]
    if op.name == "slice":
        frame.registers[op.dst] = Slice(arguments[0], arguments[1], arguments[2])
    else:
        frame.registers[op.dst] = items.intrinsic(machine, op.name, arguments, frame)


def _assume(machine: Engine, op: ops.Assume, frame: Frame) -> bool | None:
    value = frame.registers[op.src]
    frame.registers[op.dst] = value
    if value.__class__ is not Choice and op.test != "true" and not narrowing.is_open(value):
        return None
    other = frame.registers[op.other] if op.other != ops.NO_REGISTER else None
    kept = narrowing.narrowed(machine, value, op.test, other, op.sense)
    if kept is None:
        return DEAD if value.__class__ is Choice else None
    frame.registers[op.dst] = kept
    if kept != value:
        parameter_table.narrow(machine, value, kept)
    return None


def _await(machine: Engine, op: ops.Await, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = calls.wait_for(machine, frame.registers[op.src])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


HANDLERS: Final[dict[type[ops.Op], Handler]] = {
    ops.Const: _const,
    ops.Move: _move,
    ops.LoadGlobal: _load_global,
    ops.StoreGlobal: _store_global,
    ops.LoadName: _load_name,
    ops.StoreName: _store_name,
    ops.LoadCell: _load_cell,
    ops.StoreCell: _store_cell,
    ops.NewCell: _new_cell,
    ops.LoadAttr: _load_attr,
    ops.StoreAttr: _store_attr,
    ops.LoadItem: _load_item,
    ops.StoreItem: _store_item,
    ops.Delete: _delete,
    ops.Unary: _unary,
    ops.Binary: _binary,
    ops.Compare: _compare,
    ops.Call: _call,
    ops.Build: _build,
    ops.Format: _format,
    ops.MakeFunction: _make_function,
    ops.MakeClass: _make_class,
    ops.Import: _import,
    ops.ImportFrom: _import_from,
    ops.ImportStar: _import_star,
    ops.Unpack: _unpack,
    ops.Intrinsic: _intrinsic,
    ops.Assume: _assume,
    ops.Yield: suspending.yield_,
    ops.Await: _await,
    ops.If: control.branch,
    ops.While: control.loop,
    ops.ForEach: iteration.for_each,
    ops.Try: exceptions.attempt,
    ops.With: contexts.with_context,
    ops.Return: control.leave,
    ops.Raise: exceptions.raise_,
    ops.Break: control.break_,
    ops.Continue: control.continue_,
}
