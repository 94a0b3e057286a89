# SPDX-License-Identifier: Apache-2.0
"""`except*`: each handler gets a group of the exceptions of its class; what is left goes on.

try:                raise ExceptionGroup('both', [ValueError('a'), TypeError('b')])
except* ValueError as group:     group.exceptions is (ValueError('a'),); afterwards a group with the TypeError goes outward
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Ref, Value
from rosward.engine.catcher import Catcher, throw
from rosward.engine.frame import Frame, Snapshot, join_into
from rosward.ir import ops
from rosward.models.exception_groups import split, wrapped

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter


def handle_groups(
    machine: Interpreter, op: ops.Try, frame: Frame, catcher: Catcher, after: Snapshot | None
) -> Snapshot | None:
    """Run the handlers of a `try` with `except*`; where control goes on, joined with `after`."""
    if machine.catchers and catcher.level:
        machine.catchers[-1].take_over(machine, catcher)
    frame.uncertain += 1
    for exception, snapshot in catcher.arrivals.items():
        machine.resume(frame, Snapshot(snapshot.registers.copy(), snapshot.state.copy()))
        alive, left = _handle(machine, op, frame, exception)
        if alive and left is not None:
            throw(machine, left)
        if alive and (left is None or left.__class__ is not Ref):
            after = join_into(machine, after, machine.snapshot(frame))
    if catcher.level:
        for handler in op.handlers:
            machine.resume(frame, Snapshot(catcher.snapshot.registers.copy(), catcher.snapshot.state.copy()))
            if _run(machine, handler, frame, machine.unknown(Cause.LIVE, "exception group"), catcher.level):
                after = join_into(machine, after, Snapshot(frame.registers, machine.state))
    frame.uncertain -= 1
    return after


def _handle(machine: Interpreter, op: ops.Try, frame: Frame, exception: Value) -> tuple[bool, Value | None]:
    """Run each handler on its part of one exception, one behind the other; whether control goes on, and what is left of it."""
    left: Value | None = exception
    for handler in op.handlers:
        if left is None:
            break
        if not machine.run(handler.match, frame):
            return False, None
        wanted = frame.registers[handler.type]
        if left.__class__ is not Ref:
            before = machine.snapshot(frame)
            alive = _run(machine, handler, frame, machine.unknown(Cause.LIVE, "exception group"), 0)
            machine.resume(frame, join_into(machine, before, machine.snapshot(frame)) if alive else before)
            continue
        parts = split(machine, left, wanted)
        if parts.matching is not None:
            before = machine.snapshot(frame)
            alive = _run(machine, handler, frame, wrapped(machine, parts.matching), 0)
            if not parts.sure:
                machine.resume(frame, join_into(machine, before, machine.snapshot(frame)) if alive else before)
            elif not alive:
                return False, None
        left = parts.rest
    return True, left


def _run(machine: Interpreter, handler: ops.Handler, frame: Frame, group: Value, level: int) -> bool:
    """One handler; what it raises leaves in a group."""
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
    here = machine.snapshot(frame)
    for exception, snapshot in catcher.arrivals.items():
        machine.resume(frame, snapshot)
        throw(machine, wrapped(machine, exception))
    machine.resume(frame, here)
    return alive
