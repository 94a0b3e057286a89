# SPDX-License-Identifier: Apache-2.0
"""Exceptions, `finally` and `with`.

try:    self.t = read()      any operation of the body may fail: the handler starts from the join of the states around each of them
except: self.t = 'a'         afterwards self.t is what read() gave, or 'a'
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, External, Native, Tuple, Unknown, Value
from rosward.engine.catcher import Catcher, note, throw
from rosward.engine.classes import is_subclass, type_of
from rosward.engine.frame import Exits, Frame, Snapshot, join_into
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter


def raise_(machine: Interpreter, op: ops.Raise, frame: Frame) -> bool:
    """The raise statement."""
    frame.line, frame.column, frame.sequence = op.line, op.column, 0
    exception = frame.registers[op.src] if op.src != ops.NO_REGISTER else machine.unknown(Cause.CALL, "exception")
    throw(machine, exception)
    return False


def may_catch(machine: Interpreter, exception: Value, wanted: Value | None) -> bool | None:
    """Whether a handler for `wanted` catches; None where it may."""
    if wanted is None:
        return True
    answers: set[bool | None] = set()
    for each in options(exception):
        cls = each if each.__class__ is Native else type_of(machine, each)
        answers.add(None if cls is None else is_subclass(machine, cls, wanted))
    return answers.pop() if len(answers) == 1 else None


def attempt(machine: Interpreter, op: ops.Try, frame: Frame) -> bool | None:
    """try / except / else / finally."""
    if not op.final:
        return _handled(machine, op, frame)
    outer, catchers = frame.exits, machine.catchers
    inner = frame.exits = Exits(outer)
    catcher = Catcher(machine, frame)
    machine.catchers = [*catchers, catcher]
    try:
        alive = _handled(machine, op, frame) is not False
    finally:
        frame.exits = outer
        machine.catchers = catchers
    return _finally(machine, op.final, frame, inner, catcher, alive)


def _finally(
    machine: Interpreter, block: ops.Block, frame: Frame, inner: Exits, catcher: Catcher, alive: bool
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
    if catcher.raised is not UNBOUND:
        machine.resume(frame, catcher.snapshot)
        if machine.run(block, frame):
            throw(machine, catcher.raised)
    elif catcher.reached:
        machine.resume(frame, Snapshot(catcher.snapshot.registers.copy(), catcher.snapshot.state.copy()))
        machine.run(block, frame)  # an implicit exception leaves
        note(machine)
    if after is None:
        return False
    machine.resume(frame, after)
    return None


def _handled(machine: Interpreter, op: ops.Try, frame: Frame) -> bool | None:
    """The body under its handlers, then the handlers, then `else`."""
    if not op.handlers:
        return (machine.run(op.body, frame) and machine.run(op.orelse, frame)) or False
    catcher = Catcher(machine, frame, handles=True)
    catchers = machine.catchers
    machine.catchers = [*catchers, catcher]
    uncertain = frame.uncertain
    try:
        alive = machine.run(op.body, frame)
    finally:
        machine.catchers = catchers
        frame.uncertain = uncertain
    alive = alive and machine.run(op.orelse, frame)
    after = Snapshot(frame.registers, machine.state) if alive else None
    if not catcher.reached:
        if after is None:
            return False
        machine.resume(frame, after)
        return None
    raised = catcher.raised
    if machine.catchers and not any(_catches_all(h) for h in op.handlers):
        machine.catchers[-1].take_over(machine, catcher)
    frame.uncertain += 1
    for handler in op.handlers:
        machine.resume(frame, Snapshot(catcher.snapshot.registers.copy(), catcher.snapshot.state.copy()))
        machine.run(handler.match, frame)
        wanted = frame.registers[handler.type] if handler.type != ops.NO_REGISTER else None
        if raised is UNBOUND and not catcher.importing and _imports(wanted):
            continue  # every import of the body is one that cannot fail
        if handler.bind != ops.NO_REGISTER:
            frame.registers[handler.bind] = _bound(machine, raised, wanted)
        if machine.run(handler.body, frame):
            done = after.state.done if after is not None and _interrupts(wanted) else None
            after = join_into(machine, after, Snapshot(frame.registers, machine.state))
            if done is not None:
                after.state.done = done  # an interrupt ends any program anywhere: it makes nothing conditional
        left = [e for e in options(raised) if raised is not UNBOUND and may_catch(machine, e, wanted) is not True]
        raised = join_all(left) if left else UNBOUND
    frame.uncertain -= 1
    if raised is not UNBOUND:
        machine.resume(frame, catcher.snapshot)
        throw(machine, raised)
    if after is None:
        return False
    machine.resume(frame, after)
    return None


def _catches_all(handler: ops.Handler) -> bool:
    """A bare `except`, or one of Exception or BaseException."""
    if handler.type == ops.NO_REGISTER:
        return True
    return any(isinstance(op, ops.LoadGlobal) and op.name in ("Exception", "BaseException") for op in handler.match)


_IMPORT_ERRORS: Final = (Native("builtins.ImportError"), Native("builtins.ModuleNotFoundError"))


def _imports(wanted: Value | None) -> bool:
    """Whether a handler is there only for an import that fails."""
    if isinstance(wanted, Tuple):
        return bool(wanted.items) and all(_imports(w) for w in wanted.items)
    return wanted in _IMPORT_ERRORS


_INTERRUPTS: Final = frozenset(("KeyboardInterrupt", "SystemExit", "ExternalShutdownException"))


def _interrupts(wanted: Value | None) -> bool:
    """Whether a handler is there only for the end of the program from outside."""
    if isinstance(wanted, Tuple):
        return all(_interrupts(w) for w in wanted.items)
    return isinstance(wanted, (Native, External, Class)) and wanted.name.rpartition(".")[2] in _INTERRUPTS


def _bound(machine: Interpreter, raised: Value, wanted: Value | None) -> Value:
    """What `except … as e` binds."""
    instances = [
        e
        for e in options(raised)
        if e.__class__ is not Native and e is not UNBOUND and may_catch(machine, e, wanted) is not False
    ]
    return join_all([*instances, machine.unknown(Cause.LIVE, "exception")])


def with_context(machine: Interpreter, op: ops.With, frame: Frame) -> bool | None:
    """`with`: __enter__, the body, __exit__ on each way out."""
    frame.line, frame.column, frame.sequence = op.line, op.column, 0
    context = frame.registers[op.context]
    prefix = "__a" if op.is_async else "__"
    entered = machine.call_method(context, f"{prefix}enter__", ())
    entered = machine.wait_for(entered) if op.is_async else entered
    if entered is UNBOUND:
        return False
    if op.bind != ops.NO_REGISTER:
        frame.registers[op.bind] = entered
    outer, catchers = frame.exits, machine.catchers
    inner = frame.exits = Exits(outer)
    catcher = Catcher(machine, frame)
    machine.catchers = [*catchers, catcher]
    try:
        alive = machine.run(op.body, frame)
    finally:
        frame.exits = outer
        machine.catchers = catchers

    def leave(snapshot: Snapshot) -> Value:
        machine.resume(frame, snapshot)
        return machine.call_method(context, f"{prefix}exit__", (NONE, NONE, NONE))

    after: Snapshot | None = None
    if alive and leave(Snapshot(frame.registers, machine.state)) is not UNBOUND:
        after = Snapshot(frame.registers, machine.state)
    for way in ("broken", "continued", "returned"):
        snapshot: Snapshot | None = getattr(inner, way)
        if snapshot is not None and leave(snapshot) is not UNBOUND:
            setattr(outer, way, join_into(machine, getattr(outer, way), Snapshot(frame.registers, machine.state)))
            if way == "returned":
                outer.value = join(outer.value, inner.value)
    if catcher.reached:
        swallowed = leave(catcher.snapshot)
        swallows = swallowed.__class__ not in (Const, Unknown) or machine.truth(swallowed) is not False
        if swallows and swallowed.__class__ is not Unknown and swallowed is not UNBOUND:
            after = join_into(machine, after, Snapshot(frame.registers, machine.state.copy()))
        if machine.truth(swallowed) is not True:
            if catcher.raised is not UNBOUND:
                throw(machine, catcher.raised)
            elif machine.catchers:
                machine.catchers[-1].take_over(machine, catcher)
    if after is None:
        return False
    machine.resume(frame, after)
    return None
