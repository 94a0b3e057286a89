# SPDX-License-Identifier: Apache-2.0
"""Does an expression stand for a place? `x`, `o.x`, `o.*m`, `v[i]`, `*p`, `x = a`, `++x`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.survey import is_through, word

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.lower.variables import Variable
    from rosward.ir.cpp import Kind

_DEPTH: Final = 100
_LVALUES: Final = frozenset(
    {
        "identifier", "qualified_identifier", "field_expression", "subscript_expression", "template_function",
        "assignment_expression",
    }
)  # fmt: skip


def is_lvalue(node: Node) -> bool:
    """Whether an expression stands for a place, as far as its form tells."""
    waiting: list[Node | None] = [node]
    for _ in range(_DEPTH):
        if not waiting:
            return True
        here = waiting.pop()
        if here is None:
            return False
        kind = here.type
        if kind == "parenthesized_expression":
            waiting.append(here.named_children[0] if here.named_children else None)
        elif kind == "conditional_expression":
            waiting += [here.child_by_field_name("consequence"), here.child_by_field_name("alternative")]
        elif kind == "pointer_expression":
            if here.children[0].type != "*":
                return False
        elif kind == "update_expression":
            if here.children[0].type not in {"++", "--"}:
                return False
        elif kind == "binary_expression":
            if not is_through(here):
                return False
        elif kind not in _LVALUES:
            return False
    return False


_RESULTS: Final = frozenset(f"{each}_expression" for each in ("call", "cast", "conditional", "comma", "parenthesized"))
"""What may give a slot or not."""


def kind_of(node: Node, variable: Variable | None) -> Kind:
    """Of what kind an expression is as an argument; the variable that it names, if it is one."""
    if variable is not None and (kind := kind_of_variable(variable)) != "slot":
        return kind
    return "slot" if is_lvalue(node) else _of_result(node) if node.type in _RESULTS else "value"


def kind_of_variable(variable: Variable) -> Kind:
    """The same of a variable."""
    if variable.raw or not (variable.constant or variable.buffer):
        return "slot"
    return "constant" if variable.constant else "value"


def _of_result(node: Node) -> Kind:
    """Of what kind the result of a call or cast is, as an argument."""
    return kind_of_call(word(node.child_by_field_name("function") if node.type == "call_expression" else None))


def kind_of_call(text: str) -> Kind:
    """The same, by how the function is written."""
    if text.startswith("std::forward<"):
        return "forwarded"
    is_cast = text.startswith("static_cast<") and text.rstrip("> ").endswith("&&")
    return "constant" if text == "std::as_const" else "moved" if text == "std::move" or is_cast else "result"
