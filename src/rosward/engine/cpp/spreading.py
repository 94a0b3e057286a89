# SPDX-License-Identifier: Apache-2.0
"""What is done for each item of a parameter pack, and where do the items stand?

template<typename... T> void open(T... names)
{
  ((names += "/in"), ...);      each of `names` is a variable of this call, which is written
  (advertise(names), ...);
}
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import lift, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Ref, Value
from rosward.engine.cpp import operators
from rosward.engine.cpp.converting import as_value
from rosward.engine.cpp.packs import items_of
from rosward.engine.running.frame import Frame, is_running
from rosward.ir import cpp, ops
from rosward.models.cpp.values.copies import copied

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["place", "spread"]

_DEAD: Final = False


def spread(machine: Engine, op: cpp.Spread, frame: Frame) -> bool | None:
    """Run a pattern for each item of its packs, and take the results together."""
    frame.op, frame.sequence = op, 0
    packs = [items_of(frame.registers[r]) for r in op.packs]
    several = [items for items in packs if items is not None]
    if len(several) < len(packs):
        frame.registers[op.dst] = machine.unknown(Cause.CALL, "parameter pack")
        return None
    results: list[Value] = []
    context = frame.context
    for number, items in enumerate(zip(*several, strict=False)):
        frame.context = machine.context(context, frame.code.key, op.number, number)
        for register, item in zip(op.items, items, strict=True):
            frame.registers[register] = item
        alive = machine.run(op.body, frame)
        frame.context = context
        if not alive:
            return _DEAD
        results.append(frame.registers[op.result])
    frame.op, frame.sequence = op, 0
    if op.init != ops.NO_REGISTER:
        results.insert(len(results) if op.right else 0, frame.registers[op.init])
    found = operators.folded(machine, op.operator, results, right=op.right) if op.operator else Tuple(tuple(results))
    frame.registers[op.dst] = found
    return _DEAD if found is UNBOUND else None


def place(machine: Engine, op: cpp.Placed, frame: Frame) -> None:
    """Where a value stands, or each item of a pack."""
    frame.op, frame.sequence = op, 0
    value = frame.registers[op.src]
    if op.pack:
        frame.registers[op.dst] = lift(lambda v: _placed_items(machine, op, frame, v), value)
    elif value is not UNBOUND:
        frame.registers[op.dst] = _placed(machine, op, frame, value, 0)


def _placed_items(machine: Engine, op: cpp.Placed, frame: Frame, pack: Value) -> Value:
    if not isinstance(pack, Tuple):
        return pack
    return Tuple(tuple(_placed(machine, op, frame, item, number) for number, item in enumerate(pack.items)))


def _placed(machine: Engine, op: cpp.Placed, frame: Frame, value: Value, number: int) -> Value:
    """The place of a value; that of a parameter is the one of the call before, which is over."""
    held = value if op.how == "found" else copied(machine, as_value(machine, value))
    if op.how == "taken" or held is UNBOUND or any(o.__class__ in (Ref, Slot) for o in options(held)):
        return held
    cell = Obj("cell", NONE, {"value": held})
    if op.how == "kept":
        return Slot(machine.allocate(cell, number), "cell", None)
    key = ("placed", frame.context, frame.code.key, op.number, number)
    put = machine.place_at if is_running(machine.frames[:-1], frame.code, frame.context) else machine.place_instead
    found = Slot(Ref(put(key, cell)), "cell", None)
    if op.how == "found":
        frame.found = (*frame.found, found)
    return found
