# SPDX-License-Identifier: Apache-2.0
"""What is noted of an operation before it runs: whom it calls, which variable it uses, which of its operands are constants that name a slot."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import options
from rosward.domain.values import NONE
from rosward.ir import cpp, ops
from rosward.ir.registers import reads

if TYPE_CHECKING:
    from rosward.engine.frame import Frame
    from rosward.engine.seen import Seen

Find = Callable[["Seen", Any, "Frame"], None]

CELLED: Final = frozenset({ops.LoadCell, ops.StoreCell, cpp.CellSlot})
_KEYED: Final = frozenset({ops.Compare, ops.LoadItem, ops.StoreItem, ops.Build, ops.Intrinsic})
"""Operations of which an operand may name a slot."""


def finding(cls: type[ops.Op]) -> Find | None:
    """What notes that of a kind of operation; None where there is nothing to note."""
    if cls is ops.Call:
        return _function
    if cls in CELLED:
        return _cell
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
    if isinstance(op, (ops.LoadItem, ops.StoreItem)):
        return (op.index,)
    if isinstance(op, ops.Compare):
        return (op.left, op.right) if op.operator == "==" else ()
    if isinstance(op, ops.Build):
        return tuple([register for _, register in op.items]) if op.kind == "dict" else ()
    return tuple(reads(op))
