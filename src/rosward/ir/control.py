# SPDX-License-Identifier: Apache-2.0
"""The operations that hold blocks, or leave one: branches, loops, try, return, raise, break, continue."""

from __future__ import annotations

from typing import final

from rosward.ir.core import NO_REGISTER
from rosward.ir.op import Block, Op


@final
class If(Op):
    """Run `then` where register test is true, else `orelse`."""

    __slots__ = ("orelse", "test", "then")

    def __init__(self, line: int, column: int, test: int, then: Block, orelse: Block) -> None:
        super().__init__(line, column)
        self.test = test
        self.then = then
        self.orelse = orelse

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.then, self.orelse)


@final
class While(Op):
    """Run `condition`, and while register test is true `body`; `orelse` when it ends without break.

    `counted`: the loop counts up to something, like one over a `range`: where that is a default, there are so many turns.
    """

    __slots__ = ("body", "condition", "counted", "orelse", "test")

    def __init__(
        self, line: int, column: int, condition: Block, test: int, body: Block, orelse: Block, *, counted: bool = False
    ) -> None:
        super().__init__(line, column)
        self.counted = counted
        self.condition = condition
        self.test = test
        self.body = body
        self.orelse = orelse

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.condition, self.body, self.orelse)


@final
class ForEach(Op):
    """For each item of register iterable: write it to register item, run `body`; `orelse` when it ends without break."""

    __slots__ = ("body", "is_async", "item", "iterable", "orelse")

    def __init__(
        self, line: int, column: int, item: int, iterable: int, body: Block, orelse: Block, is_async: bool = False
    ) -> None:
        super().__init__(line, column)
        self.item = item
        self.iterable = iterable
        self.body = body
        self.orelse = orelse
        self.is_async = is_async

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body, self.orelse)


@final
class Handler:
    """One `except`: `match` computes the exception class into `type` (NO_REGISTER: catches all); the exception goes to register bind."""

    __slots__ = ("bind", "body", "match", "type")

    def __init__(self, match: Block, type_: int, bind: int, body: Block) -> None:
        self.match = match
        self.type = type_
        self.bind = bind
        self.body = body


@final
class Try(Op):
    """try / except / else / finally; `star` for `except*`, where several handlers may run, each with a group of exceptions."""

    __slots__ = ("body", "final", "handlers", "orelse", "star")

    def __init__(
        self,
        line: int,
        column: int,
        body: Block,
        handlers: tuple[Handler, ...],
        orelse: Block,
        final_: Block,
        star: bool = False,
    ) -> None:
        super().__init__(line, column)
        self.star = star
        self.body = body
        self.handlers = handlers
        self.orelse = orelse
        self.final = final_

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body, *(b for h in self.handlers for b in (h.match, h.body)), self.orelse, self.final)


@final
class Return(Op):
    """Leave the function with register src."""

    __slots__ = ("src",)

    def __init__(self, line: int, column: int, src: int) -> None:
        super().__init__(line, column)
        self.src = src


@final
class Raise(Op):
    """raise src (NO_REGISTER: again), from register cause where it is not NO_REGISTER."""

    __slots__ = ("cause", "src")

    def __init__(self, line: int, column: int, src: int, cause: int = NO_REGISTER) -> None:
        super().__init__(line, column)
        self.src = src
        self.cause = cause


@final
class Break(Op):
    """Leave the innermost loop."""

    __slots__ = ()


@final
class Continue(Op):
    """Go on with the next turn of the innermost loop."""

    __slots__ = ()
