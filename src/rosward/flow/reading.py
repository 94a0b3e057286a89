# SPDX-License-Identifier: Apache-2.0
"""What is read: the elements of a value, the key of a slot, the sources that the interpretation names."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.unknown import Cause
from rosward.effects.flows import Source
from rosward.flow.marks import NOTHING, Mark, Root, name_of
from rosward.flow.outside import comes_in
from rosward.flow.ways import each_way

if TYPE_CHECKING:
    from rosward.domain.unknown import Reason
    from rosward.engine.running.seen import Seen
    from rosward.flow.walker import Walker


_NO_ROOTS: Final = frozenset[Any]()


def opaque(mark: Mark) -> frozenset[tuple[object, ...]]:
    """The objects of a mark that have no address."""
    roots = mark.roots
    return frozenset([r for r in roots if r.__class__ is not int]) if roots else _NO_ROOTS  # type: ignore[misc]


def leads(seen: Seen, mark: Mark) -> frozenset[Root]:
    """Where a result leads: to the objects that it was seen to be; where nobody knows what it is, to any that flows there."""
    refs: frozenset[Root] = frozenset(seen.refs) if seen.refs else _NO_ROOTS
    if not mark.roots:
        return refs
    further = mark.roots if seen.opaque else opaque(mark)
    return refs | further if refs else further


def owners_of(mark: Mark) -> frozenset[Root]:
    """The objects without address that a method belongs to: whose attribute it is, or which its attributes are not told apart from."""
    found: set[Root] = set()
    for root in mark.roots:
        if not isinstance(root, int) and root[0] == "of":
            owner = root[1]
            assert isinstance(owner, (int, tuple))
            found.add(owner)
        elif not isinstance(root, int) and root[0] != "external":
            found.add(root)
    return frozenset(found)


def of_classes(walker: Walker, marks: Iterable[Mark]) -> int:
    """What the classes hold of the objects that these lead to: whoever asks an object for an attribute may find it there."""
    memory, found = walker.memory, 0
    work, done = [mark for mark in marks if mark.roots], set[int]()
    for mark in work:
        for cls in walker.shape.classes_of(memory.reached(mark)):
            if cls not in done:
                done.add(cls)
                whole = memory.of(cls).whole
                found |= whole.mask
                if whole.roots:
                    found |= memory.deep(whole)
                    work.append(whole)
    return found


def elements(walker: Walker, mark: Mark) -> Mark:
    """What iterating over a value gives; of an iterator, it is used up."""
    found = NOTHING
    used = [r for r in mark.roots if walker.shape.is_iterator(r)]
    if used:
        walker.memory.take_out(used, walker.bodies[-1].pc)
    found = found.joined(each_of(walker, mark) or NOTHING)
    found = found.joined(walker.memory.read_all(mark.roots))
    if others := opaque(mark):
        found = found.joined(Mark(_brought(walker, others), frozenset(r for r in others if r[0] != "tuple")))
    return found.under(mark.mask)


def truth(walker: Walker, mark: Mark) -> int:
    """What the truth of a value depends on: the value, and how much there is in it. Of an object of a class, its methods say it (`__len__`)."""
    kind = walker.shape.kind
    held = [r for r in mark.roots if r.__class__ is not int or kind(r) != "instance"]
    return mark.mask | walker.memory.size(held) if held else mark.mask


_ITERATORS: Final = ("__iter__", "__aiter__")


def _brought(walker: Walker, roots: Iterable[Root]) -> int:
    """What comes in where somebody goes through objects of libraries, as marks say: `for line in serial_port`."""
    mask = 0
    for name in {name for root in roots if (name := name_of(root))}:
        for kind in (kind for each in _ITERATORS for kind in walker.shape.said(f"{name}.{each}").sources):
            mask |= comes_in(walker, kind)
    return mask


def each_of(walker: Walker, mark: Mark) -> Mark | None:
    """Run the generators, or coroutines, of which a value is one: what each yields and returns."""
    several = sorted(str(root[1]) for root in mark.roots if not isinstance(root, int) and root[0] == "generator")
    return each_way(walker, [partial(run, walker, ("generator", key), mark.mask) for key in several])


def run(walker: Walker, root: Root, pc: int) -> Mark:
    """Run a generator or coroutine: what it yields and returns."""
    result = NOTHING
    assert not isinstance(root, int)
    for activation in walker.watch.bodies.get(str(root[1]), ())[:1]:
        result = walker.advance(activation, pc | walker.bodies[-1].pc)
    return result


_DEEPEST: Final = 3


def part_of(root: Root, name: str) -> Root:
    """An attribute of something that has no address: of what is named, or arrives, it is told apart; else it is a part of the whole."""
    depth, inner = 0, root
    while not isinstance(inner, int) and inner[0] == "of":
        if inner[2] == name:  # a list of lists, or the like: all of them are one
            return inner
        depth, inner = depth + 1, inner[1]  # type: ignore[assignment]  # a root
    if depth >= _DEEPEST or isinstance(inner, int):
        return root
    return ("of", root, name) if inner[0] == "arrived" or (inner[0] == "made" and inner[3]) else root


def narrowed(walker: Walker, mask: int) -> int:
    """In a branch that is about one parameter, the value of any that is set is the value of that one."""
    if not walker.narrowed:
        return mask
    anything = walker.sources.data(Source(_PARAMETER, "*"))
    bits = mask & 7 * anything
    if not bits:
        return mask
    mask &= ~bits
    for name in walker.narrowed:
        mask |= bits // anything * walker.sources.data(Source(_PARAMETER, name))
    return mask


def constant(seen: Seen, register: int) -> object:
    """The key that a register surely holds in an operation; None where that is not known, or counts from the end."""
    found = seen.constant(register)
    return None if isinstance(found, int) and found < 0 else found


_OF_CAUSES: Final = {
    Cause.PARAMETER: "parameter",
    Cause.ARGUMENT: "argv",
    Cause.ENVIRONMENT: "env",
    Cause.SET: "env",
    Cause.FILE: "file",
}
_OF_ORIGINS: Final = {"parameter": "parameter", "argument": "argv", "environment variable": "env"}
_PARAMETER: Final = "parameter"


def arising(walker: Walker, seen: Seen, *, read: bool = False) -> int:
    """The sources outside of the program that the interpretation says a value comes from; `read`: it is read from something else."""
    mask = 0
    if not seen.reasons and not seen.origins:  # of most
        return mask
    for origin in seen.origins:
        kind = _OF_ORIGINS.get(origin.kind)
        if kind is not None:
            mask |= walker.sources.data(Source(kind, origin.name if kind == _PARAMETER else ""))
    for reason in seen.reasons:
        kind = _OF_CAUSES.get(reason.cause)
        if (kind == "file" and read) or reason.subject in _OF_NO_VALUE:
            continue
        if kind == _PARAMETER:
            mask |= walker.sources.data(Source(kind, _parameter(reason.subject)))
        elif kind is None:
            kind = _outside(reason)
        if kind is not None and kind != _PARAMETER:
            mask |= walker.sources.data(Source(kind))
    return mask


def _outside(reason: Reason) -> str | None:
    """What comes in at run time, by what the reason says of it."""
    if reason.cause is Cause.RANDOM:
        return "clock" if reason.subject.startswith(("time.", "datetime.", "std.chrono.")) else "random"
    if reason.cause is Cause.INPUT:
        return "process" if reason.subject.startswith(("output", "exit", "subprocess")) else "stdin"
    return None


_OF_NO_VALUE: Final = frozenset({"set when it runs", "name, set when it runs", "time", "select.select"})
"""Which parameters are set is no content of one; what a time holds, the object says, and of what is ready, whoever waits for it."""


def _parameter(subject: str) -> str:
    """The name of a parameter in a reason; '*' where it is not one."""
    return subject if subject and " " not in subject and "," not in subject else "*"
