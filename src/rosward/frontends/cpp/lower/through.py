# SPDX-License-Identifier: Apache-2.0
"""Members behind pointers to them: `o.*m`, `p->*m`, `(o.*f)(a)`, `o.*m = a`, `2 * o.*m`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rosward.frontends.cpp.lower.survey import assigned_member, member_behind, operator_of, through_member
from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp import Argued, Assign, Invoke, Read

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.lower.body import Body, Want

Pair = tuple["Node", "Node"]
"""The object, or the pointer to it, and the pointer to its member."""


def through(body: Body, node: Node, want: Want) -> int:
    """`o.*m`, `o.*m = a`."""
    pair, assigned = through_member(node), assigned_member(node)
    if pair is not None:
        return body.given(node, through_pointer(body, node, pair), want)
    return body.unknown(node, "syntax") if assigned is None else _assigned(body, node, assigned, want)


def _assigned(body: Body, node: Node, pair: Pair, want: Want) -> int:
    obj, assignment = pair
    pointer = assignment.child_by_field_name("left")
    if pointer is None:
        return body.unknown(node, "syntax")
    src = body.value(assignment.child_by_field_name("right"))
    body.assignments += 1
    slot = through_pointer(body, node, (obj, pointer))
    dst = NO_REGISTER if want == "effect" else body.register()
    body.emit(Assign(*body.place(node), dst, operator_of(assignment), slot, src, seen=[], static=NO_REGISTER))
    return dst if want == "effect" else body.given(node, dst, want)


def through_pointer(body: Body, node: Node, pair: Pair, arguments: tuple[Argued, ...] = ()) -> int:
    """`(o.*m)(…)` is `std::invoke(m, o, …)`; so is `o.*m` of a field."""
    left, right = pair
    obj = 0 if left.type == "this" and body.has_this else body.slot(left)
    func = body.value(right)
    dst = body.register()
    body.emit(Invoke(*body.place(node), dst, func, (Argued(obj, "slot"), *arguments)))
    return dst


def value_through(body: Body, node: Node, pair: Pair) -> int:
    """What stands in a member behind a pointer to it."""
    dst = body.register()
    body.emit(Read(*body.place(node), dst, through_pointer(body, node, pair)))
    return dst


def factors(chain: Sequence[Node]) -> Iterator[tuple[Node, Node | None, Pair | None]]:
    """The links of a chain of operators, the innermost last, with what stands behind each of them; of `2 * o.*m`, that is a member."""
    links = list(reversed(chain))
    for link, following in zip(links, [*links[1:], None], strict=False):
        if member_behind(link) is not None:
            continue
        right = link.child_by_field_name("right")
        member = member_behind(following) if following is not None else None
        yield (link, right, None) if member is None or right is None else (link, None, (right, member))
