# SPDX-License-Identifier: Apache-2.0
"""Generators: made by a call, advanced from one `yield` to the next, each time from the state of who advances them.

self.script = self.steps()     nothing of it runs
next(self.script)              it runs to its first `yield`: consumer and generator see what the other wrote, in order

Where it is not known at which of several points a generator stands (a timer advances it, any number of times), it goes on from each of them, apart.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, widen
from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.state import Merge, State, join_states
from rosward.domain.suspended import Point, Suspension, add_points
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Function, Ref, Value
from rosward.engine.budget import LimitReachedError
from rosward.engine.calls import activation, bodies
from rosward.engine.python import resume, stepping
from rosward.engine.python.exceptions import thrown_in
from rosward.engine.python.raised import may_catch
from rosward.engine.python.recalled_steps import recalling
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.frame import Frame, Yielded
from rosward.engine.running.stepped import NEXT, Resumption, Running, Stepped
from rosward.engine.throwing import rethrow
from rosward.engine.unknown import declared
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_FEW: Final = 3
"""With more points than that, or where it may be at its beginning or end besides, nobody knows how often it was advanced (a timer may do it
any number of times): then all points that can be reached are found at once.
"""


def make(machine: Engine, function: Function, registers: list[Value]) -> Ref:
    """The object that a call of a generator function or coroutine gives."""
    code = function.code
    caller = machine.frames[-1] if machine.frames else None
    lineage = next((f.yielded.lineage for f in reversed(machine.frames) if f.yielded is not None), ())
    limit = 1 if machine.precision.coarse else machine.budget.recursion
    shared = activation.is_too_deep(machine, code, registers, lineage.count(code.key), limit)
    if shared:  # made inside one another without end: all of them are one
        context = machine.context("summary", code.key)
    else:
        lineage = (*lineage, code.key)
        context = bodies.context_of(machine, code, caller)
    points = {Point(function, context, (), ()): tuple(registers)}
    record = Obj("generator", NONE, payload=Suspension(points, lineage=lineage, shared=shared), many=shared)
    if shared:
        return Ref(machine.place_at(("generator", code.key, function.cells), record))
    return machine.allocate(record, (code.key, function.cells))


def advance(machine: Engine, ref: Ref, action: Resumption) -> Stepped:
    """Resume a generator; the machine is left in the state behind its next `yield`."""
    running = machine.advancing.get(ref.address)
    if running is not None:
        return _ask(machine, ref, running)
    suspension = machine.obj(ref).payload
    assert isinstance(suspension, Suspension)
    if not all(p.function.code.is_generator for p in suspension.points):
        return _run_coroutine(machine, suspension, action)
    if suspension.shared:
        around = next((r for r in machine.advancing.values() if r.shared), None)
        if around is not None:
            return _within(machine, ref, action, around)

    def follow() -> Stepped:
        running = machine.advancing[ref.address] = Running(machine.state.copy(), shared=suspension.shared)
        try:
            return _until_stable(machine, ref, action, running)
        finally:
            del machine.advancing[ref.address]
            machine.summaries.asked -= running.asks  # they are answered: what runs around may be remembered

    return recalling(machine, ref, suspension, action, follow)


def _ask(machine: Engine, ref: Ref, running: Running) -> Stepped:
    """A generator is advanced while it runs: it raises ValueError, or (where it stands for several) is another one, which gave this before."""
    if not machine.obj(ref).many:
        machine.throw(machine.call_native("builtins.ValueError", ()))
        return Stepped(UNBOUND)
    running.asked = True
    _count(machine, running)
    running.before = join_states(running.before, machine.state.copy(), machine.fresh_version, _widening(machine))
    return _so_far(machine, running)


def _count(machine: Engine, running: Running) -> None:
    """Something is made of what is not the last word of a generator, or of those within: it must not be remembered."""
    outermost = next(r for r in machine.advancing.values() if r.shared) if running.shared else running
    outermost.asks += 1  # where that has its last word, so have those within
    machine.summaries.asked += 1


def _so_far(machine: Engine, running: Running) -> Stepped:
    """What the steps of a generator gave so far; the machine is left in the state behind."""
    item, ended, value = running.stepped
    if running.state is not None:
        machine.state = running.state.copy()
    return Stepped(item, None if ended is None else ended.copy(), value)


def _widening(machine: Engine) -> Merge:
    reason = Reason(Cause.LIMIT, "generators nested too deeply", machine.place)
    return lambda old, new: widen(old, new, reason)


def _merge(machine: Engine, turn: int) -> Merge:
    return join if turn < machine.budget.widen_after else _widening(machine)


def _until_stable(machine: Engine, ref: Ref, action: Resumption, running: Running) -> Stepped:
    """One step. Of generators that are nested too deep to be told apart it may ask for itself: solved by iteration from below."""
    for number in range(machine.budget.fixpoint * 2):
        seen, running.turn, running.asked, running.unsettled = running.versions, number, False, False
        stepped, before = _once(machine, ref, action), running.stepped
        if not running.asked and not running.unsettled and before.item is UNBOUND and before.ended is None:
            return stepped
        _take_in(machine, running, stepped, _merge(machine, number))
        if not running.unsettled and (not running.asked or seen == running.versions):
            break
        machine.state = running.before.copy()
    else:
        machine.report("RW201", "nested generators did not converge; what they do may be missing")
    return _so_far(machine, running)


def _within(machine: Engine, ref: Ref, action: Resumption, around: Running) -> Stepped:
    """One step of a generator inside of another one, of which both are nested too deep to be told apart.

    In each turn of the outermost it runs once, and again where it is asked from another state: that one has turns until nothing changes.
    """
    _count(machine, around)
    state, merge = machine.state.copy(), _merge(machine, around.turn)
    running = around.within.get((ref.address, action))
    if running is None:
        running = around.within[ref.address, action] = Running(state, shared=True)
    else:
        known = running.before.version
        running.before = join_states(running.before, state, machine.fresh_version, merge)
        if running.turn == around.turn and running.before.version == known:
            return _so_far(machine, running)
    seen, running.turn = running.versions, around.turn
    machine.advancing[ref.address] = running
    machine.state = running.before.copy()
    try:
        _take_in(machine, running, _once(machine, ref, action), merge)
    finally:
        del machine.advancing[ref.address]
    around.unsettled = around.unsettled or seen != running.versions
    return _so_far(machine, running)


def _take_in(machine: Engine, running: Running, stepped: Stepped, merge: Merge) -> None:
    """One more turn, which left the machine in the state behind its item."""
    item, ended, value = stepped
    before = running.stepped
    if item is not UNBOUND:
        state, old = machine.state.copy(), running.state
        running.state = state if old is None else join_states(old, state, machine.fresh_version, merge)
    if ended is not None and before.ended is not None:
        ended = join_states(before.ended, ended, machine.fresh_version, merge)
    running.stepped = Stepped(
        item if before.item is UNBOUND else before.item if item is UNBOUND else merge(before.item, item),
        before.ended if ended is None else ended,
        value if before.value is UNBOUND else merge(before.value, value),
    )


def _once(machine: Engine, ref: Ref, action: Resumption) -> Stepped:
    """Go on from each point, from the same state; what comes out is joined."""
    record = machine.obj(ref)
    suspension = record.payload
    assert isinstance(suspension, Suspension)
    over = suspension.at({}, ended=True)
    if not suspension.points:  # it is at its end
        if action.kind != "throw":
            return Stepped(UNBOUND, machine.state)
        thrown_in(machine, action.value)
        return Stepped(UNBOUND)
    if not record.many:  # unless it comes to a `yield`: whatever it raises, it is at its end then
        machine.update(ref, _with(machine, ref, over))
    before = machine.state
    several = len(suspension.points) + suspension.ended > 1
    started = any(not p.path for p in suspension.points)
    at_random = several and (suspension.ended or started or len(suspension.points) > _FEW)
    function = next(iter(suspension.points)).function
    result = Yielded(function, suspension.lineage, shared=suspension.shared)
    ended: State | None = None
    value: Value = UNBOUND
    if suspension.ended:
        ended, value = before.copy() if several else before, NONE
        if action.kind == "throw":  # it comes out again
            machine.state = ended
            thrown_in(machine, action.value)
            ended = None
    waiting = list(suspension.points.items())
    done: set[Point] = set()
    while waiting:
        point, values = waiting.pop()
        done.add(point)
        machine.state = before.copy() if several else before
        left = _run_from(machine, point, values, action, result, uncertain=several)
        if left is not None:
            value = join(value, left[0])
            ended = left[1] if ended is None else join_states(ended, left[1], machine.fresh_version)
        if at_random and result.state is not None:
            before = join_states(before, result.state.copy(), machine.fresh_version)
            waiting = [(p, v) for p, v in result.points.items() if p not in done and p not in suspension.points]
            waiting += [(p, v) for p, v in suspension.points.items() if p not in done]
    if machine.catchers:  # any operation in it may have failed: then it is at its end
        machine.catchers[-1].wrote(machine, ref.address, _with(machine, ref, over), machine.catchers[-1].version)
    if ended is not None:
        machine.state = ended
        machine.update(ref, _with(machine, ref, over))
        ended = machine.state
    if result.state is not None:
        machine.state = result.state
        machine.update(ref, _with(machine, ref, suspension.at(add_points({}, result.points), ended=False)))
    return Stepped(result.item, ended, value)


def _with(machine: Engine, ref: Ref, suspension: Suspension) -> Obj:
    return machine.obj(ref).replace(payload=suspension)


def _run_from(
    machine: Engine, point: Point, values: tuple[Value, ...], action: Resumption, result: Yielded, *, uncertain: bool
) -> tuple[Value, State] | None:
    """Run a body on from a point, to its next yields; the value that it returns, and the state there, where it comes to its end."""
    function, context, cells, path = point
    code = function.code
    if len(machine.frames) >= machine.budget.depth * 2:
        raise LimitReachedError(f"generators nested more than {machine.budget.depth} deep", machine.place)
    if not path and action.kind in ("throw", "close"):
        if action.kind == "throw":
            thrown_in(machine, action.value)
            return None
        return NONE, machine.state
    machine.trace.entered.add(code.key)
    machine.choosing = 0
    registers = list(values[: code.registers])
    registers += [UNBOUND] * (code.registers - len(registers))
    frame = Frame(code, registers, cells, function.module, context, declared.is_model(function))
    if not path:
        frame.cells = (*machine.new_cells(code, context), *function.cells)
    result.function, result.context = function, context
    frame.yielded = result
    frame.uncertain = int(uncertain)
    machine.frames.append(frame)
    machine.check_time()
    try:
        if path:
            alive = resume.go_on(machine, code.ops, frame, path, list(values[code.registers :]), action)
        else:
            alive = machine.run(code.ops, frame)
    finally:
        machine.frames.pop()
    return bodies.left_by(machine, frame, alive=alive)


def close(machine: Engine, ref: Ref) -> None:
    """`generator.close()`: GeneratorExit is raised where it stands, and goes no further. What is no generator has nothing to close."""
    if machine.obj(ref).kind != "generator":
        return
    frame = machine.frames[-1]
    outer, catcher = machine.catchers, Catcher(machine, frame)
    machine.catchers = [*outer, catcher]
    wanted = Native("builtins.GeneratorExit")
    try:
        item, ended, _ = advance(machine, ref, Resumption("close", machine.call(wanted, ())))
    finally:
        machine.catchers = outer
    if outer and catcher.level:
        outer[-1].take_over(machine, catcher)
    ends = [] if ended is None else [ended]
    if item is not UNBOUND:
        ends.append(machine.state)
    others = Catcher(machine, frame)
    for exception, snapshot in catcher.arrivals.items():
        caught = may_catch(machine, exception, wanted)
        if caught is not False:
            ends.append(snapshot.state)
        if caught is not True:
            others.arrive(machine, exception, snapshot.state)
    rethrow(machine, others)
    for number, end in enumerate(ends):
        machine.state = join_states(machine.state, end, machine.fresh_version) if number else end.copy()
    machine.update(ref, _with(machine, ref, _over(machine, ref)))


def _over(machine: Engine, ref: Ref) -> Suspension:
    suspension = machine.obj(ref).payload
    assert isinstance(suspension, Suspension)
    return suspension.at({}, ended=True)


def _run_coroutine(machine: Engine, suspension: Suspension, action: Resumption = NEXT) -> Stepped:
    """A coroutine runs to its end where it is awaited. It is not marked as done: a task that awaits it runs again, as callbacks do."""
    before = machine.state
    if action.kind == "close":
        return Stepped(UNBOUND, before)
    if action.kind in ("send", "throw"):
        machine.report("RW203", f"a coroutine that the program advances by {action.kind}() is run to its end at once")
    ended: State | None = None
    value: Value = UNBOUND
    for number, (point, registers) in enumerate(suspension.points.items()):
        machine.state = before.copy() if number + 1 < len(suspension.points) else before
        result = activation.invoke(machine, point.function, list(registers))
        if result is not UNBOUND:
            value = join(value, result)
            ended = machine.state if ended is None else join_states(ended, machine.state, machine.fresh_version)
    return Stepped(UNBOUND, ended, value)


def run_out(machine: Engine, ref: Ref) -> tuple[Items, Value]:
    """Advance a generator, or run a coroutine, to its end: what it yields, what it returns (UNBOUND: it never does)."""
    suspension = machine.obj(ref).payload
    assert isinstance(suspension, Suspension)
    if suspension.points and not any(p.function.code.is_generator for p in suspension.points):
        _, ended, value = _run_coroutine(machine, suspension)
        if ended is None:
            return Items(()), UNBOUND
        machine.state = ended
        return Items(()), value
    return stepping.drain(machine, ref)
