# SPDX-License-Identifier: Apache-2.0
"""What libraries do with what they get: where something leaves ROS, where something comes from outside, and who only computes.

socket.socket.sendto(data, …)     leaves into the network
time.time()                       comes from the clock
cv2.rectangle(image, …)           nobody knows: the image, and the result, may hold any of the arguments
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, function_behind
from rosward.domain.values import Function, Value
from rosward.engine.running.seen import refs_of
from rosward.flow import arrays, hidden
from rosward.flow.marks import NOTHING, Mark, Root, decided, demoted, name_of, of_library
from rosward.flow.outside import cleaned, comes_in, out
from rosward.flow.reading import each_of, of_classes, opaque, owners_of, part_of
from rosward.flow.site import WRITING
from rosward.models.flow_marks import NO_MARK, FlowMark

if TYPE_CHECKING:
    from rosward.flow.body import Body
    from rosward.flow.stored.memory import Memory
    from rosward.flow.walker import Walker
    from rosward.ir import ops


_KNOWN: Final = ("rclpy.", "tf2_ros.", "builtins.")
"""Their methods keep nothing of what they are given that they give back later, unless a model says so."""
_SEEDING: Final = frozenset(("random.seed", "random.setstate", "numpy.random.seed", "numpy.random.set_state"))
_SEEDED: Final[Root] = ("seeded",)
"""What decides which random numbers come."""
_AT_HAND: Final = frozenset(("argv", "clock", "env", "random"))
"""What comes from there is always there."""
OPENING: Final = frozenset(("open", "io.open", "asyncio.create_subprocess_exec", "asyncio.create_subprocess_shell"))
"""Natives that give a file or a program, of which marks say what its methods do."""
_FEW: Final = 12
"""So many objects the result of an unknown call is said to be itself; it leads to more."""


def perform(walker: Walker, name: str, mask: int, pc: int) -> int:
    """What marks say of a function: its sinks get the mask; the sources of its result."""
    said = walker.shape.said(name)
    for kind in said.sinks:
        out(walker, kind, mask | pc)
    if name in _SEEDING:
        walker.memory.write_any((_SEEDED,), Mark(mask | pc))
    hidden.keep(walker, name, mask | pc)
    given = 0
    for kind in said.sources:
        given |= comes_in(walker, kind)
        if kind == "random":
            given |= walker.memory.of(_SEEDED).whole.mask
    return given


def fails(walker: Walker, name: str, mask: int) -> None:
    """A function that brings something from outside may fail instead: that it does, depends on the same."""
    if walker.attempts and not _AT_HAND.issuperset(walker.shape.said(name).sources):
        walker.attempts[-1].mask |= mask


def may_be_missing(walker: Walker) -> None:
    """A file is opened, which may not be there."""
    if walker.attempts:
        walker.attempts[-1].mask |= comes_in(walker, "file")


def declared(walker: Walker, body: Body, function: Function, marks: list[Mark]) -> Mark:
    """A function of which a model says only that it is there: its result is computed from what it gets, which its object may keep.

    Where the model does not say what the result is, it may be a view of what the function gets.
    """
    name = f"{function.module.name}.{function.code.qualname}"
    mask = body.pc
    nodes = walker.shape.nodes
    for number, mark in enumerate(marks):
        roots = frozenset(r for r in mark.roots if r not in nodes) if number == 0 else mark.roots
        mask |= walker.memory.deep(Mark(mark.mask, roots))
    for root in marks[0].roots if marks else ():
        for each in walker.shape.numbers.alike(root):
            mask |= walker.stopped.get(each, 0)  # whether it goes on
    given = perform(walker, name, mask, body.pc)
    said = walker.shape.said(name)
    for parameter in said.stops:
        for root in _given_as(parameter, function, marks).roots:
            stop(walker, root, body.pc | demoted(marks[0].mask))
    if "." in function.code.qualname and marks and not said.is_known and not name.startswith(_KNOWN):
        walker.memory.write_any(marks[0].roots - nodes, Mark(mask))
    for parameter in said.changes:
        changed = _given_as(parameter, function, marks)
        walker.memory.write_any(changed.roots - nodes, Mark(mask | given), mask)
    if said.releases:
        cleaned(walker, name, mask)
        mask = body.pc
    root = walker.shape.made(body.activation, body.at.number, name)
    walker.memory.renew(root)
    led = hidden.led_to((name,))
    if function.code.returns is None and not name.startswith(_KNOWN):
        led |= _viewed(walker, frozenset[Root]().union(*(m.roots for m in marks)))
        if len(led) > _FEW:
            walker.memory.merge(opaque(Mark(0, led)))
            led = walker.shape.numbers.canonical(led)
    return Mark(mask | given, led | {root})


def expression(walker: Walker, body: Body, op: ops.Op, operands: Iterable[Mark]) -> Root:
    """What an operator makes of objects of a library: where nothing says that it only computes, it may hold them (`cvxpy.Variable() <= limit`)."""
    roots = {root for mark in operands for root in opaque(mark) if root[0] == "made"}
    held = {r: name for r in roots if (name := name_of(r)) and walker.shape.said(name) is NO_MARK}
    root = walker.shape.result(body.activation, op.number, held.values())
    walker.memory.renew(root)
    if held:
        walker.memory.write_any([root], Mark(0, frozenset(held)))
    return root


def _viewed(walker: Walker, roots: frozenset[Root]) -> frozenset[Root]:
    """Of these objects, a view: what is written to an element of it, stands in them."""
    roots -= walker.shape.nodes
    return roots | {("of", root, "") for root in roots if isinstance(root, int)}


def _given_as(parameter: str, function: Function, marks: list[Mark]) -> Mark:
    """What a parameter is given."""
    names = function.code.parameters.names
    number = names.index(parameter) if parameter in names else 0
    return marks[number] if number < len(marks) else NOTHING


def _keeps_nothing(said: FlowMark) -> bool:
    """Whether it is said of a function what it writes to, and that is not its object."""
    return (said.is_known or bool(said.changes)) and "self" not in said.changes


def _changed(
    memory: Memory, said: FlowMark, arguments: Sequence[ops.Argument], marks: Sequence[Mark]
) -> Iterator[Mark]:
    """What is given for the parameters to which a function writes, as marks say: by name, by place, or spread."""
    names, is_spread = said.parameters[said.parameters[:1] == ("self",) :], False
    for place, (argument, mark) in enumerate(zip(arguments, marks, strict=False)) if said.changes else ():
        is_spread = is_spread or argument.kind == "star"
        name = argument.name or (names[place] if place < len(names) else "")
        if argument.is_spread:
            yield Mark(0, memory.read_all(mark.roots).roots)
        elif name in said.changes or (is_spread and not argument.name):
            yield mark


def computed(walker: Walker, body: Body, name: str, marks: list[Mark]) -> Mark:
    """A function that only computes, taken as a whole: what it gives may be a view of what it is given; some write to their object."""
    mask = body.pc
    marks = [mark.joined(each_of(walker, mark) or NOTHING) for mark in marks]
    for mark in marks:
        mask |= walker.memory.deep(mark)
    roots = frozenset[Root]().union(*(m.roots for m in marks))
    if marks and walker.shape.said(name).changes:
        walker.memory.write_any(marks[0].roots, Mark(mask, roots - marks[0].roots), mask)
    root = walker.shape.made(body.activation, body.at.number, name)
    walker.memory.renew(root)
    if kept := frozenset(r for r in roots if isinstance(r, int)):
        walker.memory.write_any((root,), Mark(0, kept))
    if len(roots) > _FEW:
        walker.memory.merge(opaque(Mark(0, roots)))
        roots = walker.shape.numbers.canonical(roots)
    return Mark(mask, roots | {root})


def of_base(walker: Walker, root: Root, name: str) -> Mark:
    """What an object has of a base class that nobody knows, where marks say something of it: `self.rfile` of a handler of requests."""
    found, roots = 0, set[Root]()
    for base in walker.shape.unknown_bases(root):
        said = walker.shape.said(f"{base}.{name}")
        if said.is_known:
            roots.add(of_library(f"{base}.{name}"))
        for kind in said.sources:
            found |= comes_in(walker, kind)
    return Mark(found, frozenset(roots))


def attribute(walker: Walker, owners: Iterable[tuple[object, ...]], name: str) -> Mark:
    """What objects of libraries have under a name, and what comes in where it is read, as marks say: `button.is_pressed`."""
    found, roots = 0, set[Root]()
    for owner in owners:
        part = of_library(f"{owner[1]}.{name}") if owner[0] == "external" else part_of(owner, name)
        dotted = name_of(part)
        if dotted and not walker.shape.tells(dotted):
            part, dotted = owner, ""
        roots.add(part)
        said = walker.shape.said(dotted) if dotted else NO_MARK
        for kind in said.sources if said.attribute else ():
            found |= comes_in(walker, kind)
    return Mark(found, frozenset(roots))


def operator(walker: Walker, owner: Mark, method: str, given: Mark, pc: int) -> int:
    """What marks say of a method of objects of libraries that an operation calls: `shelf[key]`, `shelf[key] = given`."""
    found = 0
    for dotted in {d for root in owner.roots if root.__class__ is tuple and (d := name_of(root))}:
        name = f"{dotted}.{method}"
        if walker.shape.tells(name):  # a mark of the whole module is one of its functions
            found |= perform(walker, name, walker.memory.deep(given), pc)
    return found


def brought_to(walker: Walker, callback: Value) -> int:
    """What comes in where a base class that nobody knows calls a method of the program, as marks say: `def on_message(self, …)` of a client."""
    function, found = function_behind(callback), 0
    if isinstance(callback, BoundMethod) and function is not None:
        for address in refs_of(callback.receiver):
            found |= of_base(walker, address, function.code.name).mask
    return found


def put_there(walker: Walker, owner: Mark, name: str, function: Mark, pc: int) -> tuple[tuple[Mark], int]:
    """A function that is put into an object of a library, and what decides that it runs: `client.on_message = f` is called with what comes
    in, and where something does, as marks say."""
    found = 0
    for dotted in {d for root in owner.roots if (d := name_of(root))}:
        for kind in walker.shape.said(f"{dotted}.{name}").sources:
            found |= comes_in(walker, kind)
    return (function.under(found),), pc | decided(found)


def stop(walker: Walker, root: Root, mask: int) -> None:
    """A timer or subscription is stopped or started here: its callback runs only where this decides so."""
    for each in walker.shape.numbers.alike(root):
        old = walker.stopped.get(each, 0)
        if old | mask != old:
            walker.stopped[each] = old | mask
            walker.tell((each,))


def unknown(
    walker: Walker, op: ops.Op, body: Body, function: Mark, marks: list[Mark], arguments: Sequence[ops.Argument]
) -> Mark:
    """Code that is not known, unless its name is: it may write to all that it can reach, and give any of it."""
    names = sorted({n for r in function.roots if (n := name_of(r))})
    marks = [mark.joined(each_of(walker, mark) or NOTHING) for mark in marks]  # it may go through generators
    everything = [*marks, Mark(function.mask, owners_of(function))]
    mask = body.pc | of_classes(walker, everything)
    for mark in everything:
        mask |= walker.memory.deep(mark)
    given = 0
    for name in names:
        given |= perform(walker, name, mask, body.pc)
    root = walker.shape.result(body.activation, op.number, names)
    walker.memory.renew(root)
    known = [walker.shape.said(n) for n in names]
    written = [*arrays.changed(arguments, names, marks, everything[-1])]
    for said in known:
        written += _changed(walker.memory, said, arguments, marks)
    for each in written:
        arrays.write(walker.memory, each, mask | given)
    if known and all(said.releases for said in known):
        cleaned(walker, names[0], mask)
        return Mark(body.pc | given, frozenset((root,)))
    changing = any(isinstance(root[1], int) and root[2] in WRITING for root in opaque(function) if root[0] == "of")
    if known and not changing and all(map(_keeps_nothing, known)):
        return Mark(mask | given, arrays.viewed(names, everything) | {root})
    reached: set[Root] = set()
    for mark in everything:
        reached.update(walker.memory.reached(mark))
    led = hidden.led_to(names)
    walker.memory.write_any(reached, Mark(mask | given, led), mask)
    behind = led.union(*(m.roots for m in everything))
    kept = frozenset(r for r in behind if isinstance(r, int)) - walker.shape.nodes
    behind |= _viewed(walker, kept)
    if kept:  # an object of a library may keep what it is given
        walker.memory.write_any(owners_of(function), Mark(0, kept))
    if len(reached) > walker.shape.few:  # it may have written each into each
        walker.memory.merge(reached)
    if len(behind) > _FEW:
        walker.memory.merge(opaque(Mark(0, behind)))
        behind = walker.shape.numbers.canonical(behind)
    return Mark(mask | given, behind | {root})
