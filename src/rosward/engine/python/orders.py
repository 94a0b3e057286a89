# SPDX-License-Identifier: Apache-2.0
"""Does what a loop does depend on the order of what it runs over? That of a set is not known.

for t in topics: listen(t)                    each has its turn, whichever is first
for t in topics: if ready(t): break           which are left out depends on the order
for t in topics: listen(f'{t}_{i}'); i += 1   what one turn leaves to the next depends on it
for t in topics: listen(t); i += 1             what depends on it is nothing but a counter
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rosward.ir import ops
from rosward.ir.op import Block, Op, walk
from rosward.ir.registers import reads, writes

_Place = tuple[str, int | str]
"""What an operation reads or writes: a register, a cell, a variable, or the attribute of that name of some object."""


_PURE: Final = (
    ops.Assume, ops.Binary, ops.Build, ops.Compare, ops.Const, ops.Format, ops.LoadItem, ops.Move, ops.Unary, ops.Unpack,
)  # fmt: skip
"""Operations that make something of what registers hold, and of nothing else."""


def tells_order(op: ops.ForEach) -> bool:
    """Whether a turn may end the loop, or finds what an earlier turn has left: a counter, a text that grows."""
    return _may_leave(op.body, nested=False) or _hands_on(op)


def _may_leave(block: Block, *, nested: bool) -> bool:
    """Whether a turn may end the loop, or the function that it stands in, in words of the program."""
    for op in block:
        if op.__class__ in (ops.Return, ops.Raise) or (op.__class__ is ops.Break and not nested):
            return True
        inside = nested or op.__class__ in (ops.ForEach, ops.While)
        if any(_may_leave(each, nested=inside) for each in getattr(op, "blocks", ())):
            return True
    return False


def _hands_on(op: ops.ForEach) -> bool:
    """Whether a turn reads what it writes before it has written it, and does something with it, or with its element to it.

    What it does to an object that it only calls is not seen.
    """
    item: _Place = ("register", op.item)
    changed = {place for inner in walk(op.body) for place in _written(inner)}
    handed = changed.intersection(_asked(op.body, {item})) if changed else changed
    return any(kind != "register" for kind, _ in handed) or _mixes(op.body, handed, set(handed), {item})


def _mixes(block: Block, handed: set[_Place], counted: set[_Place], varying: set[_Place]) -> bool:
    """Whether more than variables of the function depends on what is handed on to them, or they on more than the number of the turn.

    `counted`: what depends on that number alone, `varying`: what may be another for each element; both before the block, then behind it.
    """
    for op in block:
        inside = list(walk([op]))
        asked, written = {p for each in inside for p in _read(each)}, {p for each in inside for p in _written(each)}
        depends = not counted.isdisjoint(asked)
        if isinstance(op, ops.If) and ("register", op.test) not in varying:
            if ("register", op.test) in counted and not all(isinstance(each, _PURE) for each in inside[1:]):
                return True
            before = set(counted), set(varying)
            for way in (op.then, op.orelse):
                ends = set(before[0]), set(before[1])
                if _mixes(way, handed, *ends):
                    return True
                counted |= ends[0]
                varying |= ends[1]
            if ("register", op.test) in counted:
                counted |= written
            continue
        varies = not isinstance(op, _PURE) or not varying.isdisjoint(asked)
        if varies and (depends or not handed.isdisjoint(written)):
            return True
        for places, holds in ((counted, depends), (varying, varies)):
            if holds:
                places.update(written)
            else:
                places.difference_update(written - handed)
    return False


def _asked(block: Block, known: set[_Place]) -> Iterator[_Place]:
    """What a block reads before it has surely written it; `known` is what was written before, to which it adds."""
    for op in block:
        yield from (place for place in _read(op) if place not in known)
        known.update(_written(op))
        ends = []
        for way in _ways(op):
            inner = set(known)
            for each in way:
                yield from _asked(each, inner)
            if not any(each and each[-1].__class__ in _JUMPS for each in way):
                ends.append(inner)
        if ends:
            known |= set.intersection(*ends)


def _ways(op: Op) -> tuple[tuple[Block, ...], ...]:
    """The ways through the blocks of an operation: those of one way run one after the other."""
    if isinstance(op, ops.Try):
        return ((op.body, op.orelse, op.final), *((h.match, h.body, op.final) for h in op.handlers))
    if isinstance(op, ops.While):
        return ((op.condition, op.body), (op.condition, op.orelse))
    return tuple((each,) for each in getattr(op, "blocks", ()))


_JUMPS: Final = (ops.Return, ops.Raise, ops.Break, ops.Continue)


def _read(op: Op) -> Iterator[_Place]:
    yield from (("register", register) for register in reads(op))
    if isinstance(op, ops.LoadCell):
        yield ("cell", op.cell)
    elif isinstance(op, (ops.LoadGlobal, ops.LoadName)):
        yield ("name", op.name)
    elif isinstance(op, ops.LoadAttr):
        yield ("attribute", op.name)


def _written(op: Op) -> Iterator[_Place]:
    yield from (("register", register) for register in writes(op))
    if getattr(op, "narrowing", False):
        return
    if isinstance(op, ops.StoreCell):
        yield ("cell", op.cell)
    elif isinstance(op, (ops.StoreGlobal, ops.StoreName)):
        yield ("name", op.name)
    elif isinstance(op, ops.StoreAttr):
        yield ("attribute", op.name)
