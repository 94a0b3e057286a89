# SPDX-License-Identifier: Apache-2.0
"""What has ended where a variable is declared again?

for (auto & name : names) {
    std::ostringstream text;      the one of the turn before has ended: this is one stream, not one of several
    text << "arm_" << name;
}

std::string topic(int number) {
    std::ostringstream text;      so has the one of the call before
    text << "arm_" << number;
    return text.str();
}

What an object handed on before it ended are copies, so nothing leads to it any more; unless a function returned the object itself.
Of a call that is still running (the function calls itself), the variables have not ended.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.values import Ref
from rosward.engine.cpp import initialising
from rosward.engine.running.frame import is_running
from rosward.models.cpp.values.copies import is_copied

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rosward.domain.values import Value
    from rosward.engine.machine import Engine
    from rosward.ir import cpp

__all__ = ["hand_out", "made"]


def made(machine: Engine, op: cpp.Construct, type_: Value, args: tuple[Value, ...], *, fresh: bool) -> Value:
    """A value of a type; that of a variable takes the place of what the same declaration made before, in this call or one that is over."""
    if not op.local:
        return initialising.made(machine, type_, args, op.form, fresh=fresh)
    frame = machine.frames[-1]
    variable = (frame.context, frame.code.key, op.number)
    before: Sequence[int] = frame.declared.get(op.number, ())
    is_first = not before and not is_running(machine.frames[:-1], frame.code, frame.context)
    if is_first:
        before = machine.declarations.get(variable, ())
    ended = {address for address in before if _may_be_replaced(machine, address)}
    ended -= machine.ended if is_first else machine.unheld
    (machine.ended if is_first else machine.unheld).update(ended)
    placed: list[int] = []
    frame.placed = placed
    try:
        value = initialising.made(machine, type_, args, op.form, fresh=fresh)
    finally:
        frame.placed = None
        (machine.ended if is_first else machine.unheld).difference_update(ended)
        frame.declared[op.number] = placed
    machine.declarations[variable] = (value.address,) if isinstance(value, Ref) and value.address in placed else ()
    return value


def hand_out(machine: Engine, value: Value) -> None:
    """A function returns a value: an object that it is stays where it is, as the caller has no other one."""
    for option in options(value):
        if isinstance(option, Ref):
            machine.returned.add(option.address)
        elif isinstance(option, Tuple):
            for item in option.items:
                hand_out(machine, item)


def _may_be_replaced(machine: Engine, address: int) -> bool:
    """Whether what stands at an address is one object, of which others have got copies alone."""
    obj = machine.own(address)
    return obj is not None and not obj.many and address not in machine.returned and is_copied(machine, obj)
