# SPDX-License-Identifier: Apache-2.0
"""What the operations do that Python alone has, or means in its own way: one handler per operation, in a table by its class.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import Slice
from rosward.domain.heap import Obj
from rosward.domain.values import FALSE, NONE, UNBOUND, Choice, Const, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.calls.recalled_loops import recalling
from rosward.engine.machine import Handler
from rosward.engine.python import (
    calls,
    classes,
    contexts,
    exceptions,
    items,
    iteration,
    modules,
    removal,
    suspending,
)
from rosward.engine.python.specials import one_has
from rosward.engine.running.frame import Frame
from rosward.ir import ops
from rosward.models.python.strings.formatting import joined
from rosward.models.python.strings.methods import format_value
from rosward.models.ros import parameter_tests

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

DEAD: Final = False


def _load_global(machine: Engine, op: ops.LoadGlobal, frame: Frame) -> None:
    record = machine.at(frame.module.address)
    found = record.attrs.get(op.name)
    if found is None or found is UNBOUND:
        frame.op, frame.sequence = op, 0
        found = modules.load_global(machine, frame.module, op.name)
    elif op.name in record.partial and hasattr(builtins, op.name):
        found = join(found, modules.load_global(machine, frame.module, op.name))
    if found.__class__ is Choice or (found.__class__ is Const and found.origins):
        found = parameter_tests.in_place(machine, found)
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


def _new_cell(machine: Engine, op: ops.NewCell, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    cell = machine.allocate(Obj("cell", NONE), op.cell)
    cells = list(frame.cells)
    cells[op.cell] = cell.address
    frame.cells = tuple(cells)


def _delete(machine: Engine, op: ops.Delete, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    if op.kind == "local":
        frame.registers[op.obj] = UNBOUND
    elif op.kind == "global":
        modules.store_global(machine, frame.module, op.name, UNBOUND)
    elif op.kind == "item":
        items.delete(machine, frame.registers[op.obj], frame.registers[op.index])
    elif op.kind == "cell":
        address = frame.cells[op.obj]
        machine.put(address, removal.without(machine.at(address), "value"))
    elif op.kind == "name" and op.name in machine.at(frame.namespace).attrs:
        machine.put(frame.namespace, machine.at(frame.namespace).with_attr(op.name, UNBOUND))
    elif op.kind == "attr":
        removal.delete(machine, frame.registers[op.obj], op.name)


def _build(machine: Engine, op: ops.Build, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = items.build(machine, op, frame)


_SHOWN: Final = ("__format__", "__str__", "__repr__")


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
        known.append(_formatted(machine, registers[register], conversion, spec_value))
    frame.registers[op.dst] = joined(machine, known)


def _formatted(machine: Engine, value: Value, conversion: str, spec: Value | None) -> Value:
    """What stands for a value in a text; of several objects with methods of their own for that, one is asked."""
    if one_has(machine, value, *_SHOWN):
        return each_apart(machine, options(value), lambda o: format_value(machine, o, conversion, spec))
    return format_value(machine, value, conversion, spec)


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


def _intrinsic(machine: Engine, op: ops.Intrinsic, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    arguments = [frame.registers[r] for r in op.arguments]
    if op.name == "bound":
        if arguments[0] == FALSE:
            return DEAD if machine.die("UnboundLocalError", "variable without a value", ()) is UNBOUND else None
        return None
    if op.name == "slice":
        frame.registers[op.dst] = Slice(arguments[0], arguments[1], arguments[2])
    else:
        frame.registers[op.dst] = items.intrinsic(machine, op.name, arguments, frame)
    return None


def _await(machine: Engine, op: ops.Await, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = calls.wait_for(machine, frame.registers[op.src])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


OWN: Final[dict[type[ops.Op], Handler]] = {
    ops.LoadGlobal: _load_global,
    ops.StoreGlobal: _store_global,
    ops.LoadName: _load_name,
    ops.StoreName: _store_name,
    ops.NewCell: _new_cell,
    ops.Delete: _delete,
    ops.Build: _build,
    ops.Format: _format,
    ops.MakeClass: _make_class,
    ops.Import: _import,
    ops.ImportFrom: _import_from,
    ops.ImportStar: _import_star,
    ops.Unpack: _unpack,
    ops.Intrinsic: _intrinsic,
    ops.Yield: suspending.yield_,
    ops.Await: _await,
    ops.ForEach: recalling(iteration.for_each),
    ops.Try: exceptions.attempt,
    ops.With: contexts.with_context,
    ops.Raise: exceptions.raise_,
}
