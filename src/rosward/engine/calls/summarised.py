# SPDX-License-Identifier: Apache-2.0
"""One summary for all calls of a function: of a recursion that is too deep to follow, or of a large body where precision is given up.

def walk(n): …; walk(n - 1)      solved once for the join of all such calls, by iteration from below
layer.compute_caches()           run once for all callers between which nothing has changed of what it looks at

A call changes what the body changes, and nothing else of the state that it comes from; but for recursions, whose calls see each other's
states whole, and for what may end the program, where each state counts.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join, widen
from rosward.domain.state import State, join_objects, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import UNBOUND, Function, Value
from rosward.engine.budget import LimitReachedError
from rosward.engine.calls.bodies import run_body
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.summaries import Summary
from rosward.engine.throwing import rethrow

if TYPE_CHECKING:
    from rosward.domain.state import Merge
    from rosward.engine.machine import Engine


def summarised(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """What a call gives by the summary of its function."""
    summaries = machine.summaries
    key = (function.code.key, (function.cells, machine.language.instance(machine, function, registers)))
    if machine.watch is not None:
        machine.watch.summary(machine, function.code, machine.context("summary", function.code.key))
    running = summaries.running.get(key)
    reason = Reason(Cause.LIMIT, f"recursion of {function.code.name}", machine.place)

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    if running is not None:
        return _inside(machine, running, registers, widening)
    if len(machine.frames) >= machine.budget.depth * 2:
        raise LimitReachedError(f"calls nested more than {machine.budget.depth} deep", machine.place)
    called = machine.state
    summary = summaries.finished.pop(key, None) if machine.precision.coarse else None
    if summary is None:
        summary = Summary(list(registers), called.copy())
    else:
        known = not summary.provisional or not summaries.running or summary.turn == summaries.turns
        join_call = _join_whole if summary.whole else _take_in
        changed = join_call(machine, summary, registers, widening)
        if known and not changed:  # a call like those before
            summaries.finished[key] = summary
            if summary.provisional:
                summaries.provisional += bool(summaries.running)
                summaries.asked += 1
            else:
                summaries.used[key] = (summary, summary.edition)
            return _of_summary(machine, summary, called)
        if changed and not summary.whole:  # else what it gave is joined with what it gives, and comes to rest
            summary.value, summary.after, summary.catcher = UNBOUND, None, None
    outermost, open_ones = not summaries.running, (summaries.provisional, summaries.open)
    _solve(machine, summary, function, key, widening)
    if machine.precision.coarse:
        summaries.asked += 1  # there is another summary behind it than before
    elif outermost:  # all that was asked for within is answered: what runs around may be remembered
        summaries.provisional, summaries.open = open_ones
    if machine.precision.coarse:
        summaries.finished[key] = summary
    return _of_summary(machine, summary, called)


def _inside(machine: Engine, summary: Summary, registers: list[Value], merge: Merge) -> Value:
    """A call inside a recursion that is being solved: what is known of it so far."""
    _join_whole(machine, summary, registers, merge)
    machine.summaries.provisional += 1  # what is computed from it now may not be its last word
    machine.summaries.open += 1
    machine.asked_for |= summary.asked_for
    machine.summaries.wrote |= summary.wrote
    if len(machine.catchers) > summary.handlers:  # what is raised deeper inside reaches the `try` around this call
        summary.handled = True
        if summary.catcher is not None:
            rethrow(machine, summary.catcher)
    if summary.after is None:
        return UNBOUND
    machine.state = summary.after.copy()
    return summary.value


def _join_whole(machine: Engine, summary: Summary, registers: list[Value], merge: Merge) -> bool:
    """One more call, from the machine's state: whether the body must run again, where all of that counts."""
    before = (summary.registers, summary.before.version)
    summary.registers = _joined(summary, registers, merge)
    called = machine.state.copy()
    summary.before = join_states(summary.before, called, machine.fresh_version, merge, summary.joined)
    summary.joined = called.heap
    return before != (summary.registers, summary.before.version)


def _joined(summary: Summary, registers: list[Value], merge: Merge) -> list[Value]:
    """The arguments of all calls."""
    return [merge(a, b) for a, b in zip(summary.registers, registers, strict=True)]


def _take_in(machine: Engine, summary: Summary, registers: list[Value], merge: Merge) -> bool:
    """One more call, from the machine's state: whether the body may do something else in it than it is known to do.

    Then `before` is that state, with what the other calls had where the body looks.
    """
    before, summary.registers = summary.registers, _joined(summary, registers, merge)
    changed = before != summary.registers
    state = machine.state.copy()
    known, heap = summary.before.heap, state.heap
    for address in summary.asked_apart(known, heap):
        if known.get(address) is heap.get(address):
            continue
        ours, theirs = known.stands(address), heap.stands(address)
        if ours is None:
            changed = True
        elif theirs is None:
            heap[address] = ours
        else:
            both = heap[address] = join_objects(ours, theirs, merge)
            changed = changed or both is not ours
    if changed:
        state.done &= summary.before.done
        state.version = machine.fresh_version()
        summary.before, summary.joined = state, None
    return changed


def _behind(machine: Engine, summary: Summary, called: State, state: State) -> State:
    """What a state that the body left is for a call from the state `called`; what the body did is done there, too."""
    found = state.copy() if summary.whole else _changed(machine, summary, called, state)
    found.done = called.done | (state.done - summary.begun)
    return found


def _changed(machine: Engine, summary: Summary, called: State, state: State) -> State:
    """The state of a call with what the body changed.

    And with what it looked at and the call has not: objects that others gave it, and those that it made for others and makes again.
    """
    found = called.copy()
    for address, obj in state.heap.changed_since(summary.before.heap):
        old = found.heap.get(address)
        if old is None or summary.before.heap.get(address) is not None:
            found.heap[address] = obj
        else:  # another one was made there before
            found.heap[address] = join_objects(old, obj, join).replace(many=True)
    for address in summary.asked_apart(state.heap, found.heap):
        seen = state.heap.get(address)
        if seen is None:
            continue
        # What the body wrote may be no change, where it stood there for another call.
        unchanged = seen is summary.before.heap.get(address)
        if (unchanged and address in summary.wrote) or found.heap.stands(address) is None:
            found.heap[address] = seen
    found.version = machine.fresh_version()
    return found


def _solve(machine: Engine, summary: Summary, function: Function, key: tuple[str, object], merge: Merge) -> None:
    """Run the body for all calls that are known, until nothing changes any more."""
    summaries = machine.summaries
    outer, outermost = machine.catchers, not summaries.running
    summaries.running[key] = summary
    summary.edition += 1
    context = machine.context("summary", function.code.key)
    ended = _ended(machine)
    asked_for, machine.asked_for = machine.asked_for, summary.asked_for
    wrote, summaries.wrote = summaries.wrote, summary.wrote
    spins = machine.schedule_book.spins
    epoch, summaries.epoch = summaries.epoch, machine.fresh_version()
    try:
        for _ in range(machine.budget.fixpoint * 4):
            reads, seen, changes = summaries.provisional, summary.versions, summaries.changes
            summaries.turns += outermost
            if machine.precision.coarse or summary.handled:  # else whoever is around is told at once
                summary.catcher = summary.catcher or Catcher(machine, machine.frames[-1])
                summary.catcher.merge = merge if summary.handled else join
                machine.catchers = [*outer, summary.catcher]
            summary.handlers = len(machine.catchers)
            machine.state, summary.begun = summary.before.copy(), summary.before.done
            value = run_body(machine, function, list(summary.registers), machine.frames[-1], context)
            if value is not UNBOUND:
                summary.value = merge(summary.value, value) if summary.value is not UNBOUND else value
                summary.after = (
                    machine.state.copy()
                    if summary.after is None
                    else join_states(summary.after, machine.state.copy(), machine.fresh_version, merge)
                )
            summary.provisional = summaries.provisional != reads
            summary.turn = summaries.turns
            if not summary.provisional:
                break  # nothing inside asked for an unfinished summary: this turn was exact
            summaries.changes += seen != summary.versions
            if not machine.precision.coarse:
                if seen == summary.versions:
                    break  # those inside are solved anew in each turn
            elif not outermost or summaries.changes == changes:
                break  # of one inside another the turns are those of the outermost
        else:
            machine.report("RW201", f"the recursion of {function.code.name} did not converge")
    finally:
        del summaries.running[key]
        machine.catchers = outer
        summary.asked_for |= machine.asked_for  # which is another set where callbacks have run
        machine.asked_for = asked_for
        summary.wrote |= summaries.wrote
        summaries.wrote = wrote
        if key[0] in summaries.recursive or ended != _ended(machine) or spins != machine.schedule_book.spins:
            summary.whole = True
        summaries.epoch = epoch


def _ended(machine: Engine) -> int | None:
    """What tells whether a state was kept for the end of the program: one that is not kept for later calls."""
    return None if machine.ends is None else machine.ends.version


def _of_summary(machine: Engine, summary: Summary, called: State) -> Value:
    """What a call from the state `called` gives by its summary."""
    machine.asked_for |= summary.asked_for  # of the body, which may not have run for this call
    machine.summaries.wrote |= summary.wrote

    def seen(state: State) -> State:
        return _behind(machine, summary, called, state)

    if summary.catcher is not None:
        rethrow(machine, summary.catcher, seen)
    if summary.after is None:
        return UNBOUND
    machine.state = seen(summary.after)
    return summary.value
