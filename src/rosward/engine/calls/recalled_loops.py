# SPDX-License-Identifier: Apache-2.0
"""Which loops inside of loops need not be followed again, because nothing that they read has changed?

for box in boxes:                        followed until nothing changes
    for side in box.sides: area += 1     in the last turn it starts from what it started from before, and ends as it did
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.engine.calls import recalled
from rosward.ir import ops
from rosward.ir.op import walk
from rosward.ir.registers import reads, writes

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame
    from rosward.ir.program import Code

Loop = ops.While | ops.ForEach
Follow = Callable[..., "bool | None"]

_LEAVING: Final = (
    ops.Return,
    ops.Raise,
    ops.Yield,
    ops.Await,
    ops.Try,
    ops.With,
    ops.Delete,
    ops.MakeClass,
    ops.NewCell,
)
"""Operations that leave a loop, or change more of the call than registers."""


def recalling(follow: Follow) -> Follow:
    """The handler of a loop, which is not asked where the loop would end as it did."""

    def loop(machine: Engine, op: Loop, frame: Frame) -> bool | None:
        used = _used(machine, op, frame)
        if used is None:
            return follow(machine, op, frame)
        key = f"{frame.code.key}:{op.number}"
        registers = frame.registers
        given = tuple([registers[r] for r in used[0]])
        place = recalled.place_of(machine, key, (op, frame.cells, given), frame.context)
        if place is None:
            return follow(machine, op, frame)
        found = recalled.known(machine, place)
        if found is not None:
            recalled.repeated(machine, key, found)
            for register, value in zip(used[1], found.left, strict=True):
                registers[register] = value
            frame.op, frame.sequence = found.stands
            return None
        call = recalled.begun(machine)
        outer, machine.asked_for = machine.asked_for, set()
        outer_wrote, machine.summaries.wrote = machine.summaries.wrote, set()
        try:
            alive = follow(machine, op, frame)
            if alive is not False:
                call.left = tuple([frame.registers[r] for r in used[1]])
                call.stands = frame.op, frame.sequence
                recalled.ended(machine, place, key, call)
        finally:
            recalled.closed(machine, call)
            asked_for, machine.asked_for = machine.asked_for, outer
            outer |= asked_for
            wrote, machine.summaries.wrote = machine.summaries.wrote, outer_wrote
            outer_wrote |= wrote
        return alive

    return loop


def _used(machine: Engine, op: Loop, frame: Frame) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """The registers that a loop reads or writes, and those that it writes; None where it is followed each time."""
    if not machine.precision.fixpoints or machine.precision.coarse or machine.catchers:
        return None
    if frame.yielded is not None or frame.namespace >= 0:
        return None
    known = machine.summaries.loops
    key = (frame.code.key, op.number)
    if key not in known:
        known[key] = _registers(op, frame.code)
    return known[key]


def _registers(op: Loop, code: Code) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """The same for any call of its body; None where it does more than to compute."""
    read: dict[int, None] = {}
    if "__class__" in code.free and code.registers:
        read[0] = None  # for `super()`
    written: dict[int, None] = {}
    for inner in walk([op]):
        if isinstance(inner, _LEAVING):
            return None
        read.update(dict.fromkeys(reads(inner)))
        written.update(dict.fromkeys(writes(inner)))
    return tuple({**read, **written}), tuple(written)
