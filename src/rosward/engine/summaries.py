# SPDX-License-Identifier: Apache-2.0
"""What is remembered of calls: what each gave, and one summary for all calls of a function."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.domain.values import UNBOUND, Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.memory import Heap
    from rosward.domain.state import State
    from rosward.engine.catcher import Catcher


class Repeated(NamedTuple):
    """What a call read, wrote and gave, and what Python may raise in it."""

    reads: tuple[tuple[int, Obj | None], ...]
    replaced: tuple[tuple[int, Obj | None], ...]
    """What it wrote over without reading it."""
    writes: tuple[tuple[int, Obj], ...]
    value: Value
    level: int


@final
class Summary:
    """What is known so far of a function: the join of its calls, of its results and of the states behind.

    Of the state before, what counts is what stands at the addresses that the body asked for; of the one behind, what it changed.
    """

    __slots__ = (
        "after",
        "asked_for",
        "before",
        "begun",
        "catcher",
        "joined",
        "provisional",
        "registers",
        "turn",
        "value",
        "whole",
    )

    def __init__(self, registers: list[Value], before: State) -> None:
        self.registers = registers
        self.before = before
        self.value: Value = UNBOUND
        self.joined: Heap | None = None  # the heap that `before` was joined with last
        self.after: State | None = None
        self.catcher: Catcher | None = None  # what leaves it by exceptions; in coarse mode only
        self.asked_for: set[int] = set()  # the addresses whose records its body read
        self.begun = before.done  # what had surely happened before its body ran last
        self.whole = False  # who calls sees all of the states behind, not only what the body changed
        self.provisional = False  # it was made of another summary that was unfinished then
        self.turn = -1  # the turn of the outermost summary in which it was made last

    @property
    def versions(self) -> tuple[object, ...]:
        """What must not change any more."""
        after = self.after.version if self.after is not None else -1
        return (tuple(self.registers), self.before.version, self.value, after)


@final
class Summaries:
    """What one process remembers of its calls."""

    __slots__ = ("_records", "changes", "finished", "large", "provisional", "recursive", "repeated", "running", "turns")

    def __init__(self) -> None:
        self.repeated: dict[object, list[Repeated]] = {}  # what calls read, wrote and gave, by what else they depend on
        self._records = 0  # of how many records that speaks, those of calls that were forgotten included
        self.running: dict[object, Summary] = {}  # of recursions that are being solved
        self.finished: dict[object, Summary] = {}  # of recursions and large functions; in coarse mode only
        self.provisional = 0  # how often an unfinished summary of a recursion was read
        self.large: dict[str, bool] = {}  # whether a code body, by its key, has loops
        self.recursive: set[str] = set()  # the code bodies, by their keys, that were called inside themselves
        self.turns = 0  # of all summaries that are in no other one
        self.changes = 0  # how often a summary became another one

    def keep(self, key: object, call: Repeated, apart: int, most: int) -> None:
        """Remember a call: `apart` of each key, the latest first, and all of them until they speak of so many records."""
        self._records += 1 + len(call.reads) + len(call.replaced) + len(call.writes)
        if self._records > most:
            self.repeated.clear()
            self._records = 0
        known = self.repeated.setdefault(key, [])
        known.insert(0, call)
        del known[apart:]
