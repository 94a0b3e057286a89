# SPDX-License-Identifier: Apache-2.0
"""`with`: `__enter__`, the body, `__exit__` on each way out, which learns of the exception and may swallow it.

with Quiet():            __exit__ is called with the class and the object that was raised, in the state in which it was
    raise Refused('x')   what it returns says whether the way behind the `with` is open
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.state import State, join_states
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.engine.python.exceptions import APART, Rest, leave_unseen
from rosward.engine.python.raised import class_of
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.frame import Exits, Frame, Snapshot, join_into
from rosward.engine.throwing import throw, unseen
from rosward.ir import ops
from rosward.models.python.plain import FILE_HINT

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_NOTHING: Final = (NONE, NONE, NONE)
_NAMES: Final = (("__enter__", "__exit__"), ("__aenter__", "__aexit__"))


def with_context(machine: Engine, op: ops.With, frame: Frame, *, body: Rest | None = None) -> bool | None:
    """The statement, with one item. `body`: what is left of it; then it was entered before."""
    frame.op, frame.sequence = op, 0
    context = frame.registers[op.context]
    if body is None and not _enter(machine, op, frame, context):
        return False
    outer, catchers = frame.exits, machine.catchers
    inner = frame.exits = Exits(outer)
    catcher = Catcher(machine, frame, classes=_swallowed(machine, context))
    machine.catchers = [*catchers, catcher]
    try:
        alive = machine.run(op.body, frame) if body is None else body()
    finally:
        frame.exits = outer
        machine.catchers = catchers
    after = Snapshot(frame.registers, machine.state) if alive else None
    after = _leave(machine, op, frame, context, inner, after)
    after = _leave_raising(machine, op, frame, context, catcher, after)
    if after is None:
        return False
    machine.resume(frame, after)
    return None


def _enter(machine: Engine, op: ops.With, frame: Frame, context: Value) -> bool:
    """Run `__enter__`, and bind what it gives."""
    entered = context if _is_file(context) else machine.call_method(context, _NAMES[op.is_async][0], ())
    entered = machine.wait_for(entered) if op.is_async and entered is not UNBOUND else entered
    if op.bind != ops.NO_REGISTER and entered is not UNBOUND:
        frame.registers[op.bind] = entered
    return entered is not UNBOUND


def _swallowed(machine: Engine, context: Value) -> tuple[str, ...]:
    """The builtin exceptions that may be swallowed: those that `contextlib.suppress` is told to, any by a class of the program."""
    if context.__class__ is not Ref:
        return ()
    obj = machine.obj(context)
    if obj.cls.__class__ is not Class:
        return ()
    if obj.cls.name != "suppress" or not obj.cls.stub:
        asks = not obj.cls.stub or obj.cls.name.endswith(("ContextManager", "ExitStack"))
        return ("BaseException",) if asks else ()
    named = obj.attrs.get("_exceptions")
    items = named.items if named.__class__ is Tuple else ()
    return tuple(i.name.removeprefix("builtins.") for i in items if i.__class__ is Native)


def _exit(machine: Engine, op: ops.With, frame: Frame, context: Value, arguments: Sequence[Value]) -> Value:
    """What `__exit__` gives."""
    frame.op, frame.sequence = op, 0
    if _is_file(context):
        return NONE
    answer = machine.call_method(context, _NAMES[op.is_async][1], tuple(arguments))
    return machine.wait_for(answer) if op.is_async and answer is not UNBOUND else answer


def _leave(
    machine: Engine, op: ops.With, frame: Frame, context: Value, inner: Exits, after: Snapshot | None
) -> Snapshot | None:
    """Leave without an exception: at the end of the body, by break, continue and return."""
    outer = frame.exits
    if after is not None:
        machine.resume(frame, after)
        alive = _exit(machine, op, frame, context, _NOTHING) is not UNBOUND
        after = Snapshot(frame.registers, machine.state) if alive else None
    for way in ("broken", "continued", "returned"):
        snapshot: Snapshot | None = getattr(inner, way)
        if snapshot is None:
            continue
        machine.resume(frame, snapshot)
        if _exit(machine, op, frame, context, _NOTHING) is not UNBOUND:
            setattr(outer, way, join_into(machine, getattr(outer, way), Snapshot(frame.registers, machine.state)))
            if way == "returned":
                outer.value = join(outer.value, inner.value)
    return after


def _leave_raising(
    machine: Engine, op: ops.With, frame: Frame, context: Value, catcher: Catcher, after: Snapshot | None
) -> Snapshot | None:
    """Leave by exceptions: `__exit__` may swallow them, and then the way behind the `with` is open."""
    for exception, snapshot in catcher.few(machine, APART).items():
        machine.resume(frame, snapshot)
        with machine.handles(exception, 0):
            answer = _exit(machine, op, frame, context, exit_arguments(machine, exception))
        if answer is UNBOUND:
            continue
        swallows = machine.truth(answer)
        if swallows is not False:
            _note(machine, context)
            after = join_into(machine, after, machine.snapshot(frame))
        if swallows is not True:
            throw(machine, exception)
    if not catcher.level:
        return after
    machine.resume(frame, catcher.snapshot)
    exception = unseen(machine)
    with machine.handles(UNBOUND, catcher.level):
        answer = _exit(machine, op, frame, context, exit_arguments(machine, exception))
    if answer is UNBOUND:
        return after
    swallows = machine.truth(answer)
    if swallows is not False:
        _note(machine, context)
        # What Python may raise anywhere makes nothing conditional by the mere chance that something unknown swallows it.
        done = after.state.done if after is not None and _unknown(context) else None
        after = join_into(machine, after, machine.snapshot(frame))
        if done is not None:
            after.state.done = done
    if swallows is not True:
        leave_unseen(machine, Snapshot(frame.registers, machine.state), catcher.level, importing=catcher.importing)
    return after


def _note(machine: Engine, context: Value) -> None:
    """An exception may be swallowed, and not by the mere chance that something unknown does."""
    if machine.watch is not None and not _unknown(context):
        machine.watch.swallows(machine)


def _is_file(context: Value) -> bool:
    """Whether a value is a file of which nothing else is known: it swallows nothing."""
    return context.__class__ is Unknown and context.hint == FILE_HINT


def _unknown(context: Value) -> bool:
    return any(o.__class__ in (Unknown, External) for o in options(context))


def exit_arguments(machine: Engine, exception: Value) -> tuple[Value, Value, Value]:
    """What `__exit__` is called with."""
    return (class_of(machine, exception), exception, machine.unknown(Cause.LIVE, "traceback"))


def unwind(machine: Engine, exits: Sequence[Value], exception: Value) -> Value:
    """Call the exits of a stack, the last first, as nested `with` statements would.

    Each is a pair (callable, whether its result is awaited), or one of several; None where there may be none. True where they swallow the
    exception, False where it goes on.
    """
    states: dict[Value, State] = {exception: machine.state}
    for one_of in reversed(exits):
        found: dict[Value, State] = {}
        for each, state in states.items():
            for pair in options(one_of):
                machine.state = state.copy()
                for key, value in _one_exit(machine, pair, each) if pair != NONE else [(each, machine.state)]:
                    known = found.get(key)
                    found[key] = value if known is None else join_states(known, value, machine.fresh_version)
        states = found
    answers: Value = UNBOUND
    after: State | None = None
    for each, state in states.items():
        if each not in (NONE, exception):
            machine.state = state
            throw(machine, each)
            continue
        answers = join(answers, Const(each == NONE and exception != NONE))
        after = state if after is None else join_states(after, state, machine.fresh_version)
    if after is not None:
        machine.state = after
    return answers


def _one_exit(machine: Engine, pair: Value, exception: Value) -> list[tuple[Value, State]]:
    """The exceptions (None: no one) that are on their way behind one exit, each with its state."""
    exit_, awaited = pair.items if pair.__class__ is Tuple and len(pair.items) == 2 else (pair, NONE)
    catchers = machine.catchers
    catcher = Catcher(machine, machine.frames[-1])
    machine.catchers = [*catchers, catcher]
    try:
        with machine.handles(exception, 0):
            answer = machine.call(exit_, _NOTHING if exception == NONE else exit_arguments(machine, exception))
            if awaited == Const(True) and answer is not UNBOUND:
                answer = machine.wait_for(answer)
    finally:
        machine.catchers = catchers
    if catcher.level and machine.catchers:
        machine.catchers[-1].take_over(machine, catcher)
    found = [(raised, snapshot.state) for raised, snapshot in catcher.arrivals.items()]
    if answer is UNBOUND:
        return found
    if exception == NONE:
        return [*found, (NONE, machine.state)]
    swallows = machine.truth(answer)
    if swallows is not False:
        found.append((NONE, machine.state.copy()))
    if swallows is not True:
        found.append((exception, machine.state))
    return found
