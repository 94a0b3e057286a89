# SPDX-License-Identifier: Apache-2.0
"""Which statements stand in a branch of an `#if` that nobody knows?

#ifdef WITH_GPS        UnknownValue macro
gps();                 If: gps()
#else                      else: imu()
imu();
#endif
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.frontends.cpp.lower import jumps
from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.prepared import Choice
from rosward.ir.control import If

if TYPE_CHECKING:
    from tree_sitter import Node


def statements(body: Body, nodes: Sequence[Node], *, split: bool = True) -> None:
    """Lower statements into the current block; `split`: at their labels."""
    found = jumps.parts(nodes) if split else []
    if len(found) > 1:
        node = nodes[-1]
        jumps.in_parts(
            body,
            found,
            lambda part: statements(body, part, split=False),
            lambda kind: body.shared.statements[f"{kind}_statement"](body, node),
        )
        return
    if not body.shared.choices:
        for node in nodes:
            body.statement(node)
        return
    around = body.shared.choices.around
    _grouped(body, [(node, around(node.start_point[0] + 1)) for node in nodes], frozenset())


def _grouped(body: Body, nodes: Sequence[tuple[Node, tuple[Choice, ...]]], inside: frozenset[int]) -> None:
    """`inside` are the conditions that are decided here."""
    position = 0
    while position < len(nodes):
        node, around = nodes[position]
        choice = next((each for each in around if each.condition not in inside), None)
        if choice is None:
            body.statement(node)
            position += 1
            continue
        end = position
        branches: dict[int, list[tuple[Node, tuple[Choice, ...]]]] = {}
        while end < len(nodes):
            same = next((each for each in nodes[end][1] if each.condition == choice.condition), None)
            if same is None:
                break
            branches.setdefault(same.branch, []).append(nodes[end])
            end += 1
        complete = choice.complete and body.shared.choices.branches(choice.condition) <= branches.keys()
        _one_of(body, node, list(branches.values()), complete, inside | {choice.condition})
        position = end


def _one_of(
    body: Body,
    node: Node,
    branches: list[list[tuple[Node, tuple[Choice, ...]]]],
    complete: bool,
    inside: frozenset[int],
) -> None:
    if complete and len(branches) == 1:
        _grouped(body, branches[0], inside)
        return
    test = body.unknown(node, "macro", "a condition of the preprocessor")
    first = body.block(lambda: _grouped(body, branches[0], inside))
    rest = branches[1:]
    second = body.block(lambda: _one_of(body, node, rest, complete, inside)) if rest else []
    body.emit(If(*body.place(node), test, first, second))
