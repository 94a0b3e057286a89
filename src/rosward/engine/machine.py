# SPDX-License-Identifier: Apache-2.0
"""What the modules of the engine ask each other: the protocol that the interpreter implements.

A module that says how calls or attributes work takes an `Engine`, and names no module that implements it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any, Protocol

from rosward.models.native import Machine

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.state import State
    from rosward.domain.values import Class, Function, Ref, Value
    from rosward.engine.budget import Budget
    from rosward.engine.catcher import Catcher
    from rosward.engine.frame import Frame, Snapshot
    from rosward.engine.precision import Precision
    from rosward.engine.python.stepped import Action, Running, Stepped
    from rosward.engine.python.ways import Way
    from rosward.engine.scheduled import Schedule
    from rosward.engine.shared import Shared
    from rosward.engine.summaries import Summaries
    from rosward.engine.trace import Trace
    from rosward.ir import ops
    from rosward.ir.program import Code
    from rosward.models.native import Items
    from rosward.source.location import Place


class Engine(Machine, Protocol):
    """What runs the code of one process: its state, and each question that one module of the engine asks another."""

    state: State
    frames: list[Frame]
    catchers: list[Catcher]
    schedule_book: Schedule
    precision: Precision
    trace: Trace
    summaries: Summaries
    making: list[Class]
    unhooked: set[int] | None
    hooked: bool
    choosing: bool
    noted: int
    handling: list[tuple[Value, int]]
    unheld: set[int]
    ended_at: dict[Place, Value]
    advancing: dict[int, Running]
    ways: dict[str, dict[int, Way]]
    ends: State | None

    @property
    def library(self) -> Shared:
        """What all processes share."""

    @property
    def budget(self) -> Budget:
        """How much the process may take."""

    @property
    def table(self) -> Mapping[type[ops.Op], Any]:
        """What each operation does, by its class."""

    def run(self, block: ops.Block, frame: Frame) -> bool:
        """Interpret a block; False where control does not come out at its end."""

    def give_up_value(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep: its result is not known."""

    def check_time(self) -> None:
        """Raise where the process has used up its time."""

    def context(self, *key: object) -> int:
        """The number of a context."""

    def snapshot(self, frame: Frame) -> Snapshot:
        """An independent copy of where we are."""

    def resume(self, frame: Frame, snapshot: Snapshot) -> None:
        """Go on from a snapshot (which is used up)."""

    def at(self, address: int) -> Obj:
        """The record at an address."""

    def put(self, address: int, obj: Obj) -> None:
        """Replace the record at an address."""

    def place_key(self, key: object) -> int:
        """The address that belongs to a key."""

    def place_at(self, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key; a second one there makes the record stand for both."""

    def place_anew(self, address: int, obj: Obj) -> None:
        """Put a new object at an address, beside those that stand there already."""

    def new_cells(self, code: Code, context: int) -> list[int]:
        """Fresh cells for the captured variables of a code body."""

    def call_method(self, value: Value, name: str, args: tuple[Value, ...]) -> Value:
        """value.name(*args)."""

    def make_generator(self, function: Function, registers: list[Value]) -> Ref:
        """What a call of a generator function or coroutine gives."""

    def advance(self, ref: Ref, action: Action) -> Stepped:
        """Resume a suspended generator."""

    def run_out(self, ref: Ref) -> tuple[Items, Value]:
        """Run a generator or coroutine to its end: what it yields, what it returns."""

    def handles(self, exception: Value, level: int) -> AbstractContextManager[None]:
        """A handler runs for these exceptions (UNBOUND: none that is known), and where there is a level for others that are not known."""

    def uncaught(self, exception: Value) -> None:
        """Nothing around catches this exception, which is raised here."""

    def schedule(self, callback: Value, args: Sequence[Value] | None, event: str, place: Place | None = None) -> None:
        """A callback may run from now on, with these arguments, or (None) with anything; registered here, unless another place is given."""

    def may_call(self, values: Sequence[Value]) -> None:
        """A described library may call those that are functions."""
