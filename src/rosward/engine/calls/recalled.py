# SPDX-License-Identifier: Apache-2.0
"""Which calls need not run again, because nothing that they read has changed since they ran last in the same place?

for box in boxes: area += size(box)      the loop comes to rest: in its last turn `size` is asked what it was asked before

A call is remembered with the records that it asked for, as it found them, and with those that it left. In the same context, from the same
records, it makes the same objects at the same addresses; what it told the log, the trace and the schedule stands there already. It counts for
the steps that it took, so that precision is given up where it would be.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join
from rosward.domain.state import State, join_objects
from rosward.domain.values import Value
from rosward.engine.callbacks import schedule
from rosward.engine.running import nodes_asked
from rosward.engine.running.attributes_asked import records_of
from rosward.engine.running.summaries import Call, Changes
from rosward.engine.running.told import Kind, told_of
from rosward.engine.throwing import may_end

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.memory import Heap
    from rosward.engine.machine import Engine
    from rosward.engine.running.told import Telling

_LEAST: Final = 16
"""A call of fewer steps is made as quickly as it is remembered."""
_KEPT: Final = 12
"""So many calls with the same arguments, in the same place, are told apart by what they read."""
_PATIENCE: Final = 30
"""So many calls of one function are remembered in vain, before those that follow are made without that."""
_WORTH: Final = 10
"""For so many of them one that is recalled makes up."""
_MOST_TOLD: Final = 200
"""So much may be told to the `try` around in a call that is remembered."""
_MOST: Final = 4_000
"""So many places are remembered."""


def begun(machine: Engine) -> Call:
    """A call begins that is to be remembered."""
    call = Call(machine.state, _around(machine), _before(machine), machine.precision.effort())
    call.raised, call.begun_anew = machine.raised, len(machine.summaries.anew)
    call.begun_nodes = len(machine.log.nodes)
    call.around_fresh, machine.summaries.fresh = machine.summaries.fresh, set()
    call.around_rests, machine.precision.rests = machine.precision.rests, {}
    call.around_used, machine.summaries.used = machine.summaries.used, {}
    catcher = call.catcher = machine.catchers[-1] if machine.catchers else None
    told = machine.summaries.told if catcher is None else catcher.told
    if told is not None:
        call.first = len(told)
        _forget(told)
    elif catcher is None:
        machine.summaries.told, call.outermost = [], True
    else:
        catcher.told, call.outermost = [], True
    if catcher is not None:
        catcher.untold = True
    return call


def _forget(told: list[Telling | None]) -> None:
    """What is too long ago for any call that is running to be remembered with it: each holds a heap."""
    last = len(told) - _MOST_TOLD - 1
    while last >= 0 and told[last] is not None:
        told[last] = None
        last -= 1


def closed(machine: Engine, call: Call) -> None:
    """A call that was to be remembered is over, however it ended: the outermost of them needs no more what was told in it."""
    catcher, call.catcher = call.catcher, None
    call.around_fresh |= machine.summaries.fresh
    machine.summaries.fresh = call.around_fresh
    within, machine.precision.rests = machine.precision.rests, call.around_rests
    machine.precision.note_rests(within)
    call.around_used.update(machine.summaries.used)
    machine.summaries.used = call.around_used
    if not call.outermost:
        return
    if catcher is None:
        machine.summaries.told = None
    else:
        catcher.told = None


def ended(machine: Engine, place: object, key: str, call: Call, over: State | None = None) -> None:
    """A call has come to its end: it is remembered if it can be, and is worth it. `over`: the state in which it may end instead."""
    summaries, heap, state, catcher = machine.summaries, call.heap, machine.state, call.catcher
    call.heap = None
    assert heap is not None
    if call.before != _before(machine) or not machine.precision.was_precise(call.effort):
        return
    if not call.done <= state.done or (over is not None and not call.done <= over.done):
        return
    call.effort = machine.precision.since(call.effort)
    summaries.vain[key] = vain = summaries.vain.get(key, 0) + 1
    if vain > _PATIENCE:
        summaries.small.add(key)
    if call.effort.steps < _LEAST:
        return
    tellings = summaries.told if catcher is None else catcher.told
    assert tellings is not None
    if len(tellings) - call.first > _MOST_TOLD:
        return
    told = told_of([each for each in tellings[call.first :] if each is not None], heap, call.done)
    if told is None:
        return
    call.told, call.raised = told, machine.raised - call.raised
    call.settled = catcher is not None and catcher.version == state.version
    call.left_in = _changes(call, state, heap)
    call.over = None if over is None else _changes(call, over, heap)
    call.importing = catcher is not None and catcher.importing
    call.asked_for, call.anew = frozenset(machine.asked_for), frozenset(summaries.anew[call.begun_anew :])
    changed = {address for address, _ in call.left_in.written}
    changed.update(address for each in told for address, _ in each.objects)
    if call.over is not None:
        changed.update(address for address, _ in call.over.written)
    asked_for = frozenset(records_of(call.asked_for))
    call.fresh = {a: heap.get(a) for a in changed & summaries.fresh - asked_for - call.anew}
    call.rests, call.used, call.wrote = machine.precision.rests, summaries.used, frozenset(summaries.wrote)
    begun_with = [a for before, _ in call.rests.values() if before is not None for a, _ in before.objects]
    call.addresses = tuple(asked_for.union(changed - call.fresh.keys(), begun_with) - call.anew)
    call.records = tuple(map(heap.get, call.addresses))
    call.nodes = nodes_asked.answered(machine.log, call.asked_for, call.begun_nodes)
    if len(summaries.calls) > _MOST:
        summaries.calls.clear()
    summaries.calls[place] = (call, *summaries.calls.get(place, ())[: _KEPT - 1])


def known(machine: Engine, place: object) -> Call | None:
    """The call that was made in that place, if it would do now what it did then."""
    state = machine.state
    for call in machine.summaries.calls.get(place, ()):
        if (
            _finds(machine, call)
            and machine.precision.allows(call.effort)
            and call.done <= state.done
            and call.around == _around(machine)
            and machine.precision.begins_as(call.rests)
            and _still_stand(machine, call)
            and nodes_asked.still_holds(machine.log, call.nodes)
        ):
            return call
    return None


def _finds(machine: Engine, call: Call) -> bool:
    """Whether a call would find what it found. What nothing holds any more is nothing: what is made there takes its place."""
    heap, unheld = machine.state.heap, machine.unheld
    if any(address not in unheld and heap.get(address) is not None for address in call.anew):
        return False
    if not machine.returned.isdisjoint(call.fresh):
        return False
    if not unheld or unheld.isdisjoint(call.addresses):
        return heap.holds(call.addresses, call.records)
    found = list(zip(call.addresses, call.records, strict=True))
    if any(record is not None and address in unheld for address, record in found):
        return False
    there = [(address, record) for address, record in found if address not in unheld]
    return heap.holds(*zip(*there, strict=True)) if there else True


def _still_stand(machine: Engine, call: Call) -> bool:
    """Whether the summaries at which a call looked are what they were."""
    finished = machine.summaries.finished
    return all(finished.get(key) is one and one.edition == edition for key, (one, edition) in call.used.items())


def repeated(machine: Engine, key: str, call: Call) -> Value:
    """What a call gives; the machine is where it would be behind it."""
    vain = machine.summaries.vain
    vain[key] = vain.get(key, 0) - _WORTH
    if call.told:
        _tell_again(machine, call)
    state = machine.state
    change(machine, state, call, call.left_in)
    machine.unheld.difference_update(call.fresh)
    machine.summaries.fresh.update(call.fresh)
    if taken := machine.unheld.intersection((*call.anew, *call.addresses)):
        machine.unheld -= taken
        machine.summaries.anew += taken
    machine.raised += call.raised
    machine.asked_for |= call.asked_for
    machine.precision.repeat(call.effort)
    machine.precision.rest_again(call.rests)
    machine.summaries.used.update(call.used)
    machine.summaries.wrote |= call.wrote
    if machine.catchers:
        machine.noted = max(machine.noted, call.level)
        if call.importing:
            machine.catchers[-1].importing = True
        if call.settled:
            machine.catchers[-1].version = state.version
    return call.value


def change(machine: Engine, state: State, call: Call, changes: Changes) -> None:
    """Make a state that a call begins in one that it left."""
    for address, record in changes.written:
        state.heap[address] = (
            _over(state.heap.get(address), record, call.fresh[address]) if address in call.fresh else record
        )
    state.done |= changes.done
    if changes.written or changes.done:
        state.version = machine.fresh_version()


def _changes(call: Call, state: State, before: Heap) -> Changes:
    """What is otherwise in a state that a call left."""
    return Changes(tuple(state.heap.changed_since(before)), state.done - call.done)


def _over(found: Obj | None, record: Obj, before: Obj | None) -> Obj:
    """A variable of a call within, which may not have been made on every way: then what stood there is there still."""
    return record if found is None or found is before else join_objects(found, record, join)


def _tell_again(machine: Engine, call: Call) -> None:
    """Tell the `try` around what the call told it, or the end of the program."""
    begun, first = machine.state, True
    catcher = machine.catchers[-1] if machine.catchers else None
    steps = machine.precision.steps
    for told in call.told:
        state = begun.copy()
        if told.objects or told.done:
            state.version = machine.fresh_version()
            state.done |= told.done
            if first or told.kind is Kind.ARRIVED:
                for address, obj in told.objects:
                    state.heap[address] = obj
        if catcher is not None:
            catcher.told_again(machine, told, state, first=first)
            first = first and told.kind is Kind.ARRIVED
        else:
            assert told.exception is not None
            machine.state = state
            may_end(machine, told.exception)
            schedule.uncaught(machine, told.exception)
    machine.state = begun
    machine.precision.steps = steps  # those that it takes are among those of the call


def _around(machine: Engine) -> tuple[object, ...]:
    """What a call may ask for that is no record of the heap."""
    book, trace = machine.schedule_book, machine.trace
    return (
        len(machine.log.classes),
        len(trace.handed),
        bool(book.entries),
        book.by_library,
        book.running,
        machine.hooked,
        machine.unhooked is None,
        frozenset(machine.advancing),
        (len(trace.creating), len(machine.summaries.recursive)) if machine.precision.coarse else None,
    )


def _before(machine: Engine) -> tuple[object, ...]:
    """What must not change while a call runs that is remembered: it was no part of another one, and ended nothing."""
    summaries = machine.summaries
    return (
        summaries.provisional,
        summaries.asked,
        summaries.open,
        len(machine.log.ends) - summaries.uncaught,
        machine.schedule_book.spins,
        machine.schedule_book.asked,
    )


def place_of(machine: Engine, key: str, given: object, context: int) -> object:
    """Where a call is remembered, by what is called with what; None where it is not. `key` names what is called.

    Recursions have a memory of their own, as loops have where precision is given up; outside of loops the main body goes on.
    """
    precision = machine.precision
    if (
        not machine.language.recalls
        or not (precision.loops or machine.schedule_book.running)
        or machine.handling
        or machine.making
        or not machine.log.tells_once
        or key in machine.summaries.small
    ):
        return None
    where = _tried(machine), bool(precision.loops), bool(precision.fixpoints), precision.coarse
    stands = machine.frames[-1] if machine.frames else None
    asks = (
        machine.place if stands is not None and stands.stub else None
    )  # what a model does is told at the place that asks for it
    return given, context, where, asks, machine.language.situation(machine)


def _tried(machine: Engine) -> object:
    """What a call may ask of the `try` around: what each surely catches, innermost first, and whether the state counts there already."""
    catchers = machine.catchers
    if not catchers:
        return None
    return catchers[-1].level, tuple(dict.fromkeys([(c.handles, c.classes) for c in reversed(catchers)]))
