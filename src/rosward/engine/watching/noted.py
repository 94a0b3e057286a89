# SPDX-License-Identifier: Apache-2.0
"""What is noted of an operation in Python: that it runs, and that control comes out; whom it calls, which variable it uses, which of its operands
are constants that name a slot; what it gives.
"""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.values import NONE, Const
from rosward.engine.running.seen import ALIVE, REACHED, SILENT, Activation
from rosward.ir import cpp, ops
from rosward.ir.registers import reads

if TYPE_CHECKING:
    from rosward.engine.machine import Engine, Handler
    from rosward.engine.running.frame import Frame
    from rosward.engine.running.seen import Seen

Find = Callable[["Seen", Any, "Frame"], None]
ActivationOf = Callable[["Engine", "Frame", int], Activation]
"""That of a frame, at its depth."""

CELLED: Final = frozenset({ops.LoadCell, ops.StoreCell, cpp.CellSlot})
_KEYED: Final = frozenset({ops.Compare, ops.StoreItem, ops.Build, ops.Intrinsic})
"""Operations of which an operand may name a slot."""


def noting(cls: type[ops.Op], handler: Handler, activation_of: ActivationOf) -> Handler:
    """The handler of a kind of operation, noting what it finds and what it gives. Of most there is nothing but the way of control."""
    before = _finds(cls)
    if before is not None:
        return _apart(_finding(handler, activation_of, before, gives=hasattr(cls, "dst")))
    if cls is ops.Unpack:
        return _apart(_unpacking(handler, activation_of))
    return _apart(
        _giving(handler, activation_of)
        if hasattr(cls, "dst") and cls not in _UNSEEN
        else _passing(handler, activation_of)
    )


def _passing(handler: Handler, activation_of: ActivationOf) -> Handler:
    """Of an operation of which nothing but the way of control is noted."""

    def noting(machine: Engine, op: Any, frame: Frame) -> bool | None:
        known = (frame.seen or activation_of(machine, frame, len(machine.frames) - 1)).seen
        number = op.number
        if number not in known:
            known[number] = REACHED
        result = handler(machine, op, frame)
        if result is not False:
            seen = known[number]
            if seen is REACHED:
                known[number] = ALIVE
            elif seen is not ALIVE:
                seen.alive = True
        return result

    return noting


def _giving(handler: Handler, activation_of: ActivationOf) -> Handler:
    """Of one that gives a value."""

    def noting(machine: Engine, op: Any, frame: Frame) -> bool | None:
        activation = frame.seen or activation_of(machine, frame, len(machine.frames) - 1)
        known, number = activation.seen, op.number
        if number not in known:
            known[number] = REACHED
        result = handler(machine, op, frame)
        if result is False:
            return False
        seen, value = known[number], frame.registers[op.dst]
        if value.__class__ in SILENT or (value.__class__ is Const and not value.origins):  # most say nothing
            if seen is REACHED:
                known[number] = ALIVE
            elif seen is not ALIVE:
                seen.alive = True
            return result
        if seen is REACHED or seen is ALIVE:
            seen = activation.of(number)
        if value is not seen.gave:
            seen.give(value)
        seen.alive = True
        return result

    return noting


def _finding(handler: Handler, activation_of: ActivationOf, before: Find, *, gives: bool) -> Handler:
    """Of one of which is noted what it finds, too."""

    def noting(machine: Engine, op: Any, frame: Frame) -> bool | None:
        activation = frame.seen or activation_of(machine, frame, len(machine.frames) - 1)
        seen = activation.of(op.number)
        before(seen, op, frame)
        result = handler(machine, op, frame)
        if result is False:
            return False
        if gives:
            value = frame.registers[op.dst]
            if value is not seen.gave and value.__class__ not in SILENT:
                if value.__class__ is not Const or value.origins:
                    seen.give(value)
        seen.alive = True
        return result

    return noting


def _unpacking(handler: Handler, activation_of: ActivationOf) -> Handler:
    """Of one that gives several."""

    def noting(machine: Engine, op: Any, frame: Frame) -> bool | None:
        activation = frame.seen or activation_of(machine, frame, len(machine.frames) - 1)
        seen = activation.of(op.number)
        if frame.registers[op.src].__class__ is not Tuple:
            seen.untupled = True
        result = handler(machine, op, frame)
        if result is not False:
            seen.give_several([frame.registers[r] for r in op.dsts])
            seen.alive = True
        return result

    return noting


def _apart(handler: Handler) -> Handler:
    """The same, with code of its own: CPython makes code quick for the types that it meets, which are others for each kind of operation."""
    assert isinstance(handler, FunctionType)
    made: Handler = FunctionType(
        handler.__code__.replace(), handler.__globals__, handler.__name__, None, handler.__closure__
    )
    return made


_UNSEEN: Final = frozenset({ops.Const, ops.Move, ops.Assume})
"""Operations of which nobody asks what they gave."""


def _finds(cls: type[ops.Op]) -> Find | None:
    """What notes that of a kind of operation; None where there is nothing to note."""
    if cls is ops.Call:
        return _function
    if cls in CELLED:
        return _cell
    if cls is ops.LoadItem:
        return _item
    return _keys() if cls in _KEYED else None


def _function(seen: Seen, op: ops.Call, frame: Frame) -> None:
    registers, keys = frame.registers, seen.keys
    for argument in op.arguments[:2]:
        if keys.get(argument.register, NONE) is not None:  # else it is known to be different things
            seen.key(argument.register, registers[argument.register])
    function = registers[op.func]
    if function is seen.called or function == seen.called:
        return
    seen.called = function
    if function not in seen.functions:
        seen.note("functions", function)
        seen.several = seen.several or len([o for o in options(function) if o != NONE]) > 1


def _cell(seen: Seen, op: ops.LoadCell | ops.StoreCell, frame: Frame) -> None:
    seen.hold("cells", (frame.cells[op.cell],))


def _item(seen: Seen, op: ops.LoadItem, frame: Frame) -> None:
    registers = frame.registers
    seen.key(op.index, registers[op.index])
    if registers[op.obj].__class__ is not Tuple:
        seen.untupled = True


def _keys() -> Find:
    known: dict[ops.Op, tuple[int, ...]] = {}

    def find(seen: Seen, op: ops.Op, frame: Frame) -> None:
        registers = known.get(op)
        if registers is None:
            registers = known[op] = _naming(op)
        for register in registers:
            seen.key(register, frame.registers[register])

    return find


def _naming(op: ops.Op) -> tuple[int, ...]:
    """The operands that may name a slot."""
    if isinstance(op, ops.StoreItem):
        return (op.index,)
    if isinstance(op, ops.Compare):
        return (op.left, op.right) if op.operator in ("==", "!=") else ()
    if isinstance(op, ops.Build):
        return tuple([register for _, register in op.items]) if op.kind == "dict" else ()
    return tuple(reads(op))
