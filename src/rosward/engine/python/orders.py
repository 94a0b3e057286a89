# SPDX-License-Identifier: Apache-2.0
"""Does what a loop does depend on the order of what it runs over? That of a set is not known.

for t in topics: listen(t)                    each has its turn, whichever is first
for t in topics: if ready(t): break           which are left out depends on the order
for t in topics: listen(f'{t}_{i}'); i += 1   what one turn leaves to the next depends on it
"""

from __future__ import annotations

from collections.abc import Iterator

from rosward.ir import ops
from rosward.ir.op import Block, Op, walk
from rosward.ir.registers import reads, writes

_Place = tuple[str, int | str]
"""What an operation reads or writes: a register, a cell, a variable, or the attribute of that name of some object."""


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
    """Whether a turn reads what it writes before it has written it. What it does to an object that it only calls is not seen."""
    changed = {place for inner in walk(op.body) for place in _written(inner)}
    return bool(changed) and not changed.isdisjoint(_asked(op.body, {("register", op.item)}))


def _asked(block: Block, known: set[_Place]) -> Iterator[_Place]:
    """What a block reads before it has surely written it; `known` is what was written before, to which it adds."""
    for op in block:
        yield from (place for place in _read(op) if place not in known)
        known.update(_written(op))
        blocks: tuple[Block, ...] = getattr(op, "blocks", ())
        if blocks:
            ends = []
            for each in blocks:
                inner = set(known)
                yield from _asked(each, inner)
                ends.append(inner)
            known |= set.intersection(*ends) if isinstance(op, ops.If) else ends[0]


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
