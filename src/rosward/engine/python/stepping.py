# SPDX-License-Identifier: Apache-2.0
"""Advancing an iterator by one item: generators, objects with `__next__`, iterators over known items.

next(words)       the item, and the state behind it; where it may be at its end, also the state in which StopIteration is raised
list(words)       one after the other while it surely gives an item, then any number of the rest
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, widen
from rosward.domain.compound import Native
from rosward.domain.state import State, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Ref, Unknown, Value
from rosward.engine.python import attributes, calls, contents
from rosward.engine.python.raised import may_catch
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.stepped import NEXT, Resumption, Stepped
from rosward.engine.throwing import rethrow
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

STEP: Final = {
    False: ("__iter__", "__next__", "StopIteration"),
    True: ("__aiter__", "__anext__", "StopAsyncIteration"),
}
_ITERATOR: Final = "iterator"


def made(machine: Engine, source: Value, *, asynchronous: bool = False) -> Value:
    """What `__iter__` of an object of the program gives; any other value itself."""
    if not isinstance(source, Ref) or machine.obj(source).kind != "instance":
        return source
    method = attributes.method(machine, source, STEP[asynchronous][0])
    held = contents.iterated(machine, source, method)
    if held is not None:
        return held
    return source if method is None else calls.call(machine, method, (), {})


def steps(machine: Engine, source: Value, *, asynchronous: bool = False) -> bool:
    """Whether a value is followed step by step: a generator, an object with `__next__`, or one of several values among which there is one."""
    if isinstance(source, Choice):
        return any(steps(machine, o, asynchronous=asynchronous) for o in source.options)
    if not isinstance(source, Ref):
        return False
    kind = machine.obj(source).kind
    if kind == "generator":
        return True
    return kind == "instance" and attributes.method(machine, source, STEP[asynchronous][1]) is not None


def is_followed(machine: Engine, value: Value) -> bool:
    """Whether iterating over a value runs code of the program, item by item."""
    if isinstance(value, Choice):
        return any(is_followed(machine, o) for o in value.options)
    if not isinstance(value, Ref):
        return False
    record = machine.obj(value)
    if record.kind == "instance" and isinstance(record.cls, Class) and attributes.method(machine, value, "__iter__"):
        return not record.cls.stub or steps(machine, value)
    return steps(machine, value)


def iterator_of(machine: Engine, source: Value, *, asynchronous: bool = False) -> Value:
    """What a loop advances: of several values, those that are no iterators become such."""
    if not isinstance(source, Choice):
        return source
    sources = [o for o in source.options if o != NONE]
    ready = [made(machine, o, asynchronous=asynchronous) for o in sources]
    return join_all(
        o if steps(machine, o, asynchronous=asynchronous) else calls.call(machine, Native("builtins.iter"), (o,), {})
        for o in ready
    )


def step(machine: Engine, iterator: Value, action: Resumption = NEXT, *, asynchronous: bool = False) -> Stepped:
    """Advance an iterator."""
    if isinstance(iterator, Choice):
        return _step_each(machine, iterator, action, asynchronous=asynchronous)
    if isinstance(iterator, Ref):
        record = machine.obj(iterator)
        if record.kind == "generator":
            return machine.advance(iterator, action)
        if record.kind == "instance":
            return _step_object(machine, iterator, action, asynchronous=asynchronous)
        if record.payload == _ITERATOR and record.items is not None and not record.many:
            if not record.items:
                return Stepped(UNBOUND, machine.state.copy())
            machine.update(iterator, record.replace(items=record.items[1:]))
            return Stepped(record.items[0])
    known, rest = machine.iterate(iterator)
    item = join_all((*known, *(() if rest is None else (rest,))))
    return Stepped(item, machine.state.copy())


def _step_each(machine: Engine, iterators: Choice, action: Resumption, *, asynchronous: bool) -> Stepped:
    """One of several iterators, each from the same state."""
    before = machine.state
    after: State | None = None
    item: Value = UNBOUND
    ended: State | None = None
    value: Value = UNBOUND
    for iterator in iterators.options:
        machine.state = before.copy()
        one = step(machine, iterator, action, asynchronous=asynchronous)
        if one.item is not UNBOUND:
            item = join(item, one.item)
            after = machine.state if after is None else join_states(after, machine.state, machine.fresh_version)
        if one.ended is not None:
            value = join(value, one.value)
            ended = one.ended if ended is None else join_states(ended, one.ended, machine.fresh_version)
    if after is not None:
        machine.state = after
    return Stepped(item, ended, value)


_METHODS: Final = {"send": "send", "throw": "throw", "close": "close"}


def _step_object(machine: Engine, iterator: Ref, action: Resumption, *, asynchronous: bool) -> Stepped:
    """`__next__` of an object of the program (or `send`, `throw`), and the StopIteration that it raises."""
    _, name, stop = STEP[asynchronous]
    frame = machine.frames[-1]
    outer, catcher = machine.catchers, Catcher(machine, frame)
    machine.catchers = [*outer, catcher]
    plain = action.kind == "next" or (action.kind == "send" and action.value == NONE)
    try:
        item = machine.call_method(iterator, name if plain else _METHODS[action.kind], () if plain else (action.value,))
        if asynchronous and item is not UNBOUND:
            item = machine.wait_for(item)
    finally:
        machine.catchers = outer
    wanted = Native(f"builtins.{stop}")
    ended: State | None = None
    value: Value = UNBOUND
    others = Catcher(machine, frame)
    for exception, snapshot in catcher.arrivals.items():
        caught = may_catch(machine, exception, wanted)
        if caught is not False:
            state = snapshot.state.copy()
            ended = state if ended is None else join_states(ended, state, machine.fresh_version)
            value = join(value, stop_value(machine, exception, state))
        if caught is not True:
            others.arrive(machine, exception, snapshot.state)
    if outer and catcher.level:
        outer[-1].take_over(machine, catcher)
    rethrow(machine, others)
    return Stepped(item, ended, value)


def stop_value(machine: Engine, exception: Value, state: State) -> Value:
    """The `value` of a StopIteration that was raised in a state."""
    here, machine.state = machine.state, state
    value = machine.load_attr(exception, "value") if isinstance(exception, Ref) else NONE
    machine.state = here
    return value


def next_of(
    machine: Engine,
    iterator: Value,
    action: Resumption = NEXT,
    default: Value | None = None,
    *,
    asynchronous: bool = False,
) -> Value:
    """`next(iterator)` as the program sees it: the item, or the default; else StopIteration is raised where the iterator is at its end."""
    item, ended, value = step(machine, iterator, action, asynchronous=asynchronous)
    if ended is None:
        return item
    if default is not None:
        machine.state = ended if item is UNBOUND else join_states(machine.state, ended, machine.fresh_version)
        return join(item, default)
    after, machine.state = machine.state, ended
    stop = machine.call_native(f"builtins.{STEP[asynchronous][2]}", () if value == NONE else (value,))
    machine.throw(stop)
    if item is not UNBOUND:
        machine.state = after
    return item


def drain(machine: Engine, iterator: Value, *, asynchronous: bool = False) -> tuple[Items, Value]:
    """All that an iterator gives, where no loop of the program asks for it (`list(words)`); and what it returns at its end.

    Leaves the machine in a state that covers each end; the value is UNBOUND where it never ends.
    """
    frame = machine.frames[-1]
    context = frame.context
    known: list[Value] = []
    most = machine.budget.unroll_while if not is_generator(machine, iterator) else machine.budget.unroll
    try:
        while len(known) < most and not machine.precision.coarse:
            frame.context = machine.context(context, frame.code.key, frame.op.number, "next", len(known))
            before = machine.state.copy()
            item, ended, value = step(machine, iterator, asynchronous=asynchronous)
            if item is UNBOUND:
                machine.state = before if ended is None else ended
                return Items(tuple(known)), UNBOUND if ended is None else value
            if ended is not None or (item.__class__ is Unknown and not is_generator(machine, iterator)):
                machine.state = before
                break
            known.append(item)
            if machine.state.version == before.version:
                break
            machine.check_time()
        frame.context = machine.context(context, frame.code.key, frame.op.number, "next", "*")
        rest, value = _drain_rest(machine, iterator, asynchronous=asynchronous)
        return Items(tuple(known), None if rest is UNBOUND else rest), value
    finally:
        frame.context = context


def is_generator(machine: Engine, iterator: Value) -> bool:
    """Whether an iterator is a generator."""
    return isinstance(iterator, Ref) and machine.obj(iterator).kind == "generator"


def _drain_rest(machine: Engine, iterator: Value, *, asynchronous: bool) -> tuple[Value, Value]:
    """Any number of further items, joined, and what is returned; leaves the machine in a state that covers each end."""
    reason = Reason(Cause.LOOP, "", machine.place)

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    rest: Value = UNBOUND
    value: Value = UNBOUND
    end: State | None = None
    head = machine.state.copy()
    for number in range(machine.budget.fixpoint * 4):
        machine.state = head.copy()
        item, ended, returned = step(machine, iterator, asynchronous=asynchronous)
        seen = (head.version, rest, value)
        if ended is not None:
            end, value = ended, join(value, returned)
        if item is UNBOUND:
            break
        merge = join if number < machine.budget.widen_after else widening
        rest = item if rest is UNBOUND else merge(rest, item)
        head = join_states(head, machine.state, machine.fresh_version, merge)
        if seen == (head.version, rest, value):
            break
    else:
        machine.report("RW201", "an iterator did not converge; what it does later may be missing")
    machine.state = head if end is None else end
    return rest, value
