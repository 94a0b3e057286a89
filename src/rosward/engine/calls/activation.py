# SPDX-License-Identifier: Apache-2.0
"""A call of a function with bound registers: is it followed, remembered, or one of those that share a summary?

def walk(n): …; walk(n - 1)      four activations are followed, all deeper ones share a summary (`summarised.py`)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import UNBOUND, Function, Ref, Value
from rosward.engine.calls import recalled
from rosward.engine.calls.bodies import context_of, run_body
from rosward.engine.calls.summarised import summarised
from rosward.engine.throwing import note
from rosward.engine.unknown import declared
from rosward.ir.ops import Block, ForEach, If, LoadAttr, Op, Try, While, With

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code

_DEEPEST: Final = 40
"""So many activations of a function are followed where each way that leads there is known to be taken,"""
_MOST_SURE: Final = 400
"""and so many of those that would share a summary otherwise, within one that is no recursion."""
_OF_LOOPS: Final = 50
"""So many operations a loop counts for."""


def invoke(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """Run a function body on bound registers; the value returned."""
    code = function.code
    depth = _depth(machine, function, registers)
    limit = machine.budget.recursion
    if machine.precision.coarse:
        recursive = code.key in machine.summaries.recursive
        if recursive or code.key not in machine.trace.creating:
            limit = 0 if recursive or _is_large(machine, function) else 1
    if depth:
        machine.summaries.recursive.add(code.key)
        if code.key in machine.summaries.waiting:
            limit = min(limit, 1)
    if is_too_deep(machine, code, registers, depth, limit) or len(machine.frames) >= machine.budget.depth:
        return summarised(machine, function, registers)
    given = tuple(registers)
    key = (
        function,
        given,
        machine.state.version,
        bool(machine.catchers),
        machine.summaries.epoch,
        machine.language.situation(machine),
    )
    remembered = machine.summaries.memo.get(key)
    if remembered is not None:
        if machine.watch is not None:
            machine.watch.again(machine, key)
        value, level, asked_for, wrote = remembered
        machine.asked_for |= asked_for
        machine.summaries.wrote |= wrote
        if level:
            note(machine, level)
        return value
    caller = machine.frames[-1] if machine.frames else None
    context = context_of(machine, code, caller, registers)
    apart = code.signature is not None and code.signature.apart  # its context does not tell who calls
    place = None if apart else recalled.place_of(machine, code.key, (function, given), context)
    found = None if place is None else recalled.known(machine, place)
    if found is not None:
        if machine.watch is not None:
            machine.watch.recalled(machine, code, context)
        return recalled.repeated(machine, code.key, found)
    outer_wrote, machine.summaries.wrote = machine.summaries.wrote, set()
    call = None if place is None else recalled.begun(machine)
    raised, version, provisional = machine.raised, machine.state.version, machine.summaries.provisional
    noted, machine.noted = machine.noted, 0
    outer, machine.asked_for = machine.asked_for, set()
    importing = bool(machine.catchers) and machine.catchers[-1].importing
    if importing:
        machine.catchers[-1].importing = False
    try:
        value = run_body(machine, function, registers, caller, context)
        level, machine.noted = machine.noted, max(machine.noted, noted)
        if call is not None and value is not UNBOUND:
            call.value, call.level = value, level
            recalled.ended(machine, place, code.key, call)
    finally:
        if call is not None:
            recalled.closed(machine, call)
        asked_for, machine.asked_for = machine.asked_for, outer
        outer |= asked_for
        wrote, machine.summaries.wrote = machine.summaries.wrote, outer_wrote
        outer_wrote |= wrote
        if importing:
            machine.catchers[-1].importing = True
    quiet = (
        machine.state.version == version and machine.raised == raised and machine.summaries.provisional == provisional
    )
    if quiet and value is not UNBOUND and not declared.is_model(function):
        machine.summaries.memo[key] = (value, level, asked_for, wrote)
        if machine.watch is not None:
            machine.watch.remember(key, code, context)
    return value


def _depth(machine: Engine, function: Function, registers: list[Value]) -> int:
    """How many calls of a function are running. A method of a library that comes back to another object is no recursion by itself:

    void on_configure() override {costmap->configure();}      each of them a node, whose method calls what the program says

    Where the program does go round in circles, its own functions are counted.
    """
    code = function.code
    running = [frame for frame in machine.frames if frame.code is code]
    if running and registers and declared.is_model(function):
        running = [frame for frame in running if frame.registers[0] == registers[0]]
    return len(running)


def is_too_deep(machine: Engine, code: Code, registers: list[Value], depth: int, limit: int) -> bool:
    """Whether a call inside so many others of its function shares what it does with all that are deeper."""
    if not depth and machine.summaries.sure:
        machine.summaries.sure.pop(code.key, None)
    return depth >= limit and not _is_sure(machine, code, registers, depth)


def _is_sure(machine: Engine, code: Code, registers: list[Value], depth: int) -> bool:
    """Whether a recursion is followed however deep it is: each way that leads there is known to be taken, so that it ends where the program's does.

    return name if not level else path(level - 1, name + "/sub")      with a known level

    Of what stands for many objects that is not known, whatever the ways are.
    """
    if machine.precision.coarse or depth >= _DEEPEST:
        return False
    if any(v.__class__ is Ref and machine.obj(v).many for v in registers):
        return False
    first = next((n for n, frame in enumerate(machine.frames) if frame.code is code), 0)
    if any(frame.uncertain for frame in machine.frames[first:]):
        return False
    sure = machine.summaries.sure[code.key] = machine.summaries.sure.get(code.key, 0) + 1
    return sure <= _MOST_SURE


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
