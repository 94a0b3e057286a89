# SPDX-License-Identifier: Apache-2.0
"""What a running `try` collects: the states from which its handlers may start, and what is raised in it.

self.t = 'a'; risky(); self.t = 'b'      the handlers see t as it was, 'a' and 'b'
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join
from rosward.domain.heap import Obj
from rosward.domain.values import UNBOUND, Value
from rosward.engine.frame import Frame
from rosward.engine.state import State, join_objects, join_registers, join_states
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter

_CANNOT_FAIL: Final = (
    ops.Const,
    ops.Move,
    ops.StoreGlobal,
    ops.StoreCell,
    ops.StoreName,
    ops.MakeFunction,
    ops.Build,
    ops.NewCell,
    ops.Assume,
    ops.Yield,  # notes itself
)


@final
class Catcher:
    """A `try` that is running.

    `snapshot` covers every state from which its handlers may start: the one at its beginning, joined with each object that is written
    and each change of the frame's registers since. `reached`: something in the body may fail. `raised` joins what is raised explicitly.
    """

    __slots__ = ("frame", "handles", "importing", "noted", "raised", "reached", "snapshot")

    def __init__(self, machine: Interpreter, frame: Frame, *, handles: bool = False) -> None:
        self.frame = frame
        self.handles = handles  # it has `except`, not `finally` or `with` alone
        self.snapshot = machine.snapshot(frame)
        self.noted = self.snapshot.registers[: len(frame.code.variables)]
        self.raised: Value = UNBOUND
        self.reached = False
        self.importing = False  # an import in the body may fail

    def note(self) -> None:
        """An exception may be raised here."""
        self.reached = True
        variables = self.frame.registers[: len(self.noted)]  # temporaries do not outlive a statement
        if self.noted != variables:
            self.noted = variables
            self.snapshot.registers = join_registers(self.snapshot.registers, variables)

    def wrote(self, machine: Interpreter, address: int, obj: Obj) -> None:
        """An object is written."""
        state = self.snapshot.state
        old = state.heap.get(address)
        merged = obj if old is None else join_objects(old, obj, join)
        if merged is not old:
            state.heap[address] = merged
            state.version = machine.fresh_version()

    def take(self, machine: Interpreter, state: State) -> None:
        """All of a state may arrive here."""
        self.snapshot.state = join_states(self.snapshot.state, state.copy(), machine.fresh_version)

    def take_over(self, machine: Interpreter, inner: Catcher) -> None:
        """What an inner try did not surely catch arrives here."""
        self.take(machine, inner.snapshot.state)
        self.reached = self.reached or inner.reached
        self.importing = self.importing or inner.importing
        if inner.frame is self.frame:
            self.snapshot.registers = join_registers(self.snapshot.registers, inner.snapshot.registers)


def note(machine: Interpreter) -> None:
    """An exception may be raised here: tell the innermost try."""
    if machine.catchers:
        machine.catchers[-1].note()


def note_import(machine: Interpreter) -> None:
    """An ImportError may be raised here: of a module that is not among the sources, or by code that is not known."""
    if machine.catchers:
        machine.catchers[-1].note()
        machine.catchers[-1].importing = True


def may_have_left(machine: Interpreter, frame: Frame) -> bool:
    """Whether an exception may have led to a handler of this very frame before."""
    return any(c.frame is frame and c.handles and c.reached for c in machine.catchers)


def run_noting(machine: Interpreter, block: ops.Block, frame: Frame) -> bool:
    """Interpret a block inside a try: around each operation that may fail the state may reach the handlers."""
    catcher = machine.catchers[-1]
    table = machine.table
    for op in block:
        fails = op.__class__ not in _CANNOT_FAIL
        if fails:
            catcher.note()
        if table[op.__class__](machine, op, frame) is False:
            return False
        if fails:
            catcher.note()
    return True


def throw(machine: Interpreter, exception: Value) -> None:
    """An exception is raised here for sure."""
    machine.raised += 1
    if machine.catchers:
        catcher = machine.catchers[-1]
        catcher.note()
        catcher.raised = join(catcher.raised, exception)
    else:
        machine.log.ends_early(machine)
