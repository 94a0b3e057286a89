# SPDX-License-Identifier: Apache-2.0
"""One call in progress, and the states in which control leaves it abruptly."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.domain.choice import join
from rosward.domain.values import UNBOUND, ModuleValue, Value
from rosward.engine.state import Merge, State, join_registers, join_states
from rosward.ir.program import Code

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter


@final
class Snapshot:
    """A state together with the registers of one frame."""

    __slots__ = ("registers", "state")

    def __init__(self, registers: list[Value], state: State) -> None:
        self.registers = registers
        self.state = state


def join_into(machine: Interpreter, target: Snapshot | None, snapshot: Snapshot, merge: Merge = join) -> Snapshot:
    """Join a snapshot (used up) into another of the same frame."""
    if target is None:
        return snapshot
    registers = join_registers(target.registers, snapshot.registers, merge)
    state = join_states(target.state, snapshot.state, machine.fresh_version, merge)
    return Snapshot(registers, state)


@final
class Exits:
    """Where abrupt control goes, joined: `broken` and `continued` for the innermost loop, `returned` (with `value`) for the function."""

    __slots__ = ("broken", "continued", "outer", "returned", "value")

    def __init__(self, outer: Exits | None = None) -> None:
        self.outer = outer  # those of the statement around, where this is a `finally` or `with`
        self.broken: Snapshot | None = None
        self.continued: Snapshot | None = None
        self.returned: Snapshot | None = None
        self.value: Value = UNBOUND

    @property
    def taken(self) -> bool:
        """Whether some way has left already, so that what follows does not surely happen."""
        here = self.broken is not None or self.continued is not None or self.returned is not None
        return here or (self.outer is not None and self.outer.taken)


@final
class Frame:
    """The activation of a code body.

    `cells` are the heap addresses of own, then captured cells. `namespace` is the class body's heap address, or -1.
    `context` identifies the chain of calls and loop turns that led here; objects made at one place in different contexts are different.
    `uncertain` counts the enclosing branches of which it is not known whether they run. `yields` collects what a generator yields.
    """

    __slots__ = (
        "cells",
        "code",
        "column",
        "context",
        "exits",
        "line",
        "module",
        "namespace",
        "raised",
        "registers",
        "sequence",
        "stub",
        "uncertain",
        "yield_rest",
        "yielded",
        "yields",
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
        self.line = code.line
        self.column = 1
        self.sequence = 0  # how many objects the current operation has made
        self.uncertain = 0
        self.raised = 0  # how often something had been raised when the call began
        self.yields: list[Value] = []
        self.yield_rest: Value = UNBOUND
        self.yielded: State | None = None  # the states at the yields so far, joined
