# SPDX-License-Identifier: Apache-2.0
"""`except*`: each handler gets a group of the exceptions of its class; what is left goes on.

try:                raise ExceptionGroup('both', [ValueError('a'), TypeError('b')])
except* ValueError as group:     group.exceptions is (ValueError('a'),); afterwards a group with the TypeError goes outward
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Ref, Value
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.frame import Frame, Snapshot, join_into
from rosward.engine.throwing import throw
from rosward.ir import ops
from rosward.models.python.exception_groups import Parts, made, split, wrapped
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_MOST: Final = 8


class _Way(NamedTuple):
    """One way through the handlers: where it stands, and what they have raised on it."""

    here: Snapshot
    raised: tuple[Value, ...] = ()


def handle_groups(
    machine: Engine, op: ops.Try, frame: Frame, catcher: Catcher, after: Snapshot | None
) -> Snapshot | None:
    """Run the handlers of a `try` with `except*`; where control goes on, joined with `after`."""
    if machine.catchers and catcher.level:
        machine.catchers[-1].take_over(machine, catcher)
    frame.uncertain += 1
    for exception, snapshot in catcher.arrivals.items():
        ways, left = _handle(machine, op, frame, exception, snapshot)
        for way in ways:
            machine.resume(frame, way.here)
            if way.raised:
                throw(machine, _of_all(machine, way.raised, left))
                continue
            if left is not None:
                throw(machine, left)
            if left is None or left.__class__ is not Ref:
                after = join_into(machine, after, machine.snapshot(frame))
    if catcher.level:
        for handler in op.handlers:
            machine.resume(frame, _copy(catcher.snapshot))
            for way in _run(machine, handler, frame, machine.unknown(Cause.LIVE, "exception group"), catcher.level):
                machine.resume(frame, way.here)
                if way.raised:
                    throw(machine, way.raised[0])
                else:
                    after = join_into(machine, after, Snapshot(frame.registers, machine.state))
    frame.uncertain -= 1
    return after


def _handle(
    machine: Engine, op: ops.Try, frame: Frame, exception: Value, begun: Snapshot
) -> tuple[list[_Way], Value | None]:
    """Run each handler on its part of one exception, also behind one that raises; and what is left of it."""
    left: Value | None = exception
    ways = [_Way(_copy(begun))]
    for handler in op.handlers:
        if left is None:
            break
        found: list[_Way] = []
        parts = Parts(None, left, sure=True)
        for way in ways:
            machine.resume(frame, way.here)
            if not machine.run(handler.match, frame):
                continue
            parts = _parts(machine, left, frame.registers[handler.type])  # the same in each, made in the state of each
            before = machine.snapshot(frame)
            if parts.matching is None or not parts.sure:
                found.append(way._replace(here=_copy(before)))
            if parts.matching is not None:
                run = _run(machine, handler, frame, wrapped(machine, parts.matching))
                found += [_Way(one.here, (*way.raised, *one.raised)) for one in run]
        left = parts.rest
        ways = found if len(found) <= _MOST else _joined(machine, found)
    return ways, left


def _parts(machine: Engine, exception: Value, wanted: Value) -> Parts:
    if exception.__class__ is Ref:
        return split(machine, exception, wanted)
    return Parts(machine.unknown(Cause.LIVE, "exception group"), exception, sure=False)


def _joined(machine: Engine, ways: list[_Way]) -> list[_Way]:
    """At most two ways for many: on the one nothing was raised, on the other something, nobody knows what."""
    quiet = loud = None
    for way in ways:
        if way.raised:
            loud = join_into(machine, loud, way.here)
        else:
            quiet = join_into(machine, quiet, way.here)
    unknown = machine.unknown(Cause.LIVE, "exception group")
    return [_Way(here, raised) for here, raised in ((quiet, ()), (loud, (unknown,))) if here is not None]


def _of_all(machine: Engine, raised: tuple[Value, ...], left: Value | None) -> Value:
    """What leaves the `try`: one exception that a handler raised as it is, else a group of all, and of what is left."""
    if len(raised) == 1 and left is None:
        return raised[0]
    exceptions = (*raised, *(() if left is None else (left,)))
    if any(each.__class__ is not Ref for each in exceptions):
        return machine.unknown(Cause.LIVE, "exception group")
    return made(machine, Native("builtins.ExceptionGroup"), Tuple(exceptions))


def _run(machine: Engine, handler: ops.Handler, frame: Frame, group: Value, level: int = 0) -> list[_Way]:
    """One handler, from here: how it comes to its end, and with what it is left."""
    if handler.bind != ops.NO_REGISTER:
        frame.registers[handler.bind] = group
    catchers = machine.catchers
    catcher = Catcher(machine, frame)
    machine.catchers = [*catchers, catcher]
    try:
        with machine.handles(group if not level else UNBOUND, level):
            alive = machine.run(handler.body, frame)
    finally:
        machine.catchers = catchers
    if machine.catchers and catcher.level:
        machine.catchers[-1].take_over(machine, catcher)
    ways = [_Way(machine.snapshot(frame))] if alive else []
    return ways + [_Way(_copy(snapshot), (exception,)) for exception, snapshot in catcher.arrivals.items()]


def _copy(snapshot: Snapshot) -> Snapshot:
    return Snapshot(snapshot.registers.copy(), snapshot.state.copy())
