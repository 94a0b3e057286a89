# SPDX-License-Identifier: Apache-2.0
"""What is computed of what stands in registers: arithmetic, comparisons, truth.

x = a + b          a and b, with all that stands in them
x = last is None   which object `last` is, not what is in it
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.values import Const
from rosward.flow import implicit, library
from rosward.flow.body import Body
from rosward.flow.calls import run_callees
from rosward.flow.marks import Mark, Root
from rosward.flow.reading import leads, opaque, truth
from rosward.ir import ops
from rosward.ir.registers import writes

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.walker import Walker

_NO_ROOTS: Final[frozenset[Root]] = frozenset()
_IDENTITY: Final = frozenset(("is", "is-not"))


def plain(walker: Walker, op: Any, body: Body, seen: Seen) -> None:
    """Any operation of which nothing else is known: what it writes depends on all that it reads."""
    mask = body.pc
    operands = [body.registers[register] for register in walker.sites.reads(op)]
    for mark in operands:
        mask |= walker.memory.deep(mark)
    if walker.implicit:
        mask |= implicit.given_by(walker, operands)
    given = run_callees(walker, op, body, seen)
    roots: frozenset[Root] = frozenset(seen.refs) if seen.refs else _NO_ROOTS
    if given is not None:
        mask |= implicit.made_of(walker, seen, given).mask
        roots |= leads(seen, given)
    for register in writes(op):
        body.registers[register] = Mark(mask, roots)


def _compute(walker: Walker, op: Any, body: Body, seen: Seen) -> None:
    """Arithmetic and comparisons: of objects of a library (arrays), they give a new one; `+=` may write to the one that is there."""
    operands = [
        body.registers[register] for register in walker.sites.reads(op)
    ]  # one of them may be where the result stands
    plain(walker, op, body, seen)
    found = body.registers[op.dst]
    if getattr(op, "inplace", False):
        left = operands[0]
        walker.memory.write_any(left.roots, Mark(found.mask, found.roots - left.roots), found.mask)
        body.registers[op.dst] = Mark(found.mask, found.roots | left.roots)
    elif any(opaque(mark) for mark in operands):
        root = library.expression(walker, body, op, operands)
        body.registers[op.dst] = Mark(found.mask, found.roots | {root})


def _unary(walker: Walker, op: ops.Unary, body: Body, seen: Seen) -> None:
    operand = body.registers[op.src]
    if op.operator != "not" or opaque(operand):
        _compute(walker, op, body, seen)
        return
    given = run_callees(walker, op, body, seen)
    body.registers[op.dst] = Mark(body.pc | truth(walker, operand) | (0 if given is None else given.mask))


def _is_with_nothing(op: ops.Compare, seen: Seen) -> bool:
    """`last == None`, `last != nullptr`, where no method of the program says it."""
    if op.operator not in ("==", "!=") or seen.callees or seen.bound or seen.summaries:
        return False
    return any(isinstance(found := seen.keys.get(r), Const) and found.value is None for r in (op.left, op.right))


def _compare(walker: Walker, op: ops.Compare, body: Body, seen: Seen) -> None:
    """A comparison; of a name, what it says of a parameter that is set is kept for the branch. Which object something is, is no content of it."""
    left, right = body.registers[op.left], body.registers[op.right]
    if op.operator in _IDENTITY or (_is_with_nothing(op, seen) and not opaque(left) and not opaque(right)):
        body.registers[op.dst] = Mark(body.pc | left.mask | right.mask)
        return
    _compute(walker, op, body, seen)
    names = [n for r in (op.left, op.right) if isinstance(n := seen.constant(r), str)]
    body.tests[op.dst] = names[0] if op.operator == "==" and len(names) == 1 else ""


TABLE: Final[dict[type[ops.Op], Any]] = {ops.Binary: _compute, ops.Unary: _unary, ops.Compare: _compare}
