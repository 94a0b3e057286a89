# SPDX-License-Identifier: Apache-2.0
"""Calls: the bodies that an operation runs, with what is handed to each parameter; natives; and code that nobody knows.

f(a, b)              the body of f, with the marks of a and b
lib.blur(image)      may hold all that the image does, may be a view of it, and may have written to it
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod
from rosward.domain.values import Class, Function, Value
from rosward.effects.flows import Sink
from rosward.effects.sent import SentEffect
from rosward.engine.arguments import MAYBE
from rosward.engine.running.seen import Activation, Seen, refs_of
from rosward.engine.unknown.escape import BY_LIBRARY
from rosward.flow import implicit, library
from rosward.flow.body import Attempt, Body, Point
from rosward.flow.bound import NO_SPREAD, Spread, all_bound, handed
from rosward.flow.failing import may_fail
from rosward.flow.marks import NOTHING, Mark, Root, demoted, name_of
from rosward.flow.native import natives
from rosward.flow.native.constructed import construct
from rosward.flow.native.partials import bound_in
from rosward.flow.reading import arising, leads, owners_of
from rosward.flow.released import released
from rosward.flow.site import callees, is_native
from rosward.flow.stored.content import Content
from rosward.flow.ways import Way, each_way, either, joined_marks
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


# Bodies


def run_callees(
    walker: Walker,
    op: ops.Op,
    body: Body,
    seen: Seen,
    names: tuple[str, ...] = (),
    pc: int = 0,
    told: Mark = NOTHING,
    others: Mark = NOTHING,
) -> Mark | None:
    """Walk through the bodies that an operation runs; what they return, None where it runs none.

    `names`: those of that name only; `told`: what stands in no register and each of their arguments behind the receiver may be; `others`: what
    any of those that stand in none may be, too.
    """
    if not (seen.callees or seen.summaries or seen.calls or seen.performed):
        return None
    waiting = walker.bodies_of(seen)
    spread = _spread(walker, op, body, seen) if isinstance(op, ops.Call) and op.spreads and not names else NO_SPREAD
    if others is not NOTHING:
        spread = spread._replace(elements=spread.elements.joined(others))
    result = _performed(walker, op, body, seen, spread) if seen.performed and not names else None
    inside = body.pc | pc
    ways: list[Way] = []
    called_here: set[str] = set(spread.ran)
    for key, apart in walker.sites.by_code(seen).items():
        several = apart
        function = several[0].function
        code = function.code
        if (names and code.name not in names) or key in spread.ran:
            continue
        mine = waiting.get(key, ())
        if len(several) > 1 and len(several) != len(mine):  # nobody tells them apart
            several = walker.sites.together(seen, key)
        marks = all_bound(walker, op, body, several, spread)
        if told != NOTHING:
            marks = [[*m[:1], *(each.joined(told) for each in m[1:])] for m in marks]
        whole = marks[0] if len(marks) == 1 else joined_marks(marks)
        if (code.is_generator or code.is_coroutine) and not code.is_stub:
            keep_arguments(walker, key, whole)
            made = Mark(inside, frozenset((("generator", key),)))
            result = made if result is None else result.joined(made)
            continue
        called_here.add(key)
        name = f"{function.module.name}.{code.qualname}"
        if code.file.startswith("models:") and not code.is_stub:
            result = _perform(walker, body, name, whole, result)
        if walker.hurries and walker.shape.said(name).pure and walker.sites.only_compute(mine, walker.shape.said):
            whole = implicit.under_given(walker, name, whole, unseen=True, but=walker.shape.nodes)
            computed = library.computed(walker, body, name, whole)
            result = computed if result is None else result.joined(computed)
            continue
        if not mine and code.is_stub:
            whole = implicit.under_given(walker, name, whole, unseen=True, but=walker.shape.nodes)
            declared = natives.by_name(walker, op, body, seen, name, whole)
            declared = library.declared(walker, body, function, whole) if declared is None else declared
            library.fails(walker, name, declared.mask)
            result = declared if result is None else result.joined(declared)
        for number, activation in enumerate(mine):
            given = marks[number] if len(marks) == len(mine) else whole
            ways.append(partial(walker.enter, activation, given, inside))
    for key, activations in waiting.items():
        if key not in called_here and (not names or activations[0].code.name in names):
            ways += [partial(resume, walker, op, body, a, inside) for a in activations]
    return either(result, each_way(walker, ways))


_ENDING: Final = frozenset(("__next__", "__getitem__", "__anext__"))
"""Methods that end a loop by an exception."""


def run_to_the_end(walker: Walker, op: ops.Op, body: Body, seen: Seen, pc: int = 0) -> tuple[Mark | None, int]:
    """The same where methods may give elements, or what gives them: what they return, and what decides that there is a further one."""
    if not any(a.code.name in _ENDING for a in seen.callees):
        given = run_callees(walker, op, body, seen, pc=pc)
        return given, 0 if given is None else given.mask
    tried = Attempt(body, Point(body.registers, walker.memory))
    walker.attempts.append(tried)
    try:
        given = run_callees(walker, op, body, seen, pc=pc)
    finally:
        walker.attempts.pop()
        tried.end(walker.memory)
    if walker.attempts:
        walker.attempts[-1].contains(tried)
    if tried.raised is not NOTHING:  # what was written before it ended stands there behind it
        walker.memory.join(tried.point.memory)
    return given, tried.mask


def _performed(walker: Walker, op: ops.Op, body: Body, seen: Seen, spread: Spread) -> Mark:
    """The natives that an operation runs but does not call as it is written."""
    result = NOTHING
    for native in seen.performed.values():
        marks = [handed(walker, op, body, h, spread).under(spread.size) for h in native.args]
        named = {
            n.removeprefix(MAYBE): handed(walker, op, body, h, spread).under(spread.size) for n, h in native.keywords
        }
        result = result.joined(natives.perform(walker, op, body, seen, native, marks, named))
    if walker.attempts and may_fail(op, seen):
        walker.attempts[-1].mask |= result.mask
    return result


def _perform(walker: Walker, body: Body, name: str, marks: list[Mark], result: Mark | None) -> Mark | None:
    """What is known by its name of a function that a model has as code."""
    said = walker.shape.said(name)
    if not (said.sinks or said.sources):
        return result
    mask = 0
    for mark in marks:
        mask |= walker.memory.deep(mark)
    given = Mark(library.perform(walker, name, mask, body.pc))
    library.fails(walker, name, mask | given.mask)
    return given if result is None else result.joined(given)


def keep_arguments(walker: Walker, key: str, marks: list[Mark]) -> None:
    """A generator or coroutine is made: it runs with these, when somebody advances it."""
    root: Root = ("arguments", key)
    for number, mark in enumerate(marks):
        old = walker.memory.of(root).slots.get(number, NOTHING)
        walker.memory.write(frozenset((root,)), number, old.joined(mark))


def resume(walker: Walker, op: ops.Op, body: Body, activation: Activation, pc: int) -> Mark:
    """A body that is run by something else than a call with arguments that are seen."""
    code = activation.code
    if code.is_generator or code.is_coroutine:
        return walker.advance(activation, pc)
    everything = Mark(pc)
    for register in walker.sites.reads(op):
        mark = body.registers[register]
        everything = everything.joined(Mark(walker.memory.deep(mark), mark.roots))
    return walker.enter(activation, [everything] * len(code.parameters.names), pc)


def _spread(walker: Walker, op: ops.Call, body: Body, seen: Seen) -> Spread:
    """The same of one call."""
    size = 0
    for argument in op.arguments:
        if argument.is_spread:
            mark = body.registers[argument.register]
            size |= mark.mask | walker.memory.size(mark.roots)
    called = {f.code.key for f in callees(seen.functions) if isinstance(f, Function)}
    asked = {
        key: several[0].function.code.name
        for key, several in walker.sites.by_code(seen).items()
        if several[0].function.code.name in implicit.ELEMENTS and key not in called
    }
    if not asked:
        return Spread(size)
    given = run_callees(walker, op, body, seen, tuple(asked.values())) or NOTHING
    found = implicit.gone_through(walker, given)
    receivers = frozenset(r for f in seen.functions if isinstance(f, BoundMethod) for r in refs_of(f.receiver))
    return Spread(size | found.mask, found, frozenset(asked), receivers)


# Calls as they are written


def call(walker: Walker, op: ops.Call, body: Body, seen: Seen) -> None:
    """A call: of all that the function may be."""
    memory = walker.memory
    function = body.registers[op.func]
    registers = [a.register for a in op.arguments]
    marks = [body.registers[r] for r in registers]
    pc = demoted(function.mask if seen.several else function.mask & walker.sources.assumed)
    _send(walker, op, body, seen, marks, body.pc | pc)
    site = walker.sites.of(op, seen)
    if site.creates:
        for root in seen.refs:
            memory.place(root, Content())
    construct(walker, op, body, seen, marks)
    if site.chooses:  # which functions run, and how often
        pc |= demoted(_deep(walker, marks))
    given, ended = run_to_the_end(walker, op, body, seen, pc)
    if given is not None and site.calls_back and (more := memory.deep(given) & ~_deep(walker, marks)):
        # What one function gave may be handed on to another.
        given = either(given, run_callees(walker, op, body, seen, pc=pc, others=Mark(more))) or given
    result = NOTHING if given is None else given
    for callee in site.callees:
        if is_native(callee):
            passed = implicit.with_elements(seen, marks, given, demoted(ended))
            computed = natives.apply(walker, op, body, seen, callee, passed)
            result = result.joined(computed)
            if walker.attempts and may_fail(op, seen):
                walker.attempts[-1].mask |= computed.mask
        elif isinstance(callee, Class):
            result = result.joined(Mark(body.pc, frozenset(seen.refs)))
    if site.unknown:
        function = Mark(function.mask, function.roots | site.methods)
        owner, *passed = implicit.under_given(walker, "", (Mark(0, owners_of(function)), *marks), unseen=True)
        computed = library.unknown(walker, op, body, function.under(owner.mask), passed, op.arguments)
        result = result.joined(computed)
        if walker.attempts:
            walker.attempts[-1].mask |= computed.mask
    roots = frozenset(map(walker.shape.owner, leads(seen, result))) | site.externals
    mask = result.mask | body.pc | pc | (0 if site.opens else arising(walker, seen))
    if seen.scheduled:
        mask |= _given_back(walker, seen, [*marks, function] if site.unknown else [], function)
    body.registers[op.dst] = released(walker, op, body, function, seen, Mark(mask, roots))
    owners = owners_of(function)
    if owners:
        walker.ask(owners)
        if seen.scheduled and site.unknown:
            walker.may_call(owners)
    waits = walker.threaded and (site.waits or site.pauses)
    if waits or site.spins:
        walker.leave()
    if waits or not all(walker.calling.isdisjoint(walker.shape.numbers.alike(owner)) for owner in owners):
        walker.meet_callbacks()
    if seen.scheduled:
        # Callbacks are told of what comes in here.
        given_on = [*marks, Mark(result.mask)] if site.of_library else marks
        schedule(walker, seen, given_on, body.pc | pc | _chosen(seen, marks), _hands(walker, function, seen))
    if site.spins or site.pauses:
        walker.join_beside()


def _deep(walker: Walker, marks: Iterable[Mark]) -> int:
    """All that these depend on, with what they lead to."""
    mask = 0
    for mark in marks:
        mask |= walker.memory.deep(mark)
    return mask


def _given_back(walker: Walker, seen: Seen, marks: Iterable[Mark], function: Mark) -> int:
    """What the functions return that are handed to a library here: it may keep that in its object, and in what it may write to."""
    mask = 0
    walker.ask(entry for _, entry in seen.scheduled)
    for _, entry in seen.scheduled:
        mask |= walker.returned.get(entry, 0)
    if mask:
        kept = set(owners_of(function))
        for each in seen.functions:
            if isinstance(each, BoundMethod):
                kept.update(refs_of(each.receiver))
        for mark in marks:
            kept |= mark.roots
        walker.memory.write_any(kept - walker.shape.nodes, Mark(mask), mask)
    return mask


def _send(walker: Walker, op: ops.Call, body: Body, seen: Seen, marks: list[Mark], pc: int) -> None:
    """What is sent here leaves the process."""
    for _, effect in seen.effects:
        if isinstance(effect, SentEffect):
            mask = pc | demoted(body.registers[op.func].mask)
            mask |= _deep(walker, (*marks, Mark(0, frozenset[Root](bound_in(body.registers[op.func])))))
            send(walker, effect, mask)


KINDS: Final = {"publication": "topic"}


def send(walker: Walker, effect: SentEffect, mask: int) -> None:
    """Record a sink of ROS."""
    walker.send(sink_of(effect), mask)


def sink_of(effect: SentEffect) -> Sink:
    """Where what is sent leaves the process."""
    node = next((a for a in _addresses(effect.node)), None)
    return Sink(KINDS.get(effect.kind, effect.kind), node, effect.name, effect.place)


def _addresses(value: Value) -> Iterable[int]:
    for option in options(value):
        address = getattr(option, "address", None)
        if address is not None:
            yield address


def schedule(walker: Walker, seen: Seen, marks: Iterable[Mark], pc: int, hands: tuple[str, ...] = ()) -> None:
    """Callbacks that are registered here run only where control is here, and may be given what is at hand."""
    for _, entry in seen.scheduled:
        if hands and entry.event == BY_LIBRARY:
            walker.handed[entry] = hands
        given, callback = 0, NOTHING
        for mark in marks:
            given |= walker.memory.deep(mark) if entry.event not in _ARRIVING else 0
            callback = callback.joined(Mark(mark.mask, bound_in(mark)))
        walker.register(entry, pc, given, callback)


def _chosen(seen: Seen, marks: Iterable[Mark]) -> int:
    """What decides which of several functions is registered here."""
    mask = 0
    if len({entry.callback for _, entry in seen.scheduled}) > 1:
        for mark in marks:
            mask |= mark.mask
    return demoted(mask)


def _hands(walker: Walker, function: Mark, seen: Seen) -> tuple[str, ...]:
    """The classes of what a function of a library calls a callback with."""
    names = [n for root in function.roots if (n := name_of(root))]
    names += [f"{f.module.name}.{f.code.qualname}" for f in callees(seen.functions) if isinstance(f, Function)]
    return next((hands for name in sorted(names) if (hands := walker.shape.said(name).hands)), ())


_ARRIVING: Final = frozenset({"message", "service", "timer", "goal", "execute", "accepted", "cancel", "future"})
