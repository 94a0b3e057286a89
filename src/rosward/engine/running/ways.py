# SPDX-License-Identifier: Apache-2.0
"""How do the blocks of a body lead to its yields?"""

from __future__ import annotations

from typing import Final

from rosward.domain.suspended import EACH, YIELD
from rosward.ir import ops

Way = tuple[tuple[int, str, ops.Op], ...]
"""How blocks lead to a yield: the index in each, the part that leads on, and the operation."""

_PARTS: Final[dict[type[ops.Op], tuple[tuple[str, str], ...]]] = {
    ops.If: (("then", "then"), ("orelse", "orelse")),
    ops.While: (("condition", "condition"), ("turn", "body"), ("orelse", "orelse")),
    ops.ForEach: ((EACH, "body"), ("orelse", "orelse")),
    ops.With: (("body", "body"),),
    ops.Try: (("body", "body"), ("orelse", "orelse"), ("final", "final")),
}


def parts(op: ops.Op) -> list[tuple[str, ops.Block]]:
    """The blocks of an operation, each under the name of its part."""
    found = [(part, getattr(op, field)) for part, field in _PARTS.get(op.__class__, ())]
    if isinstance(op, ops.Try):
        for number, handler in enumerate(op.handlers):
            found += [(f"handler {number}", handler.body), (f"match {number}", handler.match)]
    return found


def find_ways(block: ops.Block, before: Way, found: dict[int, Way]) -> None:
    """Note the way to each yield of a block, by the number of its operation."""
    for index, op in enumerate(block):
        if isinstance(op, ops.Yield):
            found[op.number] = (*before, (index, YIELD if op.many else "", op))
        for part, inner in parts(op):
            find_ways(inner, (*before, (index, part, op)), found)
