# SPDX-License-Identifier: Apache-2.0
"""Does an expression stand for a place? `x`, `o.x`, `v[i]`, `*p`, `x = a`, `++x`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from tree_sitter import Node

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
        elif kind not in _LVALUES:
            return False
    return False
