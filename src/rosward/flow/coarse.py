# SPDX-License-Identifier: Apache-2.0
"""A walk that is coarser and cheaper: for processes on which the other one takes too long.

    self.last = msg         in the one walk, `last` holds this message from here on; in this one, all that is ever written to it
    self.last = None

There is one memory, in which nothing is replaced (`coarse_memory.py`). A body is walked through with all that any call from there gives it, and
again only where something that it has read, or is given, has become more. So the work is bounded by what there is to find. It finds whatever
the other walk finds.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.flow.body import Body, Point
from rosward.flow.coarse_memory import CoarseMemory
from rosward.flow.marks import NOTHING, Mark
from rosward.flow.stay import Stay
from rosward.flow.walker import Walker

if TYPE_CHECKING:
    from collections.abc import Hashable, Mapping

    from rosward.effects.flows import Sink
    from rosward.engine.scheduled import Scheduled
    from rosward.engine.seen import Activation
    from rosward.engine.watch import Watch
    from rosward.flow.marks import Root
    from rosward.flow.shape import Shape
    from rosward.flow.sinks import Chain
    from rosward.flow.walker import Handler
    from rosward.ir import ops


@final
class CoarseWalker(Walker):
    """Walks through one process, with one memory."""

    memory: CoarseMemory

    def __init__(
        self,
        watch: Watch,
        shape: Shape,
        tables: Mapping[str, Mapping[type[ops.Op], Handler]],
        most: int,
        watched: frozenset[str],
    ) -> None:
        super().__init__(watch, shape, tables, most, watched)
        self._only = self.memory = self.beside = CoarseMemory(shape)
        self._stays: dict[Hashable, Stay] = {}
        self._heads: dict[Hashable, tuple[list[Mark], int]] = {}
        self._decided: tuple[dict[Root, int], dict[Scheduled, int]] = ({}, {})

    @property
    def hurries(self) -> bool:
        """Functions of libraries that only compute are taken as a whole."""
        return True

    def begin(self) -> None:
        """The main body begins, and with it one more round: what decides whether callbacks run is read by whom nobody knows."""
        self.memory = self._only
        decided = self.stopped, self.returned
        if decided != self._decided:
            self._decided = self.stopped.copy(), self.returned.copy()
            for stay in self._stays.values():
                stay.due = True

    def leave(self) -> None:
        """What runs has come to its end: whether it has left more than there was."""
        self.changed |= self._only.grew
        self._only.grew = False

    def loop_begins(self, op: ops.Op, body: Body) -> None:
        """A loop begins with what earlier walks have found at its head."""
        known = self._heads.get((self._only.reader, body.activation, op.number))
        if known is not None:
            body.pc |= known[1]
            for number, mark in enumerate(known[0]):
                body.registers[number] = body.registers[number].joined(mark)

    def loop_ends(self, op: ops.Op, head: Point, body: Body) -> None:
        """Keep what holds at the head of a loop."""
        self._heads[self._only.reader, body.activation, op.number] = head.registers.copy(), body.pc

    def _chain(self) -> Chain | None:
        """Callers are not told apart."""
        return None

    def send(self, sink: Sink, mask: int) -> None:
        """Something leaves the process."""
        self.trail.send(sink, mask)
        self.changed |= self.sinks.add(sink, mask, self.event)

    def enter(self, activation: Activation, arguments: list[Mark], pc: int) -> Mark:
        """Walk through a body, unless nothing has become more since it was: what it returns."""
        memory = self._only
        outer = memory.reader
        stay = self._stay(activation)
        grew = stay.give(arguments, pc, self._around(activation), tried=bool(self.attempts))
        if outer is not None:
            stay.callers.add(outer)
        if stay.runs:
            if grew:
                self.changed = True
                stay.again()
            return stay.result
        attempt = self.attempts[-1] if self.attempts else None
        if grew or stay.due:
            self.changed |= grew
            before = (0, NOTHING) if attempt is None else (attempt.mask, attempt.raised)
            if attempt is not None:
                attempt.mask, attempt.raised = 0, NOTHING
            stay.due, stay.runs, memory.reader = False, True, stay
            try:
                result = stay.result.joined(self._walk(activation, list(stay.arguments), stay.pc))
            finally:
                stay.runs, memory.reader = False, outer
            found = (0, NOTHING) if attempt is None else (attempt.mask, attempt.raised)
            if attempt is not None:
                attempt.mask, attempt.raised = before
            more = result is not stay.result or found[0] | stay.raising != stay.raising
            stay.result, stay.raising, stay.raised = result, found[0] | stay.raising, stay.raised.joined(found[1])
            if more:
                self.changed = True
                for caller in stay.callers:
                    if caller is not outer:
                        caller.again()
        if attempt is not None:
            attempt.mask |= stay.raising
            attempt.raised = attempt.raised.joined(stay.raised)
        return stay.result

    def _stay(self, activation: Activation) -> Stay:
        """The body in this callback, on behalf of this node; of a function of a library, as the program calls it here."""
        site: Hashable = None
        if activation.code.file.startswith("models:"):
            for body in reversed(self.bodies):
                if not body.activation.code.file.startswith("models:"):
                    site = body.activation, body.at.number
                    break
        key = (activation, self.trail.event, self.node, tuple(self.narrowed), site)
        found = self._stays.get(key)
        if found is None:
            found = self._stays[key] = Stay()
        return found

    def _around(self, activation: Activation) -> tuple[tuple[Mark, ...], ...]:
        """What the functions of the library got through which the program has led here."""
        found = []
        if activation.code.file.startswith("models:"):
            for body in reversed(self.bodies):
                if not body.activation.code.file.startswith("models:"):
                    break
                found.append(body.arguments)
        return tuple(found)
