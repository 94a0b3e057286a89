# SPDX-License-Identifier: Apache-2.0
"""Iteration: what a value yields, and loops over it.

for n in ['a', 'b']: …           a known sequence is followed item by item, a list as it stands at each turn (it may grow meanwhile)
for n in Names(): …              `__next__` is called before each turn, until it raises StopIteration
for n in generator(): …          the generator runs first; the loop sees its states at the yields, joined
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options, widen
from rosward.domain.series import Series
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import (
    NONE,
    UNBOUND,
    Choice,
    Class,
    External,
    Function,
    Native,
    Ref,
    Unknown,
    Value,
)
from rosward.engine import activation, attributes, calls, classes
from rosward.engine.alternatives import each_apart
from rosward.engine.catcher import Catcher, rethrow
from rosward.engine.control import behind, turn, until_stable
from rosward.engine.frame import Frame, Snapshot
from rosward.engine.raised import may_catch
from rosward.engine.state import EventKey, State, element, join_states
from rosward.ir import ops
from rosward.models import operators
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter

_STEP: Final = {
    False: ("__iter__", "__next__", "StopIteration"),
    True: ("__aiter__", "__anext__", "StopAsyncIteration"),
}


def for_each(machine: Interpreter, op: ops.ForEach, frame: Frame) -> bool | None:
    """A loop over what a value yields."""
    frame.line, frame.column, frame.sequence = op.line, op.column, 0
    source = frame.registers[op.iterable]
    saved, context = (frame.exits.broken, frame.exits.continued), frame.context
    frame.exits.broken = frame.exits.continued = None
    begun: frozenset[EventKey] | None = None
    returned = frame.exits.returned
    source = _made(machine, source, asynchronous=op.is_async)
    machine.begin_loop(op)
    if source is UNBOUND:
        alive = False
    elif _steps(machine, source, asynchronous=op.is_async):
        alive = _over_iterator(machine, op, frame, context, source)
    else:
        known, rest, begun = _run_source(machine, source)
        alive = _over_items(machine, op, frame, context, source, Items(known, rest))
    machine.end_loop(op)
    frame.context = context
    if alive:
        alive = machine.run(op.orelse, frame)
    if begun is not None:
        for left in (frame.exits.broken, frame.exits.returned):
            if (
                left is not None and left is not returned
            ):  # what the generator does behind its first item may not happen
                left.state.done &= begun
    return behind(machine, frame, alive, saved)


def _run_source(
    machine: Interpreter, source: Value
) -> tuple[tuple[Value, ...], Value | None, frozenset[EventKey] | None]:
    """What a source yields; where it is a generator also what it surely did before its first item."""
    if isinstance(source, Ref) and machine.obj(source).kind == "generator":
        run = activation.run_generator(machine, machine.obj(source))
        return (*run.items, run.begun)
    return (*iterate(machine, source), None)


def _over_items(machine: Interpreter, op: ops.ForEach, frame: Frame, context: int, source: Value, found: Items) -> bool:
    """Item by item; any number of turns where items are too many or of unknown number."""
    known, rest = found
    live = source if isinstance(source, Ref) and _is_list(machine, source) else None
    sizes = _sizes(machine, source)
    budget = machine.budget
    if machine.coarse or len(known) > budget.unroll or machine.turns + len(known) > budget.turns:
        rest = join_all([*known, *(() if rest is None else (rest,))])
        known = ()
    number, alive = 0, True
    while rest is None or number < len(known):
        if live is not None:  # as the list stands now: a turn may have changed it
            record = machine.obj(live)
            if record.items is None or number >= budget.unroll or machine.turns >= budget.turns:
                rest = element(record)
                break
            known = record.items
        if number >= len(known):
            break
        machine.turns += 1
        frame.context = machine.context(context, id(op), number)
        frame.registers[op.item] = known[number]
        alive = turn(machine, op.body, frame)
        if not alive:
            return False
        number += 1
        machine.check_time()
        if machine.coarse:
            now = known if live is None else machine.obj(live).items
            left = (*(now or ())[number:], *(() if rest is None else (rest,)))
            if now is not None and not left:
                return True
            rest, known = join_all(left) if left else rest, ()
            break
    if rest is None and live is None and _sizes(machine, source) != sizes:
        rest = _elements_now(machine, source)
    if rest is None:
        return True
    frame.context = machine.context(context, id(op), "*")
    anything = rest

    def feed() -> tuple[Value, Snapshot]:
        return join(anything, _elements_now(machine, source)), machine.snapshot(frame)

    return until_stable(machine, op, frame, None, feed)


def _is_list(machine: Interpreter, value: Ref) -> bool:
    """Whether a value is a list itself, not an iterator over one."""
    record = machine.obj(value)
    return record.kind == "list" and record.payload is None


def _sizes(machine: Interpreter, source: Value) -> list[int | None]:
    """The lengths of the lists that a choice of them holds."""
    if not isinstance(source, Choice):
        return []
    records = [machine.obj(o) for o in source.options if isinstance(o, Ref) and _is_list(machine, o)]
    return [None if r.items is None else len(r.items) for r in records]


def _elements_now(machine: Interpreter, source: Value) -> Value:
    """What the lists among the sources hold at this moment."""
    found = [element(machine.obj(o)) for o in options(source) if isinstance(o, Ref) and _is_list(machine, o)]
    return join_all(e for e in found if e is not None)


# Iterators of the program's own classes


def _made(machine: Interpreter, source: Value, *, asynchronous: bool) -> Value:
    """What `__iter__` of an object of the program gives; any other value itself."""
    if not isinstance(source, Ref) or machine.obj(source).kind != "instance":
        return source
    method = attributes.method(machine, source, _STEP[asynchronous][0])
    return source if method is None else calls.call(machine, method, (), {})


def _steps(machine: Interpreter, source: Value, *, asynchronous: bool) -> bool:
    """Whether a value is an object of the program that has a `__next__`."""
    if not isinstance(source, Ref) or machine.obj(source).kind != "instance":
        return False
    return attributes.method(machine, source, _STEP[asynchronous][1]) is not None


def _over_iterator(machine: Interpreter, op: ops.ForEach, frame: Frame, context: int, iterator: Value) -> bool:
    """`__next__`, turn, `__next__`, turn, …: one by one while it surely gives an item, then to a fixpoint."""
    number = 0
    while number < machine.budget.unroll_while and machine.turns < machine.budget.turns and not machine.coarse:
        frame.context = machine.context(context, id(op), number)
        before = machine.snapshot(frame)
        item, ended = _advance(machine, frame, iterator, asynchronous=op.is_async)
        if item is UNBOUND:
            if ended is None:
                return False
            machine.state = ended
            return True
        if ended is not None or item.__class__ is Unknown:
            machine.resume(frame, before)
            break
        frame.registers[op.item] = item
        if not turn(machine, op.body, frame):
            return False
        if machine.state.version == before.state.version:
            break
        number += 1
        machine.turns += 1
        machine.check_time()
    frame.context = machine.context(context, id(op), "*")

    def feed() -> tuple[Value, Snapshot]:
        start = machine.state.copy()
        item, ended = _advance(machine, frame, iterator, asynchronous=op.is_async)
        end = start if ended is None else join_states(start, ended, machine.fresh_version)
        return item, Snapshot(frame.registers.copy(), end)

    return until_stable(machine, op, frame, None, feed)


def _advance(machine: Interpreter, frame: Frame, iterator: Value, *, asynchronous: bool) -> tuple[Value, State | None]:
    """The next item of an iterator (UNBOUND: surely none), and the state in which it ends instead (None: it surely does not)."""
    _, step, stop = _STEP[asynchronous]
    outer, catcher = machine.catchers, Catcher(machine, frame)
    machine.catchers = [*outer, catcher]
    try:
        item = machine.call_method(iterator, step, ())
        if asynchronous and item is not UNBOUND:
            item = machine.wait_for(item)
    finally:
        machine.catchers = outer
    wanted = Native(f"builtins.{stop}")
    ended: State | None = None
    others = Catcher(machine, frame)
    for exception, snapshot in catcher.arrivals.items():
        caught = may_catch(machine, exception, wanted)
        if caught is not False:
            state = snapshot.state.copy()
            ended = state if ended is None else join_states(ended, state, machine.fresh_version)
        if caught is not True:
            others.arrive(machine, exception, snapshot.state)
    if outer and catcher.level:
        outer[-1].take_over(machine, catcher)
    rethrow(machine, others)
    return item, ended


def _drain(machine: Interpreter, iterator: Value) -> Items:
    """All that an iterator gives, where no loop of the program asks for it (`list(Names())`)."""
    frame = machine.frames[-1]
    context = frame.context
    known: list[Value] = []
    try:
        while len(known) < machine.budget.unroll_while:
            frame.context = machine.context(context, frame.line, frame.column, "next", len(known))
            before = machine.state.copy()
            item, ended = _advance(machine, frame, iterator, asynchronous=False)
            if item is UNBOUND:
                machine.state = before if ended is None else ended
                return Items(tuple(known))
            if ended is not None or item.__class__ is Unknown:
                machine.state = before
                break
            known.append(item)
            if machine.state.version == before.version:
                break
        frame.context = machine.context(context, frame.line, frame.column, "next", "*")
        rest = _drain_rest(machine, frame, iterator)
        return Items(tuple(known), None if rest is UNBOUND else rest)
    finally:
        frame.context = context


def _drain_rest(machine: Interpreter, frame: Frame, iterator: Value) -> Value:
    """Any number of further items, joined; leaves the machine in a state that covers each end."""
    reason = Reason(Cause.LOOP, "", machine.place)

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    rest: Value = UNBOUND
    head = machine.state.copy()
    for number in range(machine.budget.fixpoint * 4):
        machine.state = head.copy()
        item, ended = _advance(machine, frame, iterator, asynchronous=False)
        seen = (head.version, rest)
        if ended is not None:
            head = join_states(head, ended, machine.fresh_version, widening)
        if item is UNBOUND:
            break
        merge = join if number < machine.budget.widen_after else widening
        rest = item if rest is UNBOUND else merge(rest, item)
        head = join_states(head, machine.state, machine.fresh_version, merge)
        if seen == (head.version, rest):
            break
    else:
        machine.report("RW201", "an iterator did not come to rest; what it does later may be missing")
    machine.state = head
    return rest


# What a value yields


def iterate(machine: Interpreter, value: Value) -> Items:
    """What `for x in value` sees."""
    cls = value.__class__
    if cls is Choice:
        return _iterate_choice(machine, value)  # type: ignore[arg-type]
    if cls is Ref:
        obj = machine.obj(value)  # type: ignore[arg-type]
        if obj.kind == "generator":
            return activation.run_generator(machine, obj).items
        if obj.kind == "instance":
            return _iterate_instance(machine, value)
    if cls is Class and classes.is_enum(machine, value):  # type: ignore[arg-type]
        return machine.iterate(machine.call(Native("enum.iterate"), (value,)))
    if cls in (External, Native, Function, Class):
        return Items((), machine.unknown(Cause.CALL, getattr(value, "name", "")))
    return operators.iterate(machine, value)


def series(machine: Interpreter, value: Value) -> Series:
    """What `for x in value` sees, as far as the order is known."""
    if isinstance(value, Ref) and machine.obj(value).kind == "instance":
        iterator = _made(machine, value, asynchronous=False)
        if iterator is UNBOUND:
            return Series()
        if iterator != value:
            return machine.series(iterator)
    if isinstance(value, Ref) and machine.obj(value).kind not in ("list", "set", "dict"):
        return Series(*machine.iterate(value))
    return operators.series(machine, value)


def _iterate_choice(machine: Interpreter, value: Choice) -> Items:
    """Item by item where all alternatives have one length, else any number of any item. Each alternative runs from the same state."""
    all_items: list[Items] = []

    def one(option: Value) -> Value:
        all_items.append(machine.iterate(option))
        return NONE

    each_apart(machine, [o for o in value.options if o != NONE], one)
    if not all_items:
        return Items(())
    lengths = {len(i.known) for i in all_items if i.rest is None}
    if len(lengths) == 1 and all(i.rest is None for i in all_items):
        return Items(tuple(join_all(column) for column in zip(*(i.known for i in all_items), strict=True)))
    elements = [e for i in all_items for e in (*i.known, *(() if i.rest is None else (i.rest,)))]
    return Items((), join_all(elements)) if elements else Items(())


def _iterate_instance(machine: Interpreter, value: Value) -> Items:
    method = attributes.method(machine, value, "__iter__")
    if method is not None:
        iterator = calls.call(machine, method, (), {})
        if iterator is UNBOUND:
            return Items(())
        if iterator != value:
            return machine.iterate(iterator)
    if attributes.method(machine, value, "__next__") is not None:
        return _drain(machine, value)
    method = attributes.method(machine, value, "__getitem__")
    if method is not None:
        item = calls.call(machine, method, (machine.unknown(Cause.OPERATION, "index", "int"),), {})
        return Items(()) if item is UNBOUND else Items((), item)
    return Items((), machine.unknown(Cause.OPERATION, "iteration"))
