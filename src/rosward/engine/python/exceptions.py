# SPDX-License-Identifier: Apache-2.0
"""`raise`, `try`, `except`, `finally`.

try:    self.t = read()         any operation that may fail: the handler starts from the join of the states around each of them
        raise Refused('x')      the handler starts from the state here, and `error.args` is ('x',)
except Refused as error: …
"""

from __future__ import annotations

import builtins
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.values import UNBOUND, Class, Unknown, Value
from rosward.engine.python.groups import handle_groups
from rosward.engine.python.raised import chain, made, may_catch
from rosward.engine.running.catcher import ANYTHING, LIBRARY, Catcher, join_snapshots
from rosward.engine.running.frame import Exits, Frame, Snapshot, join_into
from rosward.engine.throwing import note, throw, unseen
from rosward.ir import ops
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

APART: Final = 4
"""For how many exceptions a `finally` or an `__exit__` runs apart."""


def raise_(machine: Engine, op: ops.Raise, frame: Frame) -> bool:
    """The raise statement."""
    frame.op, frame.sequence = op, 0
    if op.src == ops.NO_REGISTER:
        again(machine)
        return False
    exception = made(machine, frame.registers[op.src])
    if exception is not UNBOUND:
        chain(machine, exception, frame.registers[op.cause] if op.cause != ops.NO_REGISTER else None)
        throw(machine, exception)
    return False


def again(machine: Engine) -> None:
    """A bare `raise`: what is being handled goes on. What Python itself may have raised does not count as an end of the program."""
    handled, implicit = machine.handling[-1] if machine.handling else (UNBOUND, 0)
    if handled is not UNBOUND:
        throw(machine, handled)
    if implicit or handled is UNBOUND:
        machine.raised += 1
        leave_unseen(machine, Snapshot([], machine.state), max(implicit, 1))


def leave_unseen(machine: Engine, snapshot: Snapshot, level: int, *, importing: bool = False) -> None:
    """An exception that is not known leaves in a state: the `try` around may get it."""
    if machine.catchers:
        machine.state = snapshot.state
        note(machine, level)
        machine.catchers[-1].importing |= importing


def thrown_in(machine: Engine, exception: Value) -> None:
    """An exception is thrown into a generator: one that is not known is what Python itself may have raised where it is handled."""
    if exception.__class__ is Unknown:
        level = machine.handling[-1][1] if machine.handling else 0
        leave_unseen(machine, Snapshot([], machine.state), max(level, 1))
    else:
        throw(machine, exception)


Rest = Callable[[], bool]
"""What is left of a block in which a generator was suspended."""


def attempt(
    machine: Engine, op: ops.Try, frame: Frame, *, body: Rest | None = None, handled: Rest | None = None
) -> bool | None:
    """try / except / else / finally. `body`: what is left of the body; `handled`: what is left of a handler or of `else`."""
    if handled is None:

        def handled() -> bool:
            return _handled(machine, op, frame, body) is not False

    if not op.final:
        return handled() or False
    outer, catchers = frame.exits, machine.catchers
    inner = frame.exits = Exits(outer)
    catcher = Catcher(machine, frame)
    machine.catchers = [*catchers, catcher]
    try:
        alive = handled()
    finally:
        frame.exits = outer
        machine.catchers = catchers
    return _finally(machine, op.final, frame, inner, catcher, alive)


def _finally(
    machine: Engine, block: ops.Block, frame: Frame, inner: Exits, catcher: Catcher, alive: bool
) -> bool | None:
    """Run `block` on each way out of the statement, and let each go on where it went."""
    outer = frame.exits
    after: Snapshot | None = None
    if alive and machine.run(block, frame):
        after = Snapshot(frame.registers, machine.state)
    for way in ("broken", "continued", "returned"):
        snapshot: Snapshot | None = getattr(inner, way)
        if snapshot is None:
            continue
        machine.resume(frame, snapshot)
        if machine.run(block, frame):
            setattr(outer, way, join_into(machine, getattr(outer, way), Snapshot(frame.registers, machine.state)))
            if way == "returned":
                outer.value = join(outer.value, inner.value)
    for exception, snapshot in catcher.few(machine, APART).items():
        machine.resume(frame, snapshot)
        with machine.handles(exception, 0):
            alive = machine.run(block, frame)
        if alive:
            throw(machine, exception)
    if catcher.level:
        machine.resume(frame, Snapshot(catcher.snapshot.registers.copy(), catcher.snapshot.state.copy()))
        with machine.handles(UNBOUND, catcher.level):
            alive = machine.run(block, frame)
        if alive:
            leave_unseen(machine, Snapshot(frame.registers, machine.state), catcher.level, importing=catcher.importing)
    if after is None:
        return False
    machine.resume(frame, after)
    return None


class Pending(NamedTuple):
    """What no handler has surely caught so far: the exceptions that are known, and by what others may be raised, from where."""

    arrivals: dict[Value, Snapshot]
    level: int
    snapshot: Snapshot

    def entry(self, machine: Engine) -> Snapshot | None:
        """All states in which something is pending, joined."""
        return join_snapshots(machine, [*self.arrivals.values(), *((self.snapshot,) if self.level else ())])


def _handled(machine: Engine, op: ops.Try, frame: Frame, body: Rest | None) -> bool | None:
    """The body (or what is left of it) under its handlers, then the handlers, then `else`."""
    if not op.handlers:
        alive = machine.run(op.body, frame) if body is None else body()
        return (alive and machine.run(op.orelse, frame)) or False
    catcher = Catcher(machine, frame, handles=True, classes=tuple(n for h in op.handlers for n in _names(h)))
    catchers = machine.catchers
    machine.catchers = [*catchers, catcher]
    uncertain = frame.uncertain
    try:
        alive = machine.run(op.body, frame) if body is None else body()
    finally:
        machine.catchers = catchers
        frame.uncertain = uncertain
    alive = alive and machine.run(op.orelse, frame)
    after = Snapshot(frame.registers, machine.state) if alive else None
    if op.star:
        after = handle_groups(machine, op, frame, catcher, after)
    else:
        after = _run_handlers(machine, op, frame, catcher, after)
    if after is None:
        return False
    machine.resume(frame, after)
    return None


def _run_handlers(
    machine: Engine, op: ops.Try, frame: Frame, catcher: Catcher, after: Snapshot | None
) -> Snapshot | None:
    """Each handler that may catch, from the join of the states in which it does; the rest goes outward."""
    if machine.catchers and catcher.level and not any(_catches_all(h) for h in op.handlers):
        machine.catchers[-1].take_over(machine, catcher)
    pending = Pending(dict(catcher.arrivals), catcher.level, catcher.snapshot)
    frame.uncertain += 1
    for handler in op.handlers:
        interrupts = handler.type != ops.NO_REGISTER and _named(handler, _INTERRUPTS)
        if interrupts and not pending.level:
            pending = pending._replace(level=1)  # from outside, at any time
        entry = pending.entry(machine)
        if entry is None:
            break
        machine.resume(frame, entry)
        if not machine.run(handler.match, frame):
            break
        wanted = frame.registers[handler.type] if handler.type != ops.NO_REGISTER else None
        caught, left = _divide(machine, pending, wanted)
        level = pending.level if _may_be_unseen(machine, pending.level, catcher, wanted) else 0
        mine = Pending(caught, level, pending.snapshot)
        if len(caught) < len(pending.arrivals) or level != pending.level:
            entry = mine.entry(machine)
            if entry is not None:
                machine.resume(frame, entry)
                machine.run(handler.match, frame)
        if entry is not None:
            after = _run_handler(machine, handler, frame, mine, wanted, after)
        pending = pending._replace(arrivals=left, level=catcher.level)
    frame.uncertain -= 1
    for exception, snapshot in pending.arrivals.items():
        machine.resume(frame, Snapshot(snapshot.registers.copy(), snapshot.state.copy()))
        throw(machine, exception)
    return after


def _divide(
    machine: Engine, pending: Pending, wanted: Value | None
) -> tuple[dict[Value, Snapshot], dict[Value, Snapshot]]:
    """The exceptions that a handler may catch, and those that it may not."""
    caught: dict[Value, Snapshot] = {}
    left: dict[Value, Snapshot] = {}
    for exception, snapshot in pending.arrivals.items():
        answer = may_catch(machine, exception, wanted)
        if answer is not False:
            caught[exception] = snapshot
        if answer is not True:
            left[exception] = snapshot
    return caught, left


def _run_handler(
    machine: Engine,
    handler: ops.Handler,
    frame: Frame,
    mine: Pending,
    wanted: Value | None,
    after: Snapshot | None,
) -> Snapshot | None:
    """The body of a handler, and behind it the join with all other ways."""
    known = join_all(mine.arrivals) if mine.arrivals else UNBOUND
    if handler.bind != ops.NO_REGISTER:
        others = [unseen(machine)] if mine.level else []
        frame.registers[handler.bind] = join_all([*mine.arrivals, *others])
    with machine.handles(known, mine.level):
        alive = machine.run(handler.body, frame)
    if not alive:
        return after
    # An interrupt ends any program anywhere: it makes nothing conditional.
    done = after.state.done if after is not None and not mine.arrivals and _interrupts(wanted) else None
    after = join_into(machine, after, Snapshot(frame.registers, machine.state))
    if done is not None:
        after.state.done = done
    return after


def _may_be_unseen(machine: Engine, level: int, catcher: Catcher, wanted: Value | None) -> bool:
    """Whether an exception that is not known may be one for this handler."""
    if not level:
        return False
    if wanted is None or wanted.__class__ is Native:
        if _imports(wanted):
            return catcher.importing
        return level >= LIBRARY or wanted != _EXIT
    if wanted.__class__ is Tuple:
        return any(_may_be_unseen(machine, level, catcher, w) for w in wanted.items)
    if wanted.__class__ is Class:
        if any(b.__class__ is not Class and b.__class__ is not Native for b in wanted.mro) or wanted.stub:
            return level >= LIBRARY or _interrupts(wanted)
        return level >= ANYTHING
    return level >= LIBRARY or wanted.__class__ is not External or _interrupts(wanted)


def _catches_all(handler: ops.Handler) -> bool:
    """A bare `except`, or one of Exception or BaseException."""
    return handler.type == ops.NO_REGISTER or _named(handler, _EVERYTHING)


_EVERYTHING: Final = frozenset(("Exception", "BaseException"))
_INTERRUPTS: Final = frozenset(("KeyboardInterrupt", "ExternalShutdownException"))
_ENDS: Final = _INTERRUPTS | {"SystemExit"}
_EXIT: Final = Native("builtins.SystemExit")
_IMPORT_ERRORS: Final = (Native("builtins.ImportError"), Native("builtins.ModuleNotFoundError"))


def _named(handler: ops.Handler, names: frozenset[str]) -> bool:
    """Whether a handler names one of these classes."""
    return any(isinstance(op, (ops.LoadGlobal, ops.LoadAttr)) and op.name in names for op in handler.match)


def _names(handler: ops.Handler) -> list[str]:
    """The builtin exceptions that a handler surely catches."""
    if handler.type == ops.NO_REGISTER:
        return ["BaseException"]
    names = [op.name for op in handler.match if isinstance(op, ops.LoadGlobal)]
    return [n for n in names if isinstance(getattr(builtins, n, None), type)]


def _imports(wanted: Value | None) -> bool:
    """Whether a handler is there only for an import that fails."""
    return wanted in _IMPORT_ERRORS


def _interrupts(wanted: Value | None) -> bool:
    """Whether a handler is there only for the end of the program from outside."""
    if isinstance(wanted, Tuple):
        return all(_interrupts(w) for w in wanted.items)
    return isinstance(wanted, (Native, External, Class)) and wanted.name.rpartition(".")[2] in _ENDS
