# SPDX-License-Identifier: Apache-2.0
"""What special methods give that Python calls where no line of the program says so.

float(angle)          gives what `__float__` of the class of `angle` returns
values[index]         `__index__`, and so on: any of them, in whatever is made of an object of the class
list(path)            what `__iter__` gives are the elements
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod
from rosward.domain.values import Value
from rosward.engine.seen import Seen, refs_of
from rosward.flow.marks import Mark, Root
from rosward.flow.reading import elements

if TYPE_CHECKING:
    from rosward.flow.walker import Walker

ELEMENTS: Final = frozenset({"__iter__", "__next__", "__getitem__", "__reversed__", "__aiter__", "__anext__", "keys"})
"""They give the elements of an object, or what gives them."""


def _root(cls: int) -> Root:
    return ("implicit", cls)


def keep(walker: Walker, callback: Value, mask: int) -> None:
    """A special method has given this."""
    if isinstance(callback, BoundMethod):
        for cls in walker.shape.classes_of(frozenset(refs_of(callback.receiver))):
            walker.call_implicitly(cls)
            walker.memory.write_any([_root(cls)], Mark(mask))


def given_by(walker: Walker, marks: Iterable[Mark]) -> int:
    """What may be in a value that Python makes of these."""
    if not walker.implicit:
        return 0
    mask = 0
    for mark in marks:
        for cls in walker.shape.classes_of(walker.memory.reached(mark)):
            if cls in walker.implicit:
                mask |= walker.memory.of(_root(cls)).whole.mask
    return mask


def gone_through(walker: Walker, given: Mark) -> Mark:
    """The elements of an object, of which methods gave this: elements, or what gives them."""
    return given.joined(elements(walker, given)) if given.roots else given


def with_elements(seen: Seen, marks: list[Mark], given: Mark | None) -> list[Mark]:
    """The arguments of a native, objects with what their methods gave it as their elements."""
    if given is None or not any(a.code.name in ELEMENTS for a in seen.callees):
        return marks
    return [mark.joined(given) if mark.roots else mark for mark in marks]
