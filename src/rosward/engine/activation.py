# SPDX-License-Identifier: Apache-2.0
"""A call of a function with bound registers: is it followed, remembered, or one of those that share a summary?

def walk(n): …; walk(n - 1)      four activations are followed, all deeper ones share a summary (`summarised.py`)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import Function, Value
from rosward.engine import declared, repeated
from rosward.engine.bodies import context_of, run_body
from rosward.engine.summarised import summarised
from rosward.ir.ops import Block, ForEach, If, LoadAttr, Op, Try, While, With

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_OF_LOOPS: Final = 50
"""So many operations a loop counts for."""


def invoke(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """Run a function body on bound registers; the value returned."""
    code = function.code
    depth = sum(1 for f in machine.frames if f.code is code)
    limit = machine.budget.recursion
    if machine.precision.coarse:
        recursive = code.key in machine.summaries.recursive
        if recursive or code.key not in machine.trace.creating:
            limit = 0 if recursive or _is_large(machine, function) else 1
    if depth:
        machine.summaries.recursive.add(code.key)
    if depth >= limit or len(machine.frames) >= machine.budget.depth:
        return summarised(machine, function, registers)
    caller = machine.frames[-1] if machine.frames else None
    context = context_of(
        machine, code, caller
    )  # also where the call is not run: what follows has the same names either way
    key = repeated.key_of(machine, function, registers)
    known = repeated.again(machine, key)
    if known is not None:
        if machine.watch is not None:
            machine.watch.again(machine, key)
        return known
    noted, machine.noted = machine.noted, 0
    run = repeated.Run(machine)
    try:
        value = run_body(machine, function, registers, caller, context)
    finally:
        asked_for = run.end(machine)
    level, machine.noted = machine.noted, max(machine.noted, noted)
    if run.keep(machine, key, asked_for, value, level) and machine.watch is not None:
        machine.watch.remember(key, code, context)
    return value


def _is_large(machine: Engine, function: Function) -> bool:
    """Whether running a body again costs more than asking for its summary. What a library says to be worth it is run each time."""
    code = function.code
    found = machine.summaries.large.get(code.key)
    if found is None:
        precise = machine.library.facts.precise
        kept = code.name == "__init__" or declared.is_model(function) or _calls(code.ops, precise)
        found = machine.summaries.large[code.key] = not kept and _weight(code.ops) > machine.budget.large
    return found


def _calls(block: Block, beginnings: tuple[str, ...]) -> bool:
    """Whether a block reads an attribute whose name begins so."""
    return any(
        (isinstance(op, LoadAttr) and op.name.startswith(beginnings))
        or any(_calls(inner, beginnings) for inner in _inner(op))
        for op in block
    )


def _inner(op: Op) -> tuple[Block, ...]:
    """The blocks in which an operation spends its time."""
    if isinstance(op, If):
        return (op.then, op.orelse)
    return (op.body,) if isinstance(op, (While, ForEach, Try, With)) else ()


def _weight(block: Block) -> int:
    """About how much there is to interpret in a block: loops go round several times."""
    loops = sum(1 for op in block if isinstance(op, (While, ForEach)))
    return len(block) + _OF_LOOPS * loops + sum(_weight(inner) for op in block for inner in _inner(op))
