# SPDX-License-Identifier: Apache-2.0
"""C++: the bodies that an operation runs, what is sent, which callbacks are registered.

number(front, 4);     the body of `number`, whose parameter is the slot of `front`
law->law(x);          the bodies of all classes that the object may have, each from the same state
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.domain.values import Function
from rosward.effects.sent import SentEffect
from rosward.engine.running.seen import Activation, Bound, Seen
from rosward.flow import library
from rosward.flow.body import Body
from rosward.flow.calls import KINDS, send
from rosward.flow.cpp.values import (
    nameless,
    objects,
    slots,
    value,
)
from rosward.flow.marks import NOTHING, Mark, Root, demoted, is_slot
from rosward.flow.ways import Way, each_way, either, joined_marks
from rosward.models.cpp.values.typed import Declared

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def named(function: Function) -> str:
    """The dotted name of a function."""
    scope = function.module.name.replace("::", ".")
    return f"{scope}.{function.code.name}" if scope else function.code.name


def callees(
    walker: Walker,
    body: Body,
    seen: Seen,
    everything: Mark,
    *,
    registers: dict[int, Mark] | None = None,
    pc: int = 0,
    certain: bool = False,
    only: Callable[[Bound], bool] | None = None,
    done: set[object] | None = None,
    arrived: frozenset[Root] = frozenset(),
) -> Mark | None:
    """Walk through the bodies that an operation runs, in their order; what they return, None where it runs none.

    Functions of one name are alternatives. `certain`: each of the others surely runs. `only` and `done`: some of them now, the rest later.
    `arrived`: what stands in these objects is all that is known of them.
    """
    waiting = walker.bodies_of(seen)
    groups: dict[object, list[tuple[str, list[Bound]]]] = {}
    by_code: dict[str, list[Bound]] = {}
    for key, bound in seen.bound.items():
        if done is not None and key in done:
            continue
        if only is not None and not only(bound):
            continue
        if done is not None:
            done.add(key)
        by_code.setdefault(bound.function.code.key, []).append(bound)
    for code_key, several in by_code.items():
        name: object = "" if seen.several else several[0].function.code.name
        groups.setdefault(name, []).append((code_key, several))
    steps: list[list[Way]] = []
    inside = body.pc | pc
    if only is None:
        bound_keys = {b.function.code.key for b in seen.bound.values()}
        for key, activations in waiting.items():
            if key not in bound_keys:
                steps.append([partial(_thunk, walker, a, everything, inside) for a in activations])
    known = registers if registers is not None else dict(enumerate(body.registers))
    for group in groups.values():
        ways: list[Way] = []
        for code_key, several in group:
            ways += _ways(walker, body, seen, several, waiting.get(code_key, ()), known, everything, inside, arrived)
        steps.append(ways)
    result: Mark | None = None
    for ways in steps:
        before = walker.memory.copy() if len(steps) > 1 and not certain else None
        result = either(result, each_way(walker, ways) or NOTHING)
        if before is not None:
            walker.memory.join(before)
    return result


def _ways(
    walker: Walker,
    body: Body,
    seen: Seen,
    several: list[Bound],
    activations: Iterable[Activation],
    known: dict[int, Mark],
    everything: Mark,
    pc: int,
    arrived: frozenset[Root],
) -> list[Way]:
    marks = [given_to(walker, bound, known, everything, pc, arrived) for bound in several]
    function = several[0].function
    mine = list(activations)
    found: list[Way] = []
    if not mine and function.code.file.startswith("models:") and (function.code.is_stub or not function.code.ops):
        found.append(partial(_declared, walker, body, function, joined_marks(marks)))
    for number, activation in enumerate(mine):
        given = marks[number] if len(marks) == len(mine) else joined_marks(marks)
        found.append(partial(_enter, walker, seen, activation, function, given, pc))
    return found


def _enter(walker: Walker, seen: Seen, activation: Activation, function: Function, given: list[Mark], pc: int) -> Mark:
    """Through a body; where its parameters lead was seen when it began."""
    marks = []
    _declared_by_type(walker, seen, function, given)
    for number, places in enumerate(activation.begun):
        mark = given[number] if number < len(given) else Mark(pc)
        marks.append(Mark(mark.mask, frozenset(places) | nameless(mark) if places or not mark.roots else mark.roots))
    result = walker.enter(activation, marks, pc)
    if function.code.file.startswith("models:"):
        result = result.under(_effects(walker, function, given, pc))
        result = _held(walker, function, given, result)
    return result


def _declared_by_type(walker: Walker, seen: Seen, function: Function, given: list[Mark]) -> None:
    """What stands for an argument of which only the type is known holds all that the argument is made of."""
    made = [(address, site) for address, site in seen.made.items() if site.__class__ is Declared]
    signature = function.code.signature
    if not made or signature is None:
        return
    first = signature.leading + len(signature.template)
    for number, parameter in enumerate(signature.parameters, first):
        mine = [address for address, site in made if site.what == (function.code.key, parameter.name)]
        if mine and number < len(given):
            walker.memory.write_any(mine, Mark(walker.memory.deep(value(walker, given[number]))))


def _held(walker: Walker, function: Function, given: list[Mark], result: Mark) -> Mark:
    """A model leaves out what a value of the library is made of: it is in it all the same."""
    name, nodes = named(function), walker.shape.nodes
    makes = function.code.name == function.module.name.rpartition(".")[2]
    if not makes and not walker.shape.said(name).holds:
        return result
    mask = 0
    for mark in given[1:] if makes else given:
        held = value(walker, mark)
        mask |= walker.memory.deep(Mark(held.mask, held.roots - nodes))
    if makes:
        walker.memory.write_any([r for r in given[0].roots if r not in nodes], Mark(mask))
        return result
    walker.memory.write_any([r for r in result.roots if r not in nodes], Mark(mask))
    return result.under(mask)


def _effects(walker: Walker, function: Function, given: list[Mark], pc: int) -> int:
    """What marks say of a function of a library."""
    name = named(function)
    said = walker.shape.said(name)
    for root in given[0].roots if said.stops and given else ():
        library.stop(walker, root, pc | demoted(given[0].mask))
    if not (said.sinks or said.sources or said.changes):
        return 0
    mask = pc
    for mark in given[function.code.parameters.names[:1] == ("this",) :]:
        mask |= walker.memory.deep(value(walker, mark))
    brought = library.perform(walker, name, mask, pc)
    library.fails(walker, name, mask | brought)
    for parameter, mark in zip(function.code.parameters.names, given, strict=False):
        if ("self" if parameter == "this" else parameter) in said.changes or "*" in said.changes:
            walker.memory.write_any(mark.roots, Mark(mask | brought), mask)
    return brought


def defaults(walker: Walker, seen: Seen, everything: Mark, pc: int, but: Collection[object]) -> None:
    """The first values of the fields that nothing is written for, some of which read others."""
    bound = {b.function.code.key for b in seen.bound.values()}
    for key, activations in walker.bodies_of(seen).items():
        for activation in () if key in bound else activations:
            if activation.code.parameters.names[:1] == ("this",) and activation.code.name not in but:
                _thunk(walker, activation, everything, pc)


def _thunk(walker: Walker, activation: Activation, everything: Mark, pc: int) -> Mark:
    """A body that nothing calls with arguments: the first value of a field stands in it afterwards, a type is a type."""
    named_so = activation.code.parameters.names[:1] == ("this",)
    places = [frozenset(p) for p in activation.begun]
    if activation.code.kind.value == "function" and not named_so and not places:
        return walker.enter(activation, [], pc)
    lost = not named_so and any(places)
    marks = [Mark(pc | (walker.memory.deep(everything) if lost else 0), p) for p in places]
    result = walker.enter(activation, marks, pc)
    if named_so and places:
        for root in places[0]:
            found = value(walker, result)  # of a pointer, what it leads to stays
            mark = Mark(found.mask, found.roots | slots(result))
            walker.memory.write(frozenset((root,)), activation.code.name, mark)
        return Mark(pc)
    return result


def _declared(walker: Walker, body: Body, function: Function, marks: list[Mark]) -> Mark:
    """A function of which a model says only that it is there."""
    mask, nodes = body.pc, walker.shape.nodes
    for number, mark in enumerate(marks):
        roots = frozenset(r for r in mark.roots if r not in nodes) if number == 0 else mark.roots
        mask |= walker.memory.deep(Mark(mark.mask, roots))
    return Mark(mask | _effects(walker, function, marks, body.pc))


def given_to(
    walker: Walker,
    bound: Bound,
    known: dict[int, Mark],
    everything: Mark,
    pc: int,
    arrived: frozenset[Root] = frozenset(),
) -> list[Mark]:
    """What is in the parameters of a call."""
    marks = []
    captured: Root = ("captured", bound.function.code.key)
    signature = bound.function.code.signature
    leading = 0 if signature is None else signature.leading
    for number, given in enumerate(bound.given):
        mark = Mark(pc, frozenset(given.places))
        for register in given.registers:
            found = known.get(register, NOTHING)
            mark = (
                mark.under(found.mask) if given.kind == "place" else mark.joined(_passed(walker, found, given.places))
            )
        if not given.registers:
            kept = walker.memory.of(captured).slots.get(number)
            if number < leading and kept is not None:
                mark = mark.joined(Mark(kept.mask, nameless(kept)))
            elif given.kind == "value":
                mark = mark.joined(Mark(walker.memory.deep(everything), nameless(everything)))
            elif given.kind == "place" and number >= leading and not (given.places and given.places <= arrived):
                mark = mark.under(_shallow(walker, everything))
        marks.append(mark)
    return marks


def _passed(walker: Walker, mark: Mark, places: frozenset[Root]) -> Mark:
    """An argument that is more than a place: a slot stays one where the parameter is a reference."""
    if any(is_slot(p) for p in places):
        return Mark(mark.mask, nameless(mark) | slots(mark))
    held = value(walker, mark)
    return Mark(held.mask, nameless(held) | (slots(mark) if not places else frozenset()))


def _shallow(walker: Walker, mark: Mark) -> int:
    return value(walker, mark).mask


def sends(walker: Walker, body: Body, seen: Seen, marks: list[Mark]) -> None:
    """`rosward::send(kind, node, name, type, message)`."""
    for _, effect in seen.effects:
        if isinstance(effect, SentEffect):
            mask = body.pc
            if marks:
                mask |= walker.memory.deep(value(walker, marks[-1]))
            if len(marks) > 2:
                mask |= demoted(value(walker, marks[2]).mask)
            send(walker, effect, mask)


def register(walker: Walker, body: Body, seen: Seen, everything: Mark) -> None:
    """Callbacks that are registered here run only where control is here; what they are bound to is at hand here."""
    for _, entry in seen.scheduled:
        given = _shallow(walker, everything) | (0 if entry.event in KINDS_APART else walker.memory.deep(everything))
        walker.register(entry, body.pc, given)


KINDS_APART: Final = frozenset({"message", "service", "timer", "goal", "execute", "accepted", "cancel", *KINDS})


def begin(walker: Walker, activation: Activation, arguments: list[Mark], given: int, pc: int) -> Mark:
    """A callback is called: what arrives, what it is bound to, what else it may be given depends on `given`."""
    body = Body(activation, [], pc)
    seen = activation.of(0)
    walker.bodies.append(body)
    try:
        everything = Mark(given)
        for mark in arguments:
            everything = everything.joined(Mark(mark.mask, frozenset(r for r in mark.roots if not isinstance(r, int))))
        arrived = frozenset[Root]().union(*map(objects, arguments))
        result = callees(walker, body, seen, everything, arrived=arrived)
        return NOTHING if result is None else result.under(pc)
    finally:
        walker.bodies.pop()
