# SPDX-License-Identifier: Apache-2.0
"""Partial functions: an object that leads to the arguments it gives, by their numbers and names."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final, NamedTuple

from rosward.flow.marks import NOTHING, Mark, Root
from rosward.flow.reading import elements
from rosward.flow.stored.content import Content

if TYPE_CHECKING:
    from rosward.flow.native.native_call import NativeCall
    from rosward.flow.walker import Walker

_NAME: Final = "functools.partial"


def make(call: NativeCall) -> Mark:
    """`functools.partial(function, …)`. Which arguments `*` and `**` give is not told apart."""
    slots: dict[object, Mark] = {}
    rest, several = NOTHING, False
    for number, (argument, mark) in enumerate(call.given()):
        if argument.is_spread:
            several, rest = True, rest.joined(elements(call.walker, mark))
        elif argument.kind == "keyword":
            slots[argument.name] = mark
        elif several:
            rest = rest.joined(mark)
        elif number:
            slots[number - 1] = mark
    function = call.mark(0)
    root = call.walker.shape.made(call.body.activation, call.op.number, _NAME)
    call.walker.memory.renew(root)
    call.walker.memory.write_any((root,), rest)
    for key, mark in slots.items():
        call.walker.memory.write(frozenset((root,)), key, mark)
    return Mark(call.pc | function.mask, function.roots | {root})


def bound_in(mark: Mark) -> frozenset[Root]:
    """The partial functions among the objects that a mark leads to."""
    return frozenset(r for r in mark.roots if not isinstance(r, int) and r[0] == "made" and r[3] == _NAME)


class Given(NamedTuple):
    """What partial functions give to the function behind them."""

    walker: Walker
    partials: Iterable[Root]

    @property
    def positional(self) -> int:
        """So many arguments without a name they give at least."""
        return max((_positional(self.walker.memory.of(root)) for root in self.partials), default=0)

    def at(self, number: int, count: int) -> Mark:
        """The argument of this number, of so many that are given; of one partial in another nobody tells them apart."""
        found = NOTHING
        for root in self.partials:
            content = self.walker.memory.of(root)
            plain = content.any == NOTHING and _positional(content) == count
            found = found.joined(content.read(number) if plain else content.whole)
        return found

    @property
    def whole(self) -> Mark:
        """All that they give."""
        found = NOTHING
        for root in self.partials:
            found = found.joined(self.walker.memory.of(root).whole)
        return found

    def named(self, name: str) -> Mark:
        """What is given under a name."""
        found = NOTHING
        for root in self.partials:
            found = found.joined(self.walker.memory.of(root).read(name))
        return found


def _positional(content: Content) -> int:
    return sum(isinstance(key, int) for key in content.slots)
