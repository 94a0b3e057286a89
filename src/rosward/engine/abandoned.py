# SPDX-License-Identifier: Apache-2.0
"""Which generators may be left before their end? Python closes them: what their `finally` and `__exit__` do, happens then.

for x in words(): break       behind the loop, in its order
next(words())                 at any time: nothing tells how long somebody holds it
for x in words(): raise …     the same
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.heap import Obj
from rosward.domain.suspended import Suspension
from rosward.domain.values import Native, Partial, Ref, Value
from rosward.engine.frame import Snapshot
from rosward.engine.state import join_states

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter


def may_act_when_closed(record: Obj | None) -> bool:
    """Whether a generator may stand in a `try` or `with`, so that closing it runs something."""
    suspension = None if record is None else record.payload
    return isinstance(suspension, Suspension) and any(s.part == "body" for p in suspension.points for s in p.path)


def close_behind(machine: Interpreter, left: Snapshot, source: Value) -> None:
    """Behind a loop that was left early, Python closes its generator where nothing else holds it."""
    if isinstance(source, Ref) and may_act_when_closed(machine.state.heap.get(source.address)):
        here, machine.state = machine.state, left.state.copy()
        machine.close_generator(source)
        left.state = join_states(left.state, machine.state, machine.fresh_version)
        machine.state = here


def watch(machine: Interpreter, iterator: Value) -> None:
    """The program itself has advanced a generator, and may drop it here. A context manager runs its own to the end."""
    if machine.frames and machine.frames[-1].stub:
        return
    for option in options(iterator):
        if isinstance(option, Ref) and may_act_when_closed(machine.state.heap.get(option.address)):
            _close_later(machine, option)


def watch_raising(machine: Interpreter, source: Value, raised: int) -> None:
    """Behind a loop that an exception may have left: `raised` says how many there were before it."""
    states = [snapshot.state for catcher in machine.catchers[-1:] for snapshot in catcher.arrivals.values()]
    states += [catcher.snapshot.state for catcher in machine.catchers[-1:] if catcher.level]
    if machine.raised != raised and machine.ends is not None:
        states.append(machine.ends)
    if isinstance(source, Ref) and any(may_act_when_closed(s.heap.get(source.address)) for s in states):
        _close_later(machine, source)


def _close_later(machine: Interpreter, ref: Ref) -> None:
    machine.schedule(Partial(Native("generator.close"), (ref,), ()), (), "end of a generator")
