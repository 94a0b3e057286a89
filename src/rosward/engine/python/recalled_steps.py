# SPDX-License-Identifier: Apache-2.0
"""Which steps of generators need not be followed again, because nothing that they read has changed?

def walk(tree): yield tree; yield from walk(tree.left); yield from walk(tree.right)      a step of the outermost makes a step of each within

A step is remembered as a call is (`recalled.py`), with both of the states that it may leave: behind the item, and where it is at its end.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rosward.domain.values import UNBOUND
from rosward.engine.calls import recalled
from rosward.engine.running.stepped import Resumption, Stepped

if TYPE_CHECKING:
    from rosward.domain.suspended import Suspension
    from rosward.domain.values import Ref
    from rosward.engine.machine import Engine
    from rosward.engine.running.summaries import Call


def recalling(
    machine: Engine, ref: Ref, suspension: Suspension, action: Resumption, follow: Callable[[], Stepped]
) -> Stepped:
    """One step: `follow` is not asked where it would end as it did."""
    if machine.watch is not None or not suspension.points:
        return follow()
    function = next(iter(suspension.points)).function
    key = f"{function.code.key}:step"
    place = recalled.place_of(machine, key, (function, ref.address, action), 0)
    if place is None:
        return follow()
    found = recalled.known(machine, place)
    if found is not None:
        return _repeated(machine, key, found)
    call = recalled.begun(machine)
    outer, machine.asked_for = machine.asked_for, set()
    outer_wrote, machine.summaries.wrote = machine.summaries.wrote, set()
    noted, machine.noted = machine.noted, 0
    importing = bool(machine.catchers) and machine.catchers[-1].importing
    if importing:
        machine.catchers[-1].importing = False
    try:
        item, ended, value = stepped = follow()
        call.level, machine.noted = machine.noted, max(machine.noted, noted)
        if item is not UNBOUND or ended is not None:
            call.value, call.left = item, (value,)  # what StopIteration carries
            recalled.ended(machine, place, key, call, ended)
    finally:
        recalled.closed(machine, call)
        asked_for, machine.asked_for = machine.asked_for, outer
        outer |= asked_for
        wrote, machine.summaries.wrote = machine.summaries.wrote, outer_wrote
        outer_wrote |= wrote
        if importing:
            machine.catchers[-1].importing = True
    return stepped


def _repeated(machine: Engine, key: str, call: Call) -> Stepped:
    """What a step gives; the machine is in the state behind it."""
    before = None if call.over is None else machine.state.copy()
    item = recalled.repeated(machine, key, call)
    if before is not None and call.over is not None:
        recalled.change(machine, before, call, call.over)
    return Stepped(item, before, call.left[0])
