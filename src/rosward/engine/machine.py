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
    from rosward.engine.activation import Summary
    from rosward.engine.budget import Budget
    from rosward.engine.catcher import Catcher
    from rosward.engine.frame import Frame, Snapshot
    from rosward.engine.library import Library
    from rosward.engine.python.generators import Running
    from rosward.engine.python.stepping import Action, Stepped
    from rosward.engine.python.suspending import Way
    from rosward.engine.schedule import Schedule
    from rosward.ir import ops
    from rosward.ir.program import Code, OpKey
    from rosward.models.native import Items
    from rosward.source.location import Place


class Engine(Machine, Protocol):
    """What runs the code of one process: its state, and each question that one module of the engine asks another."""

    state: State
    frames: list[Frame]
    catchers: list[Catcher]
    schedule_book: Schedule
    steps: int
    step_limit: int
    coarse: bool
    always_coarse: bool
    coarse_limit: int
    loop_limit: int
    heavy: set[OpKey]
    heads: dict[OpKey, Snapshot]
    deadline: float
    making: list[Class]
    unhooked: set[int] | None
    hooked: bool
    choosing: bool
    noted: int
    handling: list[tuple[Value, int]]
    provisional: int
    fixpoints: int
    loops: int
    turns: int
    ended_at: dict[Place, Value]
    advancing: dict[int, Running]
    ways: dict[str, dict[int, Way]]
    ends: State | None
    summaries: dict[object, Summary]
    finished: dict[object, Summary]
    large: dict[str, bool]
    memo: dict[object, tuple[Value, int]]
    instantiated: set[Place]
    handed: dict[Value, Place]
    entered: set[str]
    reached: set[OpKey]
    asked: set[tuple[str, str, str]]

    @property
    def library(self) -> Library:
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

    def begin_loop(self, op: ops.Op, frame: Frame) -> None:
        """A loop begins: an outermost one has turns and steps of its own, before precision is given up."""

    def end_loop(self, op: ops.Op, frame: Frame) -> None:
        """A loop has ended."""

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

    def may_call(self, values: Sequence[Value]) -> None:
        """A described library may call those that are functions."""
