# SPDX-License-Identifier: Apache-2.0
"""What may run later: callbacks of every kind, run to a fixpoint, in any order, any number of times.

self.create_timer(1.0, self.tick)     tick runs wherever the program spins, and after its main body
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options, reasons_of, widen
from rosward.domain.state import State, join_objects, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import UNBOUND, Class, Ref, Unknown, Value
from rosward.engine.arguments import ANY
from rosward.engine.budget import BeginAnewError, LimitReachedError
from rosward.engine.callbacks import made_many, waits_recalled
from rosward.engine.callbacks.alike import code_key, standing_for
from rosward.engine.callbacks.unchanged import is_unchanged, remembered
from rosward.engine.callbacks.unheld import arrive, unheld
from rosward.engine.running.attributes_asked import records_of
from rosward.engine.running.catcher import LIBRARY
from rosward.engine.running.frame import Frame
from rosward.engine.running.scheduled import Scheduled
from rosward.engine.throwing import note, throw
from rosward.engine.unknown.escape import BY_BASE, BY_LIBRARY, BY_PYTHON, BY_WINDOW
from rosward.findings import Finding, Findings
from rosward.ir.ops import Op
from rosward.ir.program import Code, CodeKind, Parameters
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.effects.log import EntityEffect
    from rosward.engine.machine import Engine


def _fails(effect: EntityEffect) -> bool:
    """Whether an entity is made of something that is not there: a name or a node that an attribute would have to hold."""
    causes = {r.cause for r in reasons_of(effect.name)}
    return effect.address is None or Cause.ERROR in causes


_MOST_RAISED: Final = 12
_MOST_WAITS: Final = 4
"""How often callbacks are followed precisely where the main body waits; behind that, those that create nothing are only where it spins or ends."""
_STEPS_OF_EACH: Final = 300
"""What each callback may take on top of what all may take together: a large program has many small ones."""
_IN_TURN: Final = frozenset(
    (
        *("accepted", "cancel", "execute", "feedback", "future", "goal", "guard condition", "message", "parameters"),
        *("qos event", "qos override", "service", "task", "tick", "time jump", "timer", "transition", "waitable"),
        *("end of a generator", "log", "print"),
        BY_PYTHON,
    )
)
"""What runs one after the other in the thread that spins, or where the program itself lets it run.

Anything else may run beside a callback, or finds what one has left that was interrupted (`atexit`).
"""
_NO_PARAMETERS: Final = Parameters((), 0, None, (), None)


def add(
    machine: Engine,
    callback: Value,
    args: tuple[Value, ...] | None,
    event: str,
    place: Place | None = None,
    answered: Value | None = None,
) -> None:
    """Register a callback; here, unless another place is given. `answered` is called with what it returns."""
    book = machine.schedule_book
    for option in options(callback):
        key = (option, args)
        book.by_library = book.by_library or event in (BY_LIBRARY, BY_BASE, BY_WINDOW)
        if key not in book.entries and option.__class__ is not Unknown:
            entry = book.entries[key] = Scheduled(
                option,
                args,
                event,
                place or machine.place,
                machine.state.copy(),
                _context(machine, option, event),
            )
            entry.answered = answered
            book.beside = book.beside or event == "coroutine"
            book.parallel = book.parallel or event not in _IN_TURN
            if event == "thread" and not book.running:
                _start(machine, entry)
                waits(machine)
        if machine.watch is not None and key in book.entries:
            machine.watch.schedule(machine, book.entries[key])


def _start(machine: Engine, entry: Scheduled) -> None:
    """A thread runs from here on: what follows may see what it writes, and it what is written so far.

    Where it finds an attribute missing that is set below, the program would fail: of that nothing is told.
    """
    before, findings, entities = machine.state, Findings(machine.log.findings), frozenset(machine.log.entities)
    machine.state = before.copy()
    with _alone(machine):
        _call(machine, entry)
    machine.state = join_states(before, machine.state, machine.fresh_version)
    findings.update(
        [f for f in machine.log.findings if f.code == "RW201"]
    )  # what took too many steps does not run again
    machine.log.findings = findings
    for effect in [e for e in machine.log.entities if e not in entities and _fails(e)]:
        del machine.log.entities[effect]


@contextmanager
def _alone(machine: Engine) -> Iterator[None]:
    """What is scheduled runs under no frame and no `try` of the main body."""
    book = machine.schedule_book
    book.running = True
    book.spins += 1
    catchers, machine.catchers = machine.catchers, []
    handling, machine.handling = machine.handling, []
    frames, machine.frames = machine.frames, []
    try:
        with machine.precision.callbacks():
            yield
    finally:
        book.running = False
        machine.frames = frames
        machine.catchers, machine.handling = catchers, handling


def _context(machine: Engine, callback: Value, event: str) -> int:
    """The context in which a callback runs: its own, unless a callback registers it: then there must be finitely many.

    So must there be where Python calls a method of each object: it may make another one (`__copy__`).
    """
    book = machine.schedule_book
    if not book.running and event != BY_PYTHON:
        return machine.context("callback", len(book.entries))
    return machine.context("later callback", code_key(callback), event, machine.place)


def spin(machine: Engine, *, serving: bool = False, beside: bool = False) -> None:
    """Run everything until neither the heap nor the schedule changes; the machine's state becomes the join of all that may be.

    `serving`: it is the client library that spins, not a wait for what others do; `beside`: in a thread, where exceptions of callbacks end that.
    """
    book = machine.schedule_book
    if book.running:
        book.beside = book.beside or (serving and book.event == "thread")
        book.parallel = book.parallel or (serving and bool(machine.catchers))  # here comes out what interrupts others
        _between(machine)
        return
    book.spins += 1
    if book.settled != _reached(machine):
        frames = machine.frames
        machine.summaries.waiting.update(frame.code.key for frame in frames)
        with _alone(machine):
            book.waited += beside
            book.hurried = beside and book.waited > _MOST_WAITS
            if book.hurried:
                waits_recalled.run_or_recall(machine, lambda: _run(machine, frames))
            else:
                _run(machine, frames)
            book.hurried = False
        machine.unheld = set()
        book.settled = _reached(machine)
    if not beside:
        _throw(machine)


def _reached(machine: Engine) -> tuple[int, int, bool]:
    """How far all has come: where this is as it was, callbacks would do what they did."""
    book = machine.schedule_book
    return len(book.entries), machine.state.version, book.parallel


def waits(machine: Engine, *, suspended: bool = False, others: bool = False) -> None:
    """The main body waits: what a thread spins beside it may run meanwhile; for `others`, where anything runs beside it.

    Of a callback, what runs beside it; if `suspended`, any.
    """
    book = machine.schedule_book
    if book.running:
        if suspended or book.parallel:
            _between(machine)
        else:
            _interrupted(machine)
        return
    machine.summaries.asked += 1  # it depends on which threads there are
    if book.beside or (others and book.parallel):
        spin(machine, beside=True)


def _between(machine: Engine) -> None:
    """A callback waits: what it has written so far is seen by all others, even if it takes that back before it ends.

    self.node = create_node('n'); spin(self.node); self.node = None
    """
    book = machine.schedule_book
    book.between = _with_this(machine, book.between)


def _interrupted(machine: Engine) -> None:
    """A callback waits, and nothing runs beside it: only who ends the program (Ctrl-C) does so here, and the main body finds it where it spins."""
    book = machine.schedule_book
    book.interrupted = _with_this(machine, book.interrupted)


def _with_this(machine: Engine, known: State | None) -> State | None:
    """What was there where a callback waited, with what is there now."""
    book, state = machine.schedule_book, machine.state
    if book.seen == state.version:
        return known
    book.seen = state.version
    machine.summaries.asked += 1  # a call in which this happens is not remembered
    seen = state.copy()
    return seen if known is None else join_states(known, seen, machine.fresh_version)


def uncaught(machine: Engine, exception: Value) -> None:
    """Nothing catches an exception. That of a callback comes out where the program spins, that of a thread ends there."""
    book = machine.schedule_book
    if not book.running:
        book.uncaught(exception, thread=False)
        return
    if book.event == "thread":
        book.uncaught(exception, thread=True)
        return
    for option in options(exception):
        known = book.raised.get(option)
        state = machine.state.copy()
        book.raised[option] = state if known is None else join_states(known, state, machine.fresh_version)
    if len(book.raised) > _MOST_RAISED:
        book.raised = {join_all(book.raised): _joined(machine)}


def _joined(machine: Engine) -> State:
    book = machine.schedule_book
    joined = machine.state.copy()
    for state in book.raised.values():
        joined = join_states(joined, state.copy(), machine.fresh_version)
    return joined


def _throw(machine: Engine) -> None:
    """The exceptions of callbacks may come out here, and one that comes from outside."""
    book = machine.schedule_book
    after = machine.state
    if book.interrupted is not None and machine.catchers:
        machine.state = join_states(after.copy(), book.interrupted.copy(), machine.fresh_version)
        note(machine, LIBRARY)
    for exception, state in book.raised.items():
        machine.state = join_states(after.copy(), state.copy(), machine.fresh_version)
        throw(machine, exception)
    machine.state = after


def _run(machine: Engine, frames: Sequence[Frame]) -> None:
    book = machine.schedule_book
    reason = Reason(Cause.LOOP, "a callback that runs again", Place("", 0))

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    made: set[int] = set()  # the addresses of what callbacks have made in the last round
    for round_ in range(machine.budget.rounds * 3):
        looked = bool(made)
        if looked:
            _look_through(machine, frames)
            made_many.mark(machine, book.entries.values(), made - machine.unheld)
            made.clear()
        start = _reached(machine)
        merge = join if round_ < machine.budget.widen_after else widening
        for each in [e for e in book.entries.values() if not e.exhausted]:
            entry = standing_for(machine, each)
            if entry is None or is_unchanged(machine, entry) or not _afford(machine, entry):
                continue
            if not looked:
                _look_through(machine, frames)
                looked = True
            base = machine.state
            machine.state = base.copy()
            with remembered(machine, entry, base):
                _call(machine, entry)
            before = base.copy()
            machine.state = join_states(base, machine.state, machine.fresh_version, merge)
            made_many.note(machine, entry, before, made)
        if start == _reached(machine):
            return
        machine.check_time()
    machine.report("RW201", "the callbacks did not converge; what they create later may be missing")


def _look_through(machine: Engine, frames: Sequence[Frame]) -> None:
    """Look for what nothing holds any more: what is made there takes its place."""
    machine.unheld = unheld(machine, machine.schedule_book.entries.values(), frames)


def _afford(machine: Engine, entry: Scheduled) -> bool:
    """Whether there are steps left for a callback. Where many are gone, precision goes first; one that has not run yet has a few of its own."""
    book = machine.schedule_book
    budget = machine.budget
    most = budget.callback_steps + _STEPS_OF_EACH * len(book.entries)
    spent = machine.precision.spent_in_callbacks
    over = spent - machine.precision.repeated_in_callbacks - most
    if over > 0 and (entry.runs or over > most * budget.coarse):
        if not book.spent:
            said = f"more than {most} steps in all callbacks; what this one and others do later is missing"
            machine.log.findings.add(Finding("RW201", said, entry.place))
        entry.exhausted = book.spent = True
        return False
    entry.late = over > 0
    if spent > most * budget.coarse:
        entry.coarse = entry.costly = True
    return True


def _call(machine: Engine, entry: Scheduled) -> None:
    """Run a callback. What it wrote in haste is doubted: where something is created of that, the process is to be followed anew."""
    book, haste = machine.schedule_book, machine.precision.haste
    book.event, book.between, book.seen = entry.event, None, machine.state.version
    for registered in (entry, *entry.others):
        machine.state.heap.fill(registered.state.heap, lambda ours, theirs: join_objects(ours, theirs, join))
    if not haste.on:
        _run_once(machine, entry, short=False)
        _leave_between(machine)
        return
    before, entries, made = machine.state.copy(), len(book.entries), (machine.log.made, haste.open)
    short = not entry.costly and code_key(entry.callback) not in haste.careful
    _run_once(machine, entry, short=short)
    _leave_between(machine)
    parts = entry.doubted | haste.behind(records_of(machine.asked_for))
    if parts and (machine.log.made, haste.open) != made:
        raise BeginAnewError(parts)
    if short and entry.coarse:
        parts |= {code_key(entry.callback)}
        haste.hurried |= parts
    if parts:
        haste.doubt((address for address, _ in machine.state.heap.changed_since(before.heap)), parts)
        for each in list(book.entries.values())[entries:]:
            each.doubted = parts


def _leave_between(machine: Engine) -> None:
    """What was there while the callback waited may be there."""
    book = machine.schedule_book
    if book.between is not None:
        machine.state = join_states(machine.state, book.between, machine.fresh_version)
        book.between = None


def _run_once(machine: Engine, entry: Scheduled, *, short: bool) -> None:
    code = Code(CodeKind.FUNCTION, "", "", entry.place.file, entry.place.line, _NO_PARAMETERS, [], 0, (), (), ())
    frame = Frame(code, [], (), machine.library.nowhere, entry.context, False)
    frame.op = Op(entry.place.line, entry.place.column)
    frame.uncertain = 1
    machine.frames.append(frame)
    key, book, before = code_key(entry.callback), machine.schedule_book, machine.precision.steps
    hurried = book.hurried and key not in machine.trace.creating
    coarse = entry.coarse
    short = short and not hurried and not entry.late
    heavy = machine.precision.begin_callback(key, coarse=coarse or hurried, short=short, late=entry.late)
    try:
        arrive(machine, entry)
        if entry.callback.__class__ is Ref and machine.obj(entry.callback).kind == "generator":
            machine.iterate(entry.callback)
        else:
            anything = machine.unknown(Cause.CALL, f"argument of a {entry.event}")
            result = machine.call(entry.callback, entry.args or (), {ANY: anything})
            if result is not UNBOUND and result.__class__ is Ref and machine.obj(result).kind == "generator":
                result = machine.run_out(result)[1]
            elif entry.callback.__class__ is Class:  # what a library makes is its own
                machine.trace.handed.update((o, entry.place) for o in options(result) if o is not UNBOUND)
            elif entry.event in (BY_LIBRARY, BY_BASE, BY_PYTHON, BY_WINDOW) and result is not UNBOUND:
                machine.escape((result,), "" if entry.event == BY_WINDOW else "a library")
            if entry.answered is not None and result is not UNBOUND:
                machine.call(entry.answered, (result,))
    except LimitReachedError as limit:
        entry.exhausted = True
        machine.report("RW201", f"{limit.what} in what a {entry.event} starts; the rest of it is missing")
        machine.check_time()
    finally:
        took_much = machine.precision.end_callback(heavy)
        entry.coarse = coarse if hurried else took_much
        book.taken[key] = book.taken.get(key, 0) + machine.precision.steps - before
        machine.frames.clear()
