# SPDX-License-Identifier: Apache-2.0
"""Which arithmetic type has an expression, as far as it is written?

1u, sizeof(x), static_cast<long>(n)     unsigned int, unsigned long, long
unsigned n; n - 5                       unsigned int: below zero it begins again at its greatest value
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.survey import operator_of, word
from rosward.frontends.cpp.lower.types import builtin
from rosward.ir.arithmetic import INT, UNSIGNED, WIDE, common, same_type
from rosward.ir.cpp import Convert, InvokeMember, MakeType

if TYPE_CHECKING:
    from tree_sitter import Node

_DEPTH: Final = 12
_SUFFIXES: Final[Mapping[str, str]] = {"u": UNSIGNED, "l": "long", "ll": "long", "z": "long"}
_SIZES: Final = frozenset({"size", "length"})


def type_written(body: Body, node: Node | None, depth: int = 0) -> str:
    """The arithmetic type of an expression; '' where that does not show."""
    if node is None or depth > _DEPTH:
        return ""
    if node.type == "number_literal":
        return _of_literal(word(node).lower())
    if node.type == "identifier":
        variable = body.variable(word(node))
        return "" if variable is None or variable.raw else same_type(variable.builtin)
    if node.type == "sizeof_expression":
        return WIDE
    if node.type == "cast_expression":
        type_ = node.child_by_field_name("type")
        return _of_descriptor(type_)
    if node.type == "parenthesized_expression" and len(node.named_children) == 1:
        return type_written(body, node.named_children[0], depth + 1)
    if node.type == "binary_expression" and operator_of(node) in ("+", "-", "*", "/", "%"):
        left, right = (type_written(body, node.child_by_field_name(name), depth + 1) for name in ("left", "right"))
        return common(left, right)
    if node.type == "compound_literal_expression":  # `uint16_t{7}`
        return same_type(builtin(node.child_by_field_name("type")))
    function = node.child_by_field_name("function") if node.type == "call_expression" else None
    if function is not None and builtin(function):  # `uint16_t(7)`
        return same_type(builtin(function))
    if function is not None and function.type == "template_function":
        listed = function.child_by_field_name("arguments")
        if word(function.child_by_field_name("name")) == "static_cast" and listed is not None and listed.named_children:
            return _of_descriptor(listed.named_children[0])
    return ""


def _of_literal(text: str) -> str:
    if "." in text or ("e" in text and not text.startswith("0x")):
        return "float" if text.endswith("f") else "double"
    suffix = text[len(text.rstrip("ulz")) :]
    if not suffix:
        return INT
    return WIDE if "u" in suffix and len(suffix) > 1 else _SUFFIXES.get(suffix, "")


def _of_descriptor(node: Node | None) -> str:
    if node is None or node.type != "type_descriptor" or node.child_by_field_name("declarator") is not None:
        return ""
    return same_type(builtin(node.child_by_field_name("type")))


def bounded(body: Body, node: Node, type_: str, value: int) -> int:
    """A sum or product as its type has it: of what fell below zero in `a - b + c` it is not too great."""
    return difference(body, node, type_, value, ()) if type_ == UNSIGNED else value


def difference(body: Body, node: Node, type_: str, value: int, receivers: tuple[int, ...]) -> int:
    """A difference as its type has it: below zero it is a great number. `receivers`: of what the sizes were asked that are a part of it."""
    if type_ not in (UNSIGNED, WIDE) and not receivers:
        return value
    dst = body.register()
    if type_ in (UNSIGNED, WIDE):
        kind = body.register()
        body.emit(MakeType(*body.place(node), kind, type_))
        body.emit(Convert(*body.place(node), dst, value, kind, "wrapped"))
    else:
        body.emit(Convert(*body.place(node), dst, value, receivers[0], "size"))
    return dst


def receiver_of_size(body: Body, node: Node | None) -> tuple[int, ...]:
    """The register of what has just been asked for its size: `names_.size()`."""
    function = node.child_by_field_name("function") if node is not None and node.type == "call_expression" else None
    if (
        function is None
        or function.type != "field_expression"
        or word(function.child_by_field_name("field")) not in _SIZES
    ):
        return ()
    asked = next((op for op in reversed(body.ops[-2:]) if isinstance(op, InvokeMember)), None)
    return () if asked is None else (asked.obj,)
