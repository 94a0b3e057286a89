# SPDX-License-Identifier: Apache-2.0
"""What the operations of the core do to the state, in any language: one handler per operation, in a table by its class.

What an attribute, a call or an operator means is asked of the language of the code that runs; its table adds what it alone has.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Choice, Const, Function, Ref
from rosward.engine import control, narrowing
from rosward.engine.calls.recalled_loops import recalling
from rosward.engine.machine import Handler
from rosward.engine.running.frame import Frame
from rosward.ir import ops
from rosward.models.ros import parameter_tests

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

DEAD: Final = False


def _const(machine: Engine, op: ops.Const, frame: Frame) -> None:
    frame.registers[op.dst] = machine.library.constant(op)


def _move(_machine: Engine, op: ops.Move, frame: Frame) -> None:
    frame.registers[op.dst] = frame.registers[op.src]


def _load_cell(machine: Engine, op: ops.LoadCell, frame: Frame) -> None:
    found = machine.at(frame.cells[op.cell]).attrs.get("value", UNBOUND)
    if found is UNBOUND:
        frame.op, frame.sequence = op, 0
        found = machine.unknown(Cause.ERROR, "variable without a value")
    elif found.__class__ is Choice or (found.__class__ is Const and found.origins):
        found = parameter_tests.in_place(machine, found)
    frame.registers[op.dst] = found


def _store_cell(machine: Engine, op: ops.StoreCell, frame: Frame) -> None:
    ref = Ref(frame.cells[op.cell])
    machine.update(ref, machine.obj(ref).with_attr("value", frame.registers[op.src]))


def _load_attr(machine: Engine, op: ops.LoadAttr, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    if op.name in machine.library.creating:
        machine.trace.reached.add((frame.code.key, op.number))
    value = machine.language.load_attr(machine, frame.registers[op.obj], op.name)
    if value.__class__ is Choice or (value.__class__ is Const and value.origins):
        value = parameter_tests.in_place(machine, value)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _store_attr(machine: Engine, op: ops.StoreAttr, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    if op.narrowing:
        narrowing.narrow_attribute(machine, frame.registers[op.obj], op.name, frame.registers[op.src])
        return None
    alive = machine.language.store_attr(machine, frame.registers[op.obj], op.name, frame.registers[op.src])
    return None if alive else DEAD


def _load_item(machine: Engine, op: ops.LoadItem, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = machine.language.load_item(machine, frame.registers[op.obj], frame.registers[op.index])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _store_item(machine: Engine, op: ops.StoreItem, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    if op.narrowing:
        narrowing.narrow_item(machine, frame.registers[op.obj], frame.registers[op.index], frame.registers[op.src])
        return
    machine.language.store_item(machine, frame.registers[op.obj], frame.registers[op.index], frame.registers[op.src])


def _unary(machine: Engine, op: ops.Unary, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = machine.language.unary(machine, op.operator, frame.registers[op.src])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _binary(machine: Engine, op: ops.Binary, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    registers = frame.registers
    value = machine.language.binary(machine, op.operator, registers[op.left], registers[op.right], inplace=op.inplace)
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _compare(machine: Engine, op: ops.Compare, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    value = machine.language.compare(machine, op.operator, frame.registers[op.left], frame.registers[op.right])
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _call(machine: Engine, op: ops.Call, frame: Frame) -> bool | None:
    frame.op, frame.sequence = op, 0
    registers = frame.registers
    function = registers[op.func]
    if op.simple is not None:
        value = machine.language.call(machine, function, tuple([registers[r] for r in op.simple]), {})
    else:
        value = machine.language.call_with(machine, function, op.arguments, registers)
    frame.op, frame.sequence = op, 0
    frame.registers[op.dst] = value
    return DEAD if value is UNBOUND else None


def _make_function(machine: Engine, op: ops.MakeFunction, frame: Frame) -> None:
    registers = frame.registers
    frame.registers[op.dst] = Function(
        op.code,
        frame.module,
        tuple([frame.cells[c] for c in op.captures]),
        tuple([registers[r] for r in op.defaults]),
        tuple([(name, registers[r]) for name, r in op.kwdefaults]),
    )
    machine.log.add_function(op.code, stub=frame.stub)


def _assume(machine: Engine, op: ops.Assume, frame: Frame) -> bool | None:
    value = frame.registers[op.src]
    frame.registers[op.dst] = value
    if value.__class__ is not Choice and op.test not in ("true", "empty") and not narrowing.is_open(value):
        return None
    other = frame.registers[op.other] if op.other != ops.NO_REGISTER else None
    frame.op, frame.sequence = op, 0
    kept = narrowing.narrowed(machine, value, op.test, other, op.sense)
    if kept is None:
        return DEAD if value.__class__ is Choice else None
    frame.registers[op.dst] = kept
    if kept != value:
        parameter_tests.narrow(machine, value, kept)
    return None


CORE: Final[dict[type[ops.Op], Handler]] = {
    ops.Const: _const,
    ops.Move: _move,
    ops.LoadCell: _load_cell,
    ops.StoreCell: _store_cell,
    ops.LoadAttr: _load_attr,
    ops.StoreAttr: _store_attr,
    ops.LoadItem: _load_item,
    ops.StoreItem: _store_item,
    ops.Unary: _unary,
    ops.Binary: _binary,
    ops.Compare: _compare,
    ops.Call: _call,
    ops.MakeFunction: _make_function,
    ops.Assume: _assume,
    ops.If: control.branch,
    ops.While: recalling(control.loop),
    ops.Return: control.leave,
    ops.Break: control.break_,
    ops.Continue: control.continue_,
}
