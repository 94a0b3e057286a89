# SPDX-License-Identifier: Apache-2.0
"""Running the body of a function: its frame, its memo, and one summary for all calls of a recursion.

def walk(n): …; walk(n - 1)      four activations are followed, all deeper ones share a summary that is solved by iteration
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, widen
from rosward.domain.state import EventKey, State, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Function, Value
from rosward.engine import declared
from rosward.engine.budget import LimitReachedError
from rosward.engine.catcher import Catcher
from rosward.engine.declared import MODEL_PREFIX
from rosward.engine.frame import Frame
from rosward.engine.summaries import Summary
from rosward.engine.throwing import note, rethrow
from rosward.ir.ops import Block, ForEach, If, LoadAttr, Op, Try, While, With

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code

_LARGE: Final = 50


def invoke(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """Run a function body on bound registers; the value returned."""
    code = function.code
    depth = sum(1 for f in machine.frames if f.code is code)
    limit = machine.budget.recursion
    if machine.precision.coarse:
        recursive = code.key in machine.summaries.recursive
        if recursive or code.key not in machine.trace.creating:
            limit = 0 if recursive or _is_large(machine, function) else 1
    if depth:
        machine.summaries.recursive.add(code.key)
    if depth >= limit or len(machine.frames) >= machine.budget.depth:
        return _summarised(machine, function, registers)
    key = (function, tuple(registers), machine.state.version, bool(machine.catchers))
    remembered = machine.summaries.memo.get(key)
    if remembered is not None:
        value, level = remembered
        if level:
            note(machine, level)
        return value
    raised, version, provisional = machine.raised, machine.state.version, machine.summaries.provisional
    noted, machine.noted = machine.noted, 0
    value = run_body(machine, function, registers, machine.frames[-1] if machine.frames else None)
    level, machine.noted = machine.noted, max(machine.noted, noted)
    quiet = (
        machine.state.version == version and machine.raised == raised and machine.summaries.provisional == provisional
    )
    if quiet and value is not UNBOUND and not declared.is_model(function):
        machine.summaries.memo[key] = (value, level)
    return value


def _is_large(machine: Engine, function: Function) -> bool:
    """Whether running a body again costs more than asking for its summary. What a library says to be worth it is run each time."""
    code = function.code
    found = machine.summaries.large.get(code.key)
    if found is None:
        precise = machine.library.facts.precise
        kept = code.name == "__init__" or declared.is_model(function) or _calls(code.ops, precise)
        found = machine.summaries.large[code.key] = not kept and _weight(code.ops) > _LARGE
    return found


def _calls(block: Block, beginnings: tuple[str, ...]) -> bool:
    """Whether a block reads an attribute whose name begins so."""
    return any(
        (isinstance(op, LoadAttr) and op.name.startswith(beginnings))
        or any(_calls(inner, beginnings) for inner in _inner(op))
        for op in block
    )


def _inner(op: Op) -> tuple[Block, ...]:
    """The blocks in which an operation spends its time."""
    if isinstance(op, If):
        return (op.then, op.orelse)
    return (op.body,) if isinstance(op, (While, ForEach, Try, With)) else ()


def _weight(block: Block) -> int:
    """About how much there is to interpret in a block: loops go round several times."""
    loops = sum(1 for op in block if isinstance(op, (While, ForEach)))
    return len(block) + _LARGE * loops + sum(_weight(inner) for op in block for inner in _inner(op))


def run_body(
    machine: Engine, function: Function, registers: list[Value], caller: Frame | None, context: int | None = None
) -> Value:
    """Interpret a body in a frame of its own; the value returned."""
    code = function.code
    machine.trace.entered.add(code.key)
    machine.choosing = False
    if context is None:
        context = context_of(machine, code, caller)
    full = [*registers, *([UNBOUND] * (code.registers - len(registers)))]
    frame = Frame(code, full, (), function.module, context, declared.is_model(function))
    frame.cells = (*machine.new_cells(code, context), *function.cells)
    machine.frames.append(frame)
    machine.check_time()
    try:
        alive = machine.run(code.ops, frame)
    finally:
        machine.frames.pop()
    left = left_by(machine, frame, alive=alive)
    if left is None:
        return UNBOUND
    value, machine.state = left
    return value


def left_by(machine: Engine, frame: Frame, *, alive: bool) -> tuple[Value, State] | None:
    """What a body returned, and the state there; `alive`: control also came out at its end. None: it does not return."""
    exits = frame.exits
    if alive:
        exits.value = join(exits.value, NONE)
        state = machine.state
        if exits.returned is not None:
            state = join_states(exits.returned.state, state, machine.fresh_version)
        return exits.value, state
    return None if exits.returned is None else (exits.value, exits.returned.state)


def context_of(machine: Engine, code: Code, caller: Frame | None) -> int:
    """The context of a call: the chain of calls that led to it. What one operation calls (`map`, `sum`) is told apart by its turn.

    Where precision is given up, functions are contexts, but for those of libraries and those that create something: what these do for one
    caller is no other's business.
    """
    if machine.precision.coarse and not code.file.startswith(MODEL_PREFIX) and code.key not in machine.trace.creating:
        return machine.context("coarse", code.key)
    if caller is None:
        return 0
    return machine.context(caller.context, caller.code.key, caller.op.number, caller.next(), code.key)


def _summarised(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """A call too deep to follow: solved once for the join of all such calls, by iteration from below."""
    key = (function.code.key, function.cells)
    summary = machine.summaries.running.get(key)
    reason = Reason(Cause.LIMIT, f"recursion of {function.code.name}", machine.place)

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    if summary is not None:
        summary.registers = [widening(a, b) for a, b in zip(summary.registers, registers, strict=True)]
        summary.before = join_states(summary.before, machine.state.copy(), machine.fresh_version, widening)
        machine.summaries.provisional += 1  # what is computed from it now may not be its last word
        machine.asked_for |= summary.asked_for
        if summary.after is None:
            return UNBOUND
        machine.state = summary.after.copy()
        return summary.value
    if len(machine.frames) >= machine.budget.depth * 2:
        raise LimitReachedError(f"calls nested more than {machine.budget.depth} deep", machine.place)
    done, outer = machine.state.done, machine.catchers
    summary = machine.summaries.finished.pop(key, None) if machine.precision.coarse else None
    if summary is None:
        summary = Summary(list(registers), machine.state.copy())
    else:
        before = (list(summary.registers), summary.before.version)
        summary.registers = [widening(a, b) for a, b in zip(summary.registers, registers, strict=True)]
        summary.before = join_states(summary.before, machine.state.copy(), machine.fresh_version, widening)
        known = not summary.provisional or not machine.summaries.running or summary.turn == machine.summaries.turns
        if known and before == (summary.registers, summary.before.version):  # a call like those before
            machine.summaries.finished[key] = summary
            machine.summaries.provisional += summary.provisional and bool(machine.summaries.running)
            return _of_summary(machine, summary, done)
    outermost = not machine.summaries.running
    machine.summaries.running[key] = summary
    if machine.precision.coarse:
        summary.catcher = summary.catcher or Catcher(machine, machine.frames[-1])
        machine.catchers = [*outer, summary.catcher]
    context = machine.context("summary", function.code.key)
    asked_for, machine.asked_for = machine.asked_for, summary.asked_for
    try:
        for _ in range(machine.budget.fixpoint * 4):
            reads, seen, changes = machine.summaries.provisional, summary.versions, machine.summaries.changes
            machine.summaries.turns += outermost
            machine.state = summary.before.copy()
            value = run_body(machine, function, list(summary.registers), machine.frames[-1], context)
            if value is not UNBOUND:
                summary.value = widening(summary.value, value) if summary.value is not UNBOUND else value
                summary.after = (
                    machine.state.copy()
                    if summary.after is None
                    else join_states(summary.after, machine.state.copy(), machine.fresh_version, widening)
                )
            summary.provisional = machine.summaries.provisional != reads
            summary.turn = machine.summaries.turns
            if not summary.provisional:
                break  # nothing inside asked for an unfinished summary: this turn was exact
            machine.summaries.changes += seen != summary.versions
            if machine.summaries.changes == changes or (not outermost and machine.precision.coarse):
                break  # (of one inside another the turns are those of the outermost)
        else:
            machine.report("RW201", f"the recursion of {function.code.name} did not converge")
    finally:
        del machine.summaries.running[key]
        machine.catchers = outer
        machine.asked_for = asked_for
    if summary.catcher is not None:
        machine.summaries.finished[key] = summary
    return _of_summary(machine, summary, done)


def _of_summary(machine: Engine, summary: Summary, done: frozenset[EventKey]) -> Value:
    """What a call gives by its summary, where `done` had surely happened before it."""
    machine.asked_for |= summary.asked_for  # of the body, which may not have run for this call
    if summary.catcher is not None:
        rethrow(machine, summary.catcher)
    if summary.after is None:
        return UNBOUND
    machine.state = summary.after.copy()
    machine.state.done |= done
    return summary.value
