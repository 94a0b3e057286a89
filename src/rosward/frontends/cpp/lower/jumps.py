# SPDX-License-Identifier: Apache-2.0
"""`goto`: a block with labels is gone through as often as somebody jumps there, each time from the label on.

again: name += "b";                 going = true, from = 0; while (going) {going = false;
if (++turns < 3) goto again;            if (from <= 1) {name += "b"; if (++turns < 3) {from = 1; going = true; continue;}}}

A jump out of loops leaves one after the other. One into a block is not followed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.variables import Jumps
from rosward.ir.ops import Block, Break, Compare, Continue, If, While

if TYPE_CHECKING:
    from tree_sitter import Node

__all__ = ["behind_loop", "goto", "in_parts", "leaves", "parts"]

_LABEL: Final = "labeled_statement"
_APART: Final = frozenset({"lambda_expression", "class_specifier", "struct_specifier", "function_definition"})
_LEAVING: Final = ("break", "continue")
_MOST: Final = 40
"""So many labels of one block."""


def _label(node: Node) -> str:
    """What a statement is called; '' where it has no label."""
    return _target(node) if node.type == _LABEL else ""


def _target(node: Node) -> str:
    """The label of such a statement, or of a `goto`."""
    name = node.child_by_field_name("label")
    return "" if name is None or name.text is None else name.text.decode("utf-8", "replace")


def _inside(nodes: Sequence[Node], but: frozenset[str]) -> Iterator[Node]:
    """What stands within statements, but not within these."""
    waiting = list(nodes)
    while waiting:
        node = waiting.pop()
        yield node
        if node.type not in but:
            waiting += node.named_children


def parts(nodes: Sequence[Node]) -> list[list[Node]]:
    """The statements of a block, a part for each label that somebody jumps to; one part where none is followed."""
    labels = {name for node in nodes if (name := _label(node))}
    if not labels:
        return [list(nodes)]
    wanted = {_target(node) for node in _inside(nodes, _APART) if node.type == "goto_statement"} & labels
    if not wanted or len(wanted) > _MOST:
        return [list(nodes)]
    found: list[list[Node]] = [[]]
    for node in nodes:
        if _label(node) in wanted:
            found.append([])
        found[-1].append(node)
    return found


def in_parts(
    body: Body, found: list[list[Node]], lower: Callable[[Sequence[Node]], None], leave: Callable[[str], None]
) -> None:
    """Lower a block with labels; `leave` lowers a `break` or `continue` behind it.

    Registers of its own are below those of all variables, which outlive a turn.
    """
    node = next(each for part in found for each in part)
    start, going, stays = body.constant(node, 0), body.constant(node, True), body.constant(node, False)
    leaving = {kind: body.constant(node, False) for kind in _LEAVING} if body.loops else {}
    tests = [(number, body.register(), body.constant(node, number)) for number, part in enumerate(found) if part]
    body.floor = body.free_register
    numbers = {_label(part[0]): number for number, part in enumerate(found) if part and _label(part[0])}
    body.jumps.append(Jumps(len(body.loops), len(body.scopes), numbers, start, going, leaving, []))

    def turn() -> None:
        body.move(node, going, stays)
        for number, test, own in tests:
            place = body.place(found[number][0])
            body.emit(Compare(*place, test, "<=", start, own))
            then: Block = body.block(lambda: lower(found[number]))  # noqa: B023 - it is called at once
            body.emit(If(*place, test, then, []))

    inner = body.block(turn)
    body.jumps.pop()
    body.emit(While(*body.place(node), [], going, inner, []))
    for outer in body.jumps:
        if outer.depths:
            body.emit(If(*body.place(node), outer.going, body.block(lambda: _on(body, node, outer)), []))  # noqa: B023
    for kind, register in leaving.items():
        body.emit(If(*body.place(node), register, body.block(lambda: leave(kind)), []))  # noqa: B023 - it is called at once


def behind_loop(body: Body, node: Node) -> None:
    """A loop has ended, or a jump has left it, which goes on to its label."""
    for jumps in body.jumps:
        if any(depth > len(body.loops) for depth in jumps.depths):
            body.emit(If(*body.place(node), jumps.going, body.block(lambda: _on(body, node, jumps)), []))  # noqa: B023


def _on(body: Body, node: Node, jumps: Jumps) -> None:
    """Go on to a label, or first out of one more loop, or block with labels."""
    inner = body.jumps[-1]
    if inner.loops < len(body.loops):
        scopes = body.loops[-1].scopes
    else:
        scopes = inner.scopes
    body.end_objects(node, body.scopes[scopes:])
    there = inner is jumps and jumps.loops == len(body.loops)
    body.emit(Continue(*body.place(node)) if there else Break(*body.place(node)))


def leaves(body: Body, node: Node, kind: str) -> bool:
    """Whether a `break` or `continue` is of a loop around a block with labels, which is left first."""
    jumps = body.jumps[-1] if body.jumps else None
    if jumps is None or jumps.loops != len(body.loops) or not jumps.leaving:
        return False
    body.end_objects(node, body.scopes[jumps.scopes :])
    body.move(node, jumps.leaving[kind], body.constant(node, True))
    body.emit(Break(*body.place(node)))
    return True


def goto(body: Body, node: Node) -> None:
    """`goto label;`"""
    name = _target(node)
    found = next((jumps for jumps in reversed(body.jumps) if name in jumps.numbers), None)
    if found is None:
        body.unknown(node, "language", "goto")
        return
    found.depths.append(len(body.loops))
    body.move(node, found.start, body.constant(node, found.numbers[name]))
    body.move(node, found.going, body.constant(node, True))
    _on(body, node, found)
