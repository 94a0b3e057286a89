# SPDX-License-Identifier: Apache-2.0
"""One call in progress, and the states in which control leaves it abruptly."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final, final

from rosward.domain.choice import join
from rosward.domain.memory import Heap
from rosward.domain.state import Merge, State, join_registers, join_states
from rosward.domain.suspended import Point
from rosward.domain.values import UNBOUND, Function, ModuleValue, Value
from rosward.ir.program import Code
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.effects.log import Execution
    from rosward.engine.running.seen import Activation

_MOST: Final = 64
"""How many calls and objects of one operation are told apart."""


@final
class Snapshot:
    """A state together with the registers of one frame."""

    __slots__ = ("registers", "state")

    def __init__(self, registers: list[Value], state: State) -> None:
        self.registers = registers
        self.state = state


def join_into(
    machine: Execution, target: Snapshot | None, snapshot: Snapshot, merge: Merge = join, known: Heap | None = None
) -> Snapshot:
    """Join a snapshot (used up) into another of the same frame; `known`: a heap that this surely covers."""
    if target is None:
        return snapshot
    registers = join_registers(target.registers, snapshot.registers, merge)
    state = join_states(target.state, snapshot.state, machine.fresh_version, merge, known)
    return Snapshot(registers, state)


@final
class Exits:
    """Where abrupt control goes, joined: `broken` and `continued` for the innermost loop, `returned` (with `value`) for the function.

    `ended`: where the innermost loop may have ended by itself, though more turns follow.
    """

    __slots__ = ("broken", "continued", "ended", "outer", "returned", "value")

    def __init__(self, outer: Exits | None = None) -> None:
        self.outer = outer  # those of the statement around, where this is a `finally` or `with`
        self.broken: Snapshot | None = None
        self.continued: Snapshot | None = None
        self.ended: Snapshot | None = None
        self.returned: Snapshot | None = None
        self.value: Value = UNBOUND

    def enter_loop(self) -> OfLoop:
        """A loop begins; what is kept of the loop around it."""
        kept = (self.broken, self.continued, self.ended)
        self.broken = self.continued = self.ended = None
        return kept


OfLoop = tuple[Snapshot | None, Snapshot | None, Snapshot | None]
"""Where control left the turns of a loop, and where it may have ended."""


@final
class Yielded:
    """What advancing a generator gives, joined over the points from which it goes on: items, points, the state behind its yields.

    `function` and `context` are those of the call that runs; `lineage` tells in which generators it was made, and
    `shared` that it stands for all calls that are nested too deep: their turns are not told apart.
    """

    __slots__ = ("context", "function", "item", "lineage", "points", "shared", "state")

    def __init__(self, function: Function, lineage: tuple[str, ...], *, shared: bool) -> None:
        self.lineage = lineage
        self.shared = shared
        self.function = function
        self.context = 0
        self.item: Value = UNBOUND
        self.points: dict[Point, tuple[Value, ...]] = {}
        self.state: State | None = None


@final
class Frame:
    """The activation of a code body.

    `cells` are the heap addresses of own, then captured cells. `namespace` is the class body's heap address, or -1.
    `context` identifies the chain of calls and loop turns that led here; objects made at one place in different contexts are different.
    `op` is the operation that is running.
    `fresh` is what the last call gave by value, so that nobody else has it; `handed` is that of an argument of the call that runs.
    `returned` is what the last call gave by reference, and the function that did.
    `found` are the places of what was new when it was given to a reference. `initialising` are the arguments with which a base or field is made.
    `placed` collects the addresses of what an operation makes, where somebody asks for them; `declared` has those of the variables of blocks,
    by the number of the operation that made each last.
    `uncertain` counts the enclosing branches of which it is not known whether they run. Where a generator runs, `yielded` collects what it
    gives, and `turns` holds for each loop that is running, by the number of the operation, its turn and what it keeps between two of them.
    """

    __slots__ = (
        "cast",
        "cells",
        "code",
        "context",
        "declared",
        "exits",
        "found",
        "fresh",
        "handed",
        "initialising",
        "module",
        "namespace",
        "op",
        "placed",
        "registers",
        "returned",
        "seen",
        "sequence",
        "stub",
        "turns",
        "uncertain",
        "yielded",
    )

    def __init__(
        self, code: Code, registers: list[Value], cells: tuple[int, ...], module: ModuleValue, context: int, stub: bool
    ) -> None:
        self.code = code
        self.registers = registers
        self.cells = cells
        self.module = module
        self.context = context
        self.namespace = -1
        self.stub = stub  # True where the code belongs to a library model
        self.exits = Exits()
        self.op = code.entry
        self.sequence = 0  # how many calls and objects the current operation has made
        self.uncertain = 0
        self.fresh: Value = UNBOUND
        self.handed: Value = UNBOUND
        self.found: tuple[Value, ...] = ()
        self.initialising: tuple[Any, ...] = ()
        self.returned: tuple[Value, Function] | None = None
        self.yielded: Yielded | None = None
        self.seen: Activation | None = None  # what is noted of it, where somebody watches
        self.turns: dict[int, tuple[Any, ...]] = {}
        self.placed: list[int] | None = None
        self.declared: dict[int, list[int]] = {}
        self.cast: dict[int, Value] = {}  # by register, the class of which a cast says that an object is

    def next(self) -> int:
        """Which call or object of the current operation this is. They are finitely many: where there are too many, the last stands for all."""
        number = self.sequence
        if number < _MOST:
            self.sequence = number + 1
        return number

    @property
    def place(self) -> Place:
        """Where the operation stands that is running."""
        return Place(self.code.file, self.op.line, self.op.column)


def is_running(frames: Sequence[Frame], code: Code, context: int) -> bool:
    """Whether a call of a body is among these, in this context."""
    return any(frame.code is code and frame.context == context for frame in frames)


def own_frame(frames: Sequence[Frame]) -> Frame | None:
    """The innermost call of the user's code; None where no code of the program is running."""
    for frame in reversed(frames):
        if not frame.stub:
            return frame
    return None
