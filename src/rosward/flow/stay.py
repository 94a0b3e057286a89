# SPDX-License-Identifier: Apache-2.0
"""What is known of a body in the coarser walk, and whether it is to be walked through again."""

from __future__ import annotations

from typing import final

from rosward.flow.marks import NOTHING, Mark


@final
class Stay:
    """A body that was walked through from one place: what it was given in all, what it gave.

    `due`: something that it depends on has become more. `around`: the arguments of the functions of the library around it, as far as seen.
    """

    __slots__ = ("arguments", "around", "callers", "due", "pc", "raised", "raising", "result", "runs", "tried")

    def __init__(self) -> None:
        self.arguments: list[Mark] = []
        self.pc = 0
        self.tried = False
        self.around: set[tuple[tuple[Mark, ...], ...]] = set()
        self.callers: set[Stay] = set()
        self.due = True
        self.runs = False
        self.result = NOTHING
        self.raising = 0
        self.raised = NOTHING

    def give(self, arguments: list[Mark], pc: int, around: tuple[tuple[Mark, ...], ...], *, tried: bool) -> bool:
        """It is called with this: whether that is more than before."""
        grew = self.pc | pc != self.pc or (tried and not self.tried) or around not in self.around
        self.pc |= pc
        self.tried = self.tried or tried
        self.around.add(around)
        known = self.arguments
        for number, mark in enumerate(arguments):
            if number == len(known):
                known.append(mark)
                grew = True
            joined = known[number].joined(mark)
            if joined is not known[number]:
                known[number] = joined
                grew = True
        return grew

    def again(self) -> None:
        """It is to be walked through again, and so is who leads to it."""
        work = [self]
        while work:
            stay = work.pop()
            if not stay.due:
                stay.due = True
                work += stay.callers
