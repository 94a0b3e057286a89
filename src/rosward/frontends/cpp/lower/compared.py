# SPDX-License-Identifier: Apache-2.0
"""`a < b && c > (d)`: a comparison of variables, which the parser takes for a call of the function `a<b && c>`.

Whether `a` is a template it does not know. A variable of the function is none; of other names it is said by what stands in the brackets, and
by the file.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.names import name
from rosward.frontends.cpp.lower.survey import operator_of, word
from rosward.ir.control import If
from rosward.ir.core import NO_REGISTER, Compare, Const, Move

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.lower.body import Body
    from rosward.ir.op import Block

_LOGICAL: Final = frozenset({"&&", "||"})
_TIGHTER: Final = frozenset({"+", "-", "*", "/", "%", "<<", ">>"})


def compared(body: Body, node: Node, function: Node, listed: Node | None) -> int | None:
    """What the comparison gives; None where it is a call."""
    left, inner = function.child_by_field_name("name"), function.child_by_field_name("arguments")
    within = [] if inner is None else inner.named_children
    right = [] if listed is None else listed.named_children
    if left is None or left.type != "identifier" or len(within) != 1 or len(right) != 1:
        return None
    middle = within[0]
    if middle.type == "type_descriptor":
        middle = middle.named_children[0]
    variable = body.variable(word(left))
    if variable is None and (not _is_logical(middle) or _is_template(node, word(left))):
        return None
    if variable is not None and (variable.raw or variable.path):
        return None
    parent = node.parent
    if parent is not None and parent.type == "binary_expression" and operator_of(parent) in _TIGHTER:
        return body.unknown(node, "syntax")  # `a < b && c > (d) + 1`, of which `(d) + 1` is the last part
    return _parts(body, middle, left, right[0])


def _is_logical(node: Node) -> bool:
    return node.type == "binary_expression" and operator_of(node) in _LOGICAL


def _is_template(node: Node, name_: str) -> bool:
    """Whether the file declares a function template of this name."""
    root = node
    while root.parent is not None:
        root = root.parent
    declared = rb"\btemplate\s*<[^;{}]*\b" + re.escape(name_.encode()) + rb"\s*\("
    return re.search(declared, root.text or b"") is not None


def _parts(body: Body, node: Node, left: Node | None, right: Node | None) -> int:
    """`node` with `left <` before its first operand, and `> right` behind its last."""
    place = body.place(node)
    if not _is_logical(node):
        first = NO_REGISTER if left is None else body.value(left)
        value = name(body, node, "value") if node.type == "type_identifier" else body.value(node)
        if left is not None:
            value = _compare(body, node, "<", first, value)
        return value if right is None else _compare(body, node, ">", value, body.value(right))
    dst, outer = body.register(), body.ops
    sides = node.child_by_field_name("left"), node.child_by_field_name("right")
    if sides[0] is None or sides[1] is None:
        return body.unknown(node, "syntax")
    is_and = operator_of(node) == "&&"
    body.emit(Move(*place, dst, _parts(body, sides[0], left, None)))
    inner: Block = []
    decided: Block = [Const(*place, dst, not is_and)]
    body.emit(If(*place, dst, *((inner, decided) if is_and else (decided, inner))))
    body.ops = inner
    body.emit(Move(*place, dst, _parts(body, sides[1], None, right)))
    body.ops = outer
    return dst


def _compare(body: Body, node: Node, operator: str, left: int, right: int) -> int:
    dst = body.register()
    body.emit(Compare(*body.place(node), dst, operator, left, right))
    return dst
