# SPDX-License-Identifier: Apache-2.0
"""Which generators may be left before their end? Python closes them: what their `finally` and `__exit__` do, happens then.

for x in words(): break       behind the loop, in its order
next(words())                 at any time: nothing tells how long somebody holds it
for x in words(): raise …     the same
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import Native, Partial, Tuple
from rosward.domain.memory import Heap
from rosward.domain.state import join_states
from rosward.domain.suspended import Suspension
from rosward.domain.values import Ref, Value
from rosward.engine.running.frame import Snapshot

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def close_behind(machine: Engine, left: Snapshot, source: Value) -> None:
    """Behind a loop that was left early, Python closes its generator where nothing else holds it."""
    if not isinstance(source, Ref):
        return
    here, machine.state = machine.state, left.state
    acting = _acting(machine, machine.state.heap, source)
    if source.address in acting:
        machine.state = left.state.copy()
        machine.close_generator(source)
        left.state = join_states(left.state, machine.state, machine.fresh_version)
    for address in acting:
        if address != source.address:
            _close_later(machine, Ref(address))
    machine.state = here


def watch(machine: Engine, iterator: Value) -> None:
    """A generator was advanced, and may be dropped at this point."""
    for option in options(iterator):
        if isinstance(option, Ref):
            for address in _acting(machine, machine.state.heap, option):
                _close_later(machine, Ref(address))


def watch_raising(machine: Engine, source: Value, raised: int) -> None:
    """Behind a loop that an exception may have left: `raised` says how many there were before it."""
    states = [snapshot.state for catcher in machine.catchers[-1:] for snapshot in catcher.arrivals.values()]
    states += [catcher.snapshot.state for catcher in machine.catchers[-1:] if catcher.level]
    if machine.raised != raised and machine.ends is not None:
        states.append(machine.ends)
    if isinstance(source, Ref):
        for address in {address: None for s in states for address in _acting(machine, s.heap, source)}:
            _close_later(machine, Ref(address))


def _acting(machine: Engine, heap: Heap, generator: Ref) -> list[int]:
    """Which generators end with this one, and may stand in a `try` or `with`, so that closing them runs something: it, and those it holds.

    It holds what its variables and loops do; lists and tuples of those, too.
    """
    found: list[int] = []
    seen: set[int] = set()
    pending: list[Value] = [generator]
    while pending:
        for value in options(pending.pop()):
            if isinstance(value, Tuple):
                pending += value.items
            if not isinstance(value, Ref) or value.address in seen:
                continue
            seen.add(value.address)
            record = heap.get(value.address)
            payload = None if record is None else record.payload
            if isinstance(payload, Suspension):
                if any(s.part == "body" for p in payload.points for s in p.path):
                    found.append(value.address)
                pending += [kept for values in payload.points.values() for kept in values]
    machine.asked_for |= seen
    return found


def _close_later(machine: Engine, ref: Ref) -> None:
    machine.schedule(Partial(Native("generator.close"), (ref,), ()), (), "end of a generator")
