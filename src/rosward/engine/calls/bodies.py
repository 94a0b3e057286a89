# SPDX-License-Identifier: Apache-2.0
"""Running a body on bound registers: its frame, its cells, its context, and what it leaves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join
from rosward.domain.state import State, join_states
from rosward.domain.values import NONE, UNBOUND, Function, Ref, Value
from rosward.engine.running.frame import Frame
from rosward.engine.unknown import declared

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rosward.engine.machine import Engine
    from rosward.ir.program import Code


def run_body(
    machine: Engine, function: Function, registers: list[Value], caller: Frame | None, context: int | None = None
) -> Value:
    """Interpret a body in a frame of its own; the value returned."""
    code = function.code
    machine.trace.entered.add(code.key)
    machine.choosing = 0
    if context is None:
        context = context_of(machine, code, caller)
    full = [*registers, *([UNBOUND] * (code.registers - len(registers)))]
    frame = Frame(code, full, (), function.module, context, declared.is_model(function))
    own = machine.new_cells(code, context)
    frame.cells = (*own, *function.cells)
    machine.frames.append(frame)
    machine.check_time()
    try:
        alive = machine.run(code.ops, frame)
    finally:
        machine.frames.pop()
        if own and machine.summaries.fresh.issuperset(
            own
        ):  # what stood there before the call is nothing that it asked for
            machine.asked_for.difference_update(own)
    left = left_by(machine, frame, alive=alive)
    if left is None:
        return UNBOUND
    value, machine.state = left
    return value


def left_by(machine: Engine, frame: Frame, *, alive: bool) -> tuple[Value, State] | None:
    """What a body returned, and the state there; `alive`: control also came out at its end. None: it does not return."""
    exits = frame.exits
    if alive:
        exits.value = join(exits.value, NONE)
        state = machine.state
        if exits.returned is not None:
            state = join_states(exits.returned.state, state, machine.fresh_version)
        return exits.value, state
    return None if exits.returned is None else (exits.value, exits.returned.state)


def context_of(machine: Engine, code: Code, caller: Frame | None, registers: Sequence[Value] = ()) -> int:
    """The context of a call: the chain of calls that led to it. What one operation calls (`map`, `sum`) is told apart by its turn.

    Where precision is given up, functions are contexts, but for those of libraries and those that create something: what these do for one
    caller is no other's business. A method of a library may say that it is one for each object.
    """
    if code.signature is not None and code.signature.apart:
        this = registers[0] if registers else None
        return machine.context("of an object", code.key, this if this.__class__ is Ref else None)
    if machine.precision.coarse and not code.is_model and code.key not in machine.trace.creating:
        return machine.context("coarse", code.key)
    if caller is None:
        return 0
    return machine.context(caller.context, caller.code.key, caller.op.number, caller.next(), code.key)
