# SPDX-License-Identifier: Apache-2.0
"""Iteration: what a value yields, and loops over it.

for n in ['a', 'b']: …           a known sequence is followed item by item, a list as it stands at each turn (it may grow meanwhile)
for n in Names(): …              `__next__` is called before each turn, until it raises StopIteration
for n in words(): …              a generator runs to its next `yield` before each turn: it and the loop see what the other wrote
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.heap import Obj, Shuffled
from rosward.domain.series import Series
from rosward.domain.state import element, join_registers, join_states
from rosward.domain.suspended import ANY_TURN
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Function, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.control import behind, roughly, turn, until_stable
from rosward.engine.python import abandoned, attributes, calls, classes, contents, metaclasses, stepping
from rosward.engine.python.orders import tells_order
from rosward.engine.running.frame import Frame, Snapshot
from rosward.ir import ops
from rosward.models.native import Items
from rosward.models.python.containers.any_order import in_places, unordered
from rosward.models.python.containers.lists import ITERATOR, VIEW, exhaust, write_series
from rosward.models.python.operators import operators
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_FEW: Final = 3
"""So many objects are iterated over one by one, whatever their iterators are."""
_APART: Final = 8
"""So many elements of which any may stand at a place of a set are followed one by one; in a loop in such a loop, few."""


class Begun(NamedTuple):
    """A turn that was suspended: its number, what the loop runs over, what is ahead, and how the turn is finished."""

    turn: int
    source: Value
    ahead: Items
    finish: Callable[[], bool]


def for_each(machine: Engine, op: ops.ForEach, frame: Frame, begun: Begun | None = None) -> bool | None:
    """A loop over what a value yields. `begun`: go on in a turn that was suspended."""
    frame.op, frame.sequence = op, 0
    around, context = frame.exits.enter_loop(), frame.context
    returned, raised = frame.exits.returned, machine.raised
    if begun is None:
        source = stepping.made(machine, frame.registers[op.iterable], asynchronous=op.is_async)
    else:
        source = begun.source
    machine.precision.begin_loop(op, frame)
    if source is UNBOUND:
        alive = False
    elif stepping.steps(machine, source, asynchronous=op.is_async):
        source = stepping.iterator_of(machine, source, asynchronous=op.is_async)
        alive = _over_iterator(machine, op, frame, context, source, begun)
    else:
        found = _found(machine, op, frame, source) if begun is None else begun.ahead
        alive = _over_items(machine, op, frame, context, source, found, begun)
    machine.precision.end_loop(op, frame)
    frame.context = context
    for left in (frame.exits.broken, frame.exits.returned):
        if left is not None and left is not returned:
            abandoned.close_behind(machine, left, source)
    abandoned.watch_raising(machine, source, raised)
    return behind(machine, op, frame, alive, around)


def _enter_turn(
    machine: Engine, op: ops.ForEach, frame: Frame, context: int, number: int, source: Value, ahead: Items
) -> None:
    """A turn begins, for which the loop asks: what it makes is told apart from what others make."""
    frame.op, frame.sequence = op, 0
    frame.context = machine.context(context, frame.code.key, op.number, "*" if number == ANY_TURN else number)
    if frame.yielded is not None:
        rest = UNBOUND if ahead.rest is None else ahead.rest
        frame.turns[op.number] = (number, source, Tuple(ahead.known), rest)


def _over_items(
    machine: Engine,
    op: ops.ForEach,
    frame: Frame,
    context: int,
    source: Value,
    found: Items,
    begun: Begun | None,
) -> bool:
    """Item by item; any number of turns where items are too many or of unknown number."""
    live = source if isinstance(source, Ref) and _is_list(machine, source) else None
    drained = source if isinstance(source, Ref) and _is_drained(machine, source) else None
    shuffled = frame.yielded is None and isinstance(source, Ref) and bool(unordered(machine.obj(source)))
    sizes = _sizes(machine, source)
    number, offset, alive = 0, 0, True
    if begun is not None:
        number = begun.turn
        _enter_turn(machine, op, frame, context, number, source, found)
        if not begun.finish():
            return False
        number = offset = number + 1 if number >= 0 else machine.budget.unroll
    anywhere = begun is not None and begun.turn == ANY_TURN
    known, rest = _ahead(machine, found, live if begun is None else None, anywhere=anywhere)
    if roughly(machine, frame, len(known)) or _spent(machine, len(known) - 1, machine.precision.turns + len(known) - 1):
        rest = _any_of(Items(known, rest))
        known = ()
    elif live is not None and not anywhere:
        rest = None  # it is asked at each turn
    while rest is None or number - offset < len(known):
        if live is not None:  # as the list stands now: a turn may have changed it
            (known, rest), offset = _head_and_rest(machine.obj(live)), 0
            if _spent(machine, number, machine.precision.turns):
                rest = _any_of(Items(known[number:], rest))
                break
        if drained is not None:  # what is left of it: a turn may have taken some
            left_over = machine.obj(drained).series()
            if not left_over.head:
                rest = element(machine.obj(drained))
                break
            known, offset = left_over.head, number
            write_series(machine, drained, left_over.without(1))
        if number - offset >= len(known):
            break
        machine.precision.turns += 1
        ahead = Items((), None) if live is not None else Items(known[number - offset + 1 :], rest)
        _enter_turn(machine, op, frame, context, number, source, ahead)
        alive = _turn_with(machine, op, frame, known[number - offset], apart=shuffled)
        if not alive:
            return False
        number += 1
        machine.check_time()
        if roughly(machine, frame, len(known)):
            if live is not None:
                known, rest = _head_and_rest(machine.obj(live))
            rest = _any_of(Items(known[number - offset :], rest))
            break
    if rest is None and live is None and _sizes(machine, source) != sizes:
        rest = _elements_now(machine, source)
    if rest is None:
        return True
    if isinstance(source, Ref) and machine.obj(source).payload == ITERATOR:
        write_series(machine, source, Series((), rest))  # how many are taken is not known
    _enter_turn(machine, op, frame, context, ANY_TURN, source, Items((), rest))
    anything = rest

    def feed() -> tuple[Value, Snapshot]:
        now = _elements_now(machine, source) if live is None else _behind(machine.obj(live), 0 if anywhere else number)
        return join(anything, now), machine.snapshot(frame)

    return until_stable(machine, op, frame, None, feed)


def _found(machine: Engine, op: ops.ForEach, frame: Frame, source: Value) -> Items:
    """What a loop runs over: each element once, or what may stand where if the order tells, as for who asks a generator."""
    if source.__class__ is Ref and unordered(machine.obj(source)):
        tells = frame.yielded is not None or tells_order(op)
        return in_places(machine, source) if tells else iterate(machine, source)
    return iterate(machine, source)


def _turn_with(machine: Engine, op: ops.ForEach, frame: Frame, item: Value, *, apart: bool) -> bool:
    """A turn with an item. `apart`: with each that may stand there alone, so that what it says of itself (a name and its type) stays together."""
    alternatives = options(item) if apart else (item,)
    if not 1 < len(alternatives) <= (_FEW if machine.precision.apart else _APART):
        frame.registers[op.item] = item
        return turn(machine, op.body, frame)
    before, context = frame.registers, frame.context
    ends: list[list[Value]] = []

    def one(number: int) -> Value:
        frame.registers = before.copy()
        frame.registers[op.item] = alternatives[number]
        frame.context = machine.context(context, frame.code.key, op.number, number)  # as for turns
        if not turn(machine, op.body, frame):
            return UNBOUND
        ends.append(frame.registers)
        return NONE

    each_apart(machine, range(len(alternatives)), one)
    frame.registers = reduce(join_registers, ends) if ends else before
    return bool(ends)


def _ahead(machine: Engine, found: Items, live: Ref | None, *, anywhere: bool) -> Items:
    """What is ahead when a loop begins, or goes on: after any number of turns anything. `live`: the list over which it begins."""
    if anywhere:
        rest = _any_of(found)
        return Items((), UNBOUND if rest is None else rest)
    return found if live is None else _head_and_rest(machine.obj(live))


def _spent(machine: Engine, number: int, turns: int) -> bool:
    """Whether so many turns of a loop, or of a nest of loops, are all that are followed one by one."""
    return number >= machine.budget.unroll or turns >= machine.budget.turns


def _head_and_rest(record: Obj) -> Items:
    """The first elements of a list, which are known apart, and any of the others; None where there are none."""
    series = record.series()
    return Items(series.head, series.behind_head())


def _behind(record: Obj, taken: int) -> Value:
    """Any element of a list behind the first ones; UNBOUND where there is none."""
    found = record.series().without(taken).element()
    return UNBOUND if found is None else found


def _any_of(items: Items) -> Value | None:
    """Any of the items; None where there are none."""
    found = [*items.known, *(() if items.rest is None else (items.rest,))]
    return join_all(found) if found else None


def _is_list(machine: Engine, value: Ref) -> bool:
    """Whether a value is a list itself, not an iterator over one."""
    record = machine.obj(value)
    return record.kind == "list" and record.payload in (None, VIEW)


def _is_drained(machine: Engine, value: Ref) -> bool:
    """Whether a value is an iterator over known items, from which a loop takes them one by one."""
    record = machine.obj(value)
    return record.kind == "list" and record.payload == ITERATOR and not record.many


def _sizes(machine: Engine, source: Value) -> list[int | None]:
    """The lengths of the lists that a choice of them holds, and of a list of unknown order."""
    if not isinstance(source, Choice):
        record = machine.obj(source) if isinstance(source, Ref) else None
        shuffled = record is not None and record.payload.__class__ is Shuffled
        return [None if record.items is None else len(record.items)] if record is not None and shuffled else []
    records = [machine.obj(o) for o in source.options if isinstance(o, Ref) and _is_list(machine, o)]
    return [None if r.items is None else len(r.items) for r in records]


def _elements_now(machine: Engine, source: Value) -> Value:
    """What the lists among the sources hold at this moment."""
    found = [element(machine.obj(o)) for o in options(source) if isinstance(o, Ref) and _is_list(machine, o)]
    return join_all(e for e in found if e is not None)


# Iterators that are advanced


def _over_iterator(
    machine: Engine, op: ops.ForEach, frame: Frame, context: int, iterator: Value, begun: Begun | None
) -> bool:
    """An item, a turn, an item, a turn, …: one by one while it surely gives an item, then to a fixpoint."""
    nothing = Items(())
    number, any_number = 0, False
    if begun is not None:
        _enter_turn(machine, op, frame, context, begun.turn, iterator, nothing)
        if not begun.finish():
            return False
        number, any_number = begun.turn + 1, begun.turn == ANY_TURN or frame.uncertain > 0
    most = machine.budget.unroll if stepping.is_generator(machine, iterator) else machine.budget.unroll_while
    while (
        not any_number
        and number < most
        and machine.precision.turns < machine.budget.turns
        and not roughly(machine, frame, number)
    ):
        _enter_turn(machine, op, frame, context, number, iterator, nothing)
        before = machine.snapshot(frame)
        item, ended, _ = stepping.step(machine, iterator, asynchronous=op.is_async)
        if item is UNBOUND:
            if ended is None:
                return False
            machine.state = ended
            return True
        if ended is not None or (item.__class__ is Unknown and not stepping.is_generator(machine, iterator)):
            machine.resume(frame, before)
            break
        frame.registers[op.item] = item
        if not turn(machine, op.body, frame):
            return False
        if machine.state.version == before.state.version:
            break
        number += 1
        machine.precision.turns += 1
        machine.check_time()
    _enter_turn(machine, op, frame, context, ANY_TURN, iterator, nothing)

    def feed() -> tuple[Value, Snapshot | None]:
        start = None if stepping.is_generator(machine, iterator) else machine.state.copy()
        item, ended, _ = stepping.step(machine, iterator, asynchronous=op.is_async)
        if start is not None:  # an object of the program may end any time
            ended = start if ended is None else join_states(start, ended, machine.fresh_version)
        return item, None if ended is None else Snapshot(frame.registers.copy(), ended)

    return until_stable(machine, op, frame, None, feed)


# What a value yields


def iterate(machine: Engine, value: Value) -> Items:
    """What `for x in value` sees."""
    if value.__class__ is Choice:
        return _iterate_choice(machine, value)
    if value.__class__ is Ref:
        obj = machine.obj(value)
        if obj.kind == "generator":
            return machine.run_out(value)[0]
        if obj.kind == "instance":
            return _iterate_instance(machine, value)
    of_class = metaclasses.method(machine, value, "__iter__") if value.__class__ is Class else None
    if of_class is not None:
        return machine.iterate(machine.call(of_class, ()))
    if value.__class__ is Class and classes.is_enum(machine, value):
        return machine.iterate(machine.call_native("enum.iterate", (value,)))
    if value.__class__ in (External, Native, Function, Class):
        return Items((), machine.unknown(Cause.CALL, getattr(value, "name", "")))
    return operators.iterate(machine, value)


def series(machine: Engine, value: Value) -> Series:
    """What `for x in value` sees, as far as the order is known."""
    if isinstance(value, Ref) and machine.obj(value).kind == "instance":
        iterator = stepping.made(machine, value, asynchronous=False)
        if iterator is UNBOUND:
            return Series()
        if iterator != value:
            found = machine.series(iterator)
            exhaust(machine, iterator)
            return found
    if isinstance(value, Ref) and machine.obj(value).kind not in ("list", "set", "dict"):
        return Series(*machine.iterate(value))
    return operators.series(machine, value)


def _iterate_choice(machine: Engine, value: Choice) -> Items:
    """Item by item where all alternatives have one length, else any number of any item. Each alternative runs from the same state."""
    all_items: list[Items] = []

    def one(option: Value) -> Value:
        all_items.append(machine.iterate(option))
        return NONE

    each_apart(machine, _iterators(machine, [o for o in value.options if o != NONE]), one)
    if not all_items:
        return Items(())
    lengths = {len(i.known) for i in all_items if i.rest is None}
    if len(lengths) == 1 and all(i.rest is None for i in all_items):
        return Items(tuple(join_all(column) for column in zip(*(i.known for i in all_items), strict=True)))
    elements = [e for i in all_items for e in (*i.known, *(() if i.rest is None else (i.rest,)))]
    return Items((), join_all(elements)) if elements else Items(())


def _iterators(machine: Engine, several: list[Value]) -> list[Value]:
    """Values to iterate over; of more than a few objects of the program their iterators, each once: many may have one in common."""
    if sum(stepping.is_followed(machine, o) for o in several) <= _FEW:
        return several
    found: dict[Value, None] = {}

    def make(option: Value) -> Value:
        iterator = stepping.made(machine, option)
        if iterator is not UNBOUND:
            found[iterator] = None
        return iterator

    each_apart(machine, several, make)
    return list(found)


def _iterate_instance(machine: Engine, value: Value) -> Items:
    method = attributes.method(machine, value, "__iter__")
    held = contents.iterated(machine, value, method)
    if held is not None:
        return machine.iterate(held)
    if method is not None:
        iterator = calls.call(machine, method, (), {})
        if iterator is UNBOUND:
            return Items(())
        if iterator != value:
            found = machine.iterate(iterator)
            exhaust(machine, iterator)
            return found
    if attributes.method(machine, value, "__next__") is not None:
        return stepping.drain(machine, value)[0]
    method = attributes.method(machine, value, "__getitem__")
    if method is not None:
        item = calls.call(machine, method, (machine.unknown(Cause.OPERATION, "index", "int"),), {})
        return Items(()) if item is UNBOUND else Items((), item)
    return Items((), machine.unknown(Cause.OPERATION, "iteration"))
