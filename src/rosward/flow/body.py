# SPDX-License-Identifier: Apache-2.0
"""One body that is being walked through: its registers, what decides that it is where it is, and how it is left."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import compress
from operator import is_not
from typing import final

from rosward.engine.running.seen import Activation
from rosward.flow.marks import NOTHING, Mark, Root
from rosward.flow.stored.content import Content, both
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.sinks import Chain
from rosward.ir.op import Op
from rosward.location import Place


@final
class Point:
    """Where control is: what the registers and the objects hold."""

    __slots__ = ("memory", "registers")

    def __init__(self, registers: list[Mark], memory: Memory) -> None:
        self.registers = registers
        self.memory = memory

    def copy(self) -> Point:
        """An independent copy."""
        return Point(self.registers.copy(), self.memory.copy())

    def join(self, other: Point) -> bool:
        """Cover another one of the same body, too; whether that changed anything."""
        changed = self.memory.join(other.memory)
        ours, theirs = self.registers, other.registers
        for number in list(compress(range(len(theirs)), map(is_not, ours, theirs))):
            joined = ours[number].joined(theirs[number])
            if joined is not ours[number]:
                ours[number] = joined
                changed = True
        return changed


def joined(left: Point | None, right: Point | None) -> Point | None:
    """What covers both (the first is used up); None where control comes from neither."""
    if left is None or right is None:
        return right if left is None else left
    left.join(right)
    return left


@final
class Attempt:
    """A `try` that is running: every state in which its body may be left by an exception, and what that may depend on."""

    __slots__ = ("body", "handles", "log", "mask", "outer", "point", "raised")

    def __init__(self, body: Body, point: Point, *, handles: bool = False) -> None:
        self.handles = handles  # it has handlers
        self.body = body
        self.point = point.copy()
        self.outer = point.memory.log
        self.log: dict[Root, Content] = {}  # what is written meanwhile
        self.point.memory.log = self.outer
        point.memory.log = self.log
        self.mask = 0  # of all that the body reads
        self.raised = NOTHING  # what it raises itself

    def raises(self, raised: Mark, mask: int) -> None:
        """The body raises this itself; `mask`: with all that it leads to."""
        self.raised = self.raised.joined(raised)
        self.mask |= mask

    def contains(self, inner: Attempt) -> None:
        """A `try` in the body was left, wherever in it: what stood in the variables then, a handler of this one may find, too."""
        self.mask |= inner.mask
        if inner.body is self.body:
            ours = self.point.registers
            for number, mark in enumerate(inner.point.registers):
                ours[number] = ours[number].joined(mark)

    def end(self, memory: Memory) -> None:
        """The body has come to its end, or left: a handler may find whatever was written in it."""
        memory.log = self.outer
        self.point.memory.log = None
        self.point.memory.cover(self.log)
        self.point.memory.log = self.outer
        if self.outer is not None:
            for root, content in self.log.items():
                old = self.outer.get(root)
                self.outer[root] = content if old is None else both(old, content)


@final
class Body:
    """The walk through one activation.

    `pc`: what decides that control is here; `left`: the part of it that stays to the end of the function, because one way has left it.
    `leaves` counts how often control has left the function; `turned` is what decides that it has left a turn of the innermost loop.
    """

    __slots__ = (
        "activation",
        "arguments",
        "at",
        "broken",
        "continued",
        "leaves",
        "left",
        "pc",
        "registers",
        "result",
        "returned",
        "tests",
        "turned",
    )

    def __init__(self, activation: Activation, registers: list[Mark], pc: int) -> None:
        self.activation = activation
        self.at: Op = activation.code.entry  # the operation that is running
        self.registers = registers
        self.arguments = tuple(registers[: len(activation.code.parameters.names)])
        self.pc = pc
        self.left = 0
        self.leaves = 0
        self.turned = 0
        self.result = NOTHING
        self.tests: dict[int, str] = {}  # the text with which the value was compared that a register says the result of
        self.returned: Memory | None = None
        self.broken: Point | None = None
        self.continued: Point | None = None

    def leave(self, memory: Memory) -> None:
        """Control may leave here, with what stands there."""
        if self.returned is None:
            self.returned = memory.copy()
        else:
            self.returned.join(memory)

    def enter_loop(self) -> None:
        """A loop begins: nothing has left it, or gone on with its next turn."""
        self.broken = self.continued = None
        self.turned = 0


def here(body: Body) -> Chain:
    """Where a body is; nothing where it is code of a model, or has not begun."""
    code = body.activation.code
    return () if body.at is code.entry or code.file.startswith("models:") else (Place(code.file, body.at.line),)


def where(bodies: Sequence[Body]) -> Place:
    """The statement of the user's code that is running."""
    for body in reversed(bodies):
        code = body.activation.code
        if not code.file.startswith("models:"):
            return Place(code.file, body.at.line, body.at.column)
    return Place("", 0)
