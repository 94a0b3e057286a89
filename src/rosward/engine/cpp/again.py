# SPDX-License-Identifier: Apache-2.0
"""What has ended where a variable of a block is declared again?

for (auto & name : names) {
    std::ostringstream text;      the one of the turn before has ended: this is one stream, not one of several
    text << "arm_" << name;
}

What an object handed on before it ended are copies, so nothing leads to it any more. That is so within one call: another call of the
same function (one that calls itself) has variables of its own.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.engine.cpp import initialising
from rosward.models.cpp.values.copies import is_copied

if TYPE_CHECKING:
    from rosward.domain.values import Value
    from rosward.engine.machine import Engine
    from rosward.ir import cpp

__all__ = ["made"]


def made(machine: Engine, op: cpp.Construct, type_: Value, args: tuple[Value, ...], *, fresh: bool) -> Value:
    """A value of a type; that of a variable of a block takes the place of what the same declaration made before in this call."""
    if not op.local:
        return initialising.made(machine, type_, args, op.form, fresh=fresh)
    frame = machine.frames[-1]
    ended = {address for address in frame.declared.get(op.number, ()) if _may_be_replaced(machine, address)}
    ended -= machine.unheld
    machine.unheld |= ended
    placed: list[int] = []
    frame.placed = placed
    try:
        return initialising.made(machine, type_, args, op.form, fresh=fresh)
    finally:
        frame.placed = None
        machine.unheld -= ended
        frame.declared[op.number] = placed


def _may_be_replaced(machine: Engine, address: int) -> bool:
    """Whether what stands at an address is one object, of which others have got copies alone."""
    obj = machine.own(address)
    return obj is not None and not obj.many and is_copied(machine, obj)
