# SPDX-License-Identifier: Apache-2.0
"""Methods of the program that others call where no line of it says so: Python itself, and libraries that were given an object of the class.

float(angle)              gives what `__float__` of the class of `angle` returns
values[index]             `__index__`, and so on: any of them, in whatever is made of an object of the class
list(path)                what `__iter__` gives are the elements
json.dumps(x, cls=Mine)   gives what `default` of `Mine` returns, which gets what is in `x`
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod
from rosward.domain.values import Function, Value
from rosward.engine.running.seen import Seen, refs_of
from rosward.flow import hidden
from rosward.flow.marks import NOTHING, Mark, Root
from rosward.flow.reading import elements
from rosward.flow.stored.shape import GIVING_NOTHING

if TYPE_CHECKING:
    from rosward.flow.walker import Walker

ELEMENTS: Final = frozenset({"__iter__", "__next__", "__getitem__", "__reversed__", "__aiter__", "__anext__", "keys"})
"""They give the elements of an object, or what gives them."""
_CALL_NOTHING: Final = frozenset(
    (
        *("isinstance", "issubclass", "id", "callable", "type", "super", "getattr", "setattr", "hasattr", "delattr"),
        *("list", "tuple", "iter", "next", "zip", "enumerate", "vars", "locals", "functools.partial", "len"),
        *("list.append", "list.insert", "list.extend", "list.pop", "list.clear", "list.copy", "list.reverse"),
        *("dict.values", "dict.items", "dict.keys", "dict.copy", "dict.clear", "generator.send"),
        *(f"collections.deque.{m}" for m in ("append", "appendleft", "pop", "popleft", "extend", "clear", "rotate")),
        *("collections._fill", "_rosward.schedule", "_rosward.escape", "_rosward.contents"),
    )
)
"""Natives that call no method of what they are given but those that the interpretation follows."""


def _results(cls: int) -> Root:
    return ("implicit", cls)


def _arguments(cls: int) -> Root:
    return ("handed", cls)


def keep(walker: Walker, callback: Value, mask: int, *, writes: bool) -> None:
    """A method that nothing in the program calls has given this, or a class of which only a library makes objects; `writes`: to other objects."""
    method = callback.function if isinstance(callback, BoundMethod) else callback
    if not isinstance(method, Function) or method.code.name in GIVING_NOTHING:
        mask = 0
    roots = refs_of(callback.receiver if isinstance(callback, BoundMethod) else callback)
    for cls in _classes(walker, frozenset(roots)):
        if cls not in walker.implicit:
            walker.implicit.add(cls)
            walker.forget()
        if writes and cls not in walker.writing:
            walker.writing.add(cls)
            walker.forget()
        walker.memory.write_any([_results(cls)], Mark(mask))
    if isinstance(callback, BoundMethod):
        hidden.give_to_bases(walker, callback.receiver, mask)


def arguments_of(walker: Walker, callback: Value) -> Mark:
    """What such a method may be called with: whatever was given along with an object of its class."""
    found = Mark(hidden.of_bases(walker, callback.receiver)) if isinstance(callback, BoundMethod) else NOTHING
    roots = refs_of(callback.receiver if isinstance(callback, BoundMethod) else callback)
    for cls in _classes(walker, frozenset(roots)):
        found = found.joined(walker.memory.of(_arguments(cls)).whole)
    return found


def _classes(walker: Walker, roots: Iterable[Root]) -> Iterable[int]:
    """The classes of objects, and those that are handed on themselves."""
    roots = tuple(roots)
    found = dict.fromkeys(walker.shape.classes_of(roots))
    found.update(dict.fromkeys(r for r in roots if r.__class__ is int and walker.shape.kind(r) == "class"))
    return found


def given_by(walker: Walker, marks: Iterable[Mark], *, unseen: bool = False) -> int:
    """What may be in a value that Python makes of these, because it calls methods of them; `unseen`: also those that are followed elsewhere."""
    unseen = unseen and bool(walker.followed)
    if not (walker.implicit or unseen):
        return 0
    mask, everything, writes = 0, None, False
    marks = tuple(marks)
    for mark in marks:
        if not mark.roots:
            continue
        for cls in _classes(walker, walker.memory.reached(mark)):
            if unseen:
                mask |= walker.memory.of(("followed", cls)).whole.mask
            if cls not in walker.implicit:
                continue
            mask |= walker.memory.of(_results(cls)).whole.mask
            if everything is None:
                everything = _all(walker, marks)
            walker.memory.write_any([_arguments(cls)], everything)
            writes = writes or cls in walker.writing
    if writes:
        walker.meet_callbacks()
    return mask


def _all(walker: Walker, marks: Iterable[Mark]) -> Mark:
    """All of these, with what they lead to."""
    found = NOTHING
    for mark in marks:
        found = found.joined(Mark(walker.memory.deep(mark), mark.roots))
    return found


def under_given(
    walker: Walker, name: str, marks: Sequence[Mark], *, unseen: bool = False, but: Collection[Root] = ()
) -> list[Mark]:
    """What a function of a library is called with: whatever it makes of it may hold what methods of it gave, `but` for those of these objects."""
    found = list(marks)
    if (walker.implicit or unseen) and name.removeprefix("builtins.") not in _CALL_NOTHING:
        mask = given_by(walker, [Mark(m.mask, m.roots.difference(but)) for m in found] if but else found, unseen=unseen)
        if mask:
            return [mark.under(mask) for mark in found]
    return found


def gone_through(walker: Walker, given: Mark) -> Mark:
    """The elements of an object, of which methods gave this: elements, or what gives them."""
    return given.joined(elements(walker, given)) if given.roots else given


def made_of(walker: Walker, seen: Seen, given: Mark) -> Mark:
    """What an operation makes of what methods gave it: where they say what it goes through, of the elements, too."""
    return gone_through(walker, given) if any(a.code.name in ELEMENTS for a in seen.callees) else given


def with_elements(seen: Seen, marks: list[Mark], given: Mark | None, ended: int) -> list[Mark]:
    """The arguments of a native, objects with what their methods gave it as their elements; `ended`: what decides how many these are."""
    if given is None or not any(a.code.name in ELEMENTS for a in seen.callees):
        return marks
    return [mark.joined(given).under(ended) if mark.roots else mark for mark in marks]
