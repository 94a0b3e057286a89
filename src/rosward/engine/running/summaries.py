# SPDX-License-Identifier: Apache-2.0
"""What is remembered of calls: what each gave, and one summary for all calls of a function."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, final

from rosward.domain.memory import SHIFT
from rosward.domain.values import UNBOUND, Value
from rosward.engine.running.attributes_asked import records_of
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.memory import Heap
    from rosward.domain.state import EventKey, State
    from rosward.engine.running.catcher import Catcher
    from rosward.engine.running.nodes_asked import Answered
    from rosward.engine.running.precision import Effort, Rests
    from rosward.engine.running.told import Telling, Told
    from rosward.ir.ops import Op
    from rosward.ir.program import OpKey


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
        "edition",
        "handled",
        "handlers",
        "joined",
        "pages",
        "provisional",
        "registers",
        "turn",
        "value",
        "whole",
        "wrote",
    )

    def __init__(self, registers: list[Value], before: State) -> None:
        self.registers = registers
        self.before = before
        self.value: Value = UNBOUND
        self.joined: Heap | None = None  # the heap that `before` was joined with last
        self.after: State | None = None
        self.catcher: Catcher | None = None  # what leaves it by exceptions
        self.handlers = 0  # how many may catch what its body raises
        self.handled = False  # there are more around a call of itself
        self.asked_for: set[int] = set()  # the addresses whose records its body read, and its questions
        self.wrote: set[int] = set()  # and those at which it wrote, whether something else stands there now or not
        self.begun = before.done  # what had surely happened before its body ran last
        self.whole = False  # who calls sees all of the states behind, not only what the body changed
        self.provisional = False  # it was made of another summary that was unfinished then
        self.edition = 0  # how often its body began to run for more calls than before
        self.turn = -1  # the turn of the outermost summary in which it was made last
        self.pages: tuple[int, dict[int, list[int]]] = 0, {}  # how many addresses were asked for, and these by page

    def asked_apart(self, one: Heap, other: Heap) -> Iterator[int]:
        """The addresses that its body asked for on the pages that two heaps do not share."""
        count, pages = self.pages
        if count != len(self.asked_for):  # it only grows
            pages = {}
            for address in set(records_of(self.asked_for)):
                pages.setdefault(address >> SHIFT, []).append(address)
            self.pages = len(self.asked_for), pages
        ours, theirs = one.pages, other.pages
        for number, addresses in pages.items():
            if ours.get(number) is not theirs.get(number):
                yield from addresses

    @property
    def versions(self) -> tuple[object, ...]:
        """What must not change any more."""
        after = self.after.version if self.after is not None else -1
        raised = self.catcher.versions if self.catcher is not None else ()
        return (tuple(self.registers), self.before.version, self.value, after, raised, self.handled)


Used = dict[object, tuple[Summary, int]]
"""Summaries by what they are of, each with its edition."""


class Changes(NamedTuple):
    """What is otherwise in a state that a call left: the records that it wrote, and what surely happened in it."""

    written: tuple[tuple[int, Obj], ...]
    done: frozenset[EventKey]


@final
class Call:
    """One call: what it found, and what it left (`recalled.py`)."""

    __slots__ = (
        "addresses",
        "anew",
        "around",
        "around_fresh",
        "around_rests",
        "around_used",
        "asked_for",
        "before",
        "begun_anew",
        "begun_nodes",
        "catcher",
        "done",
        "effort",
        "first",
        "fresh",
        "heap",
        "importing",
        "left",
        "left_in",
        "level",
        "nodes",
        "outermost",
        "over",
        "raised",
        "records",
        "rests",
        "settled",
        "stands",
        "told",
        "used",
        "value",
        "wrote",
    )

    def __init__(self, state: State, around: tuple[object, ...], before: tuple[object, ...], effort: Effort) -> None:
        self.around = around  # what it may have asked for that is no record
        self.before = before  # what must not change until it ends
        self.done = state.done
        self.effort = effort
        self.heap: Heap | None = state.heap.copy()  # until it ends
        self.catcher: Catcher | None = None  # the `try` around, until it ends
        self.first = 0  # how much was told there before
        self.outermost = False  # no other call was remembered before, of those that tell the same
        self.told: tuple[Told, ...] = ()  # what the `try` around is told, or the end of the program where there is none
        self.settled = False  # the `try` around knows the state behind it
        self.raised = 0  # how many exceptions were raised
        self.value: Value = UNBOUND
        self.level = 0  # what Python may raise in it
        self.importing = False  # an import in it may fail
        self.left: tuple[Value, ...] = ()  # of a loop: what stands in the registers that it writes,
        self.stands: tuple[Op, int]  # and the operation that ran last, with what that made
        self.asked_for: frozenset[int] = frozenset()
        self.nodes: Answered = ()  # which nodes it asked for
        self.begun_nodes = 0  # how many there were before
        self.anew: frozenset[int] = frozenset()  # the addresses at which it makes what nothing holds any more
        self.begun_anew = 0  # how many of them there were before
        self.fresh: dict[
            int, Obj | None
        ] = {}  # variables of calls within that it made, whatever stood there; and what did
        self.around_fresh: set[int] = set()  # those of what runs around, until it ends
        self.rests: Rests = {}  # where loops came to rest in it
        self.around_rests: Rests = {}  # those of what runs around, until it ends
        self.used: Used = {}  # the finished summaries at which it looked
        self.around_used: Used = {}  # those of what runs around, until it ends
        self.wrote: frozenset[int] = frozenset()  # the addresses at which it wrote
        self.addresses: tuple[int, ...] = ()  # of the records that it read or wrote, and
        self.records: tuple[Obj | None, ...] = ()  # what stood there
        self.left_in: Changes  # the state behind it,
        self.over: Changes | None = None  # and that in which a step of a generator is at its end instead


@final
class Summaries:
    """What one process remembers of its calls."""

    __slots__ = (
        "anew",
        "asked",
        "calls",
        "changes",
        "epoch",
        "finished",
        "fresh",
        "large",
        "loops",
        "memo",
        "open",
        "provisional",
        "recursive",
        "running",
        "small",
        "sure",
        "told",
        "turns",
        "uncaught",
        "used",
        "vain",
        "waiting",
        "wrote",
    )

    def __init__(self) -> None:
        self.memo: dict[
            object, tuple[Value, int, set[int], set[int]]
        ] = {}  # results, what Python may raise, what was asked for and what was written
        self.calls: dict[object, tuple[Call, ...]] = {}  # what calls did, by place (`recalled.py`)
        self.small: set[str] = set()  # the code bodies, by their keys, of which calls are not worth to be remembered
        self.vain: dict[str, int] = {}  # by code body, how many calls were remembered in vain
        self.epoch = 0  # which run of a summary's body is going on: what was remembered outside of it tells not what it asked for
        self.running: dict[object, Summary] = {}  # of recursions that are being solved
        self.finished: dict[object, Summary] = {}  # of recursions and large functions; in coarse mode only
        self.provisional = 0  # how often an unfinished summary of a recursion was read
        self.large: dict[str, bool] = {}  # whether a code body, by its key, has loops
        self.recursive: set[str] = set()  # the code bodies, by their keys, that were called inside themselves
        self.waiting: set[str] = set()  # those in which callbacks ran
        self.loops: dict[OpKey, tuple[tuple[int, ...], tuple[int, ...]] | None] = {}  # which registers loops use
        self.sure: dict[
            str, int
        ] = {}  # by code body, how many calls of a recursion were followed beyond the usual depth
        self.asked = 0  # how often a call looked at more than records: at a summary, a generator that runs, a frame
        self.open = 0  # how often at a summary of a recursion that is still being solved
        self.used: Used = {}  # the finished summaries at which the call that is to be remembered looked
        self.turns = 0  # of all summaries that are in no other one
        self.changes = 0  # how often a summary became another one
        self.told: list[Telling | None] | None = (
            None  # the exceptions that no `try` gets, while a call outside of all is remembered
        )
        self.fresh: set[int] = (
            set()
        )  # the addresses of variables that the call which is to be remembered made, and those within
        self.wrote: set[int] = set()  # the addresses at which the call that runs, or the summary that is made, wrote
        self.anew: list[int] = []  # the addresses that nothing held and that were taken again
        self.uncaught = 0  # how many of them ended the main body
