# SPDX-License-Identifier: Apache-2.0
"""Comprehensions become loops on the spot; so does a generator expression of which all is taken at once (`list(f(x) for x in xs)`).

    [f(x) for x in xs if x]      %1 = []; for %2 in xs: if %2: { %3 = f(%2); append(%1, %3) }

Their variables are registers of their own, or fresh cells where a lambda inside captures them.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python.assignments import finish_target, target_register
from rosward.frontends.python.body import Body, Located
from rosward.frontends.python.expressions import build
from rosward.frontends.python.narrowing import branch
from rosward.frontends.python.scopes import Scope
from rosward.ir.ops import Block, ForEach, NewCell
from rosward.ir.python import BuildKind


def enter(body: Body, node: Located, scope: Scope) -> None:
    """Give the variables of an INLINE scope their places and go into it."""
    for name in scope.bound:
        if name in scope.captured:
            body.ops.append(NewCell(node.lineno, node.col_offset + 1, scope.captured[name]))
        else:
            scope.registers[name] = body.register()
    body.scope = scope


def comprehension(kind: BuildKind, intrinsic: str) -> Callable[[Body, Any], int]:
    """How a comprehension is lowered that makes such a container, adding to it by such an intrinsic."""

    def lower(body: Body, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp) -> int:
        result = build(body, node, kind, ())
        first = body.expression(node.generators[0].iter)

        def add() -> None:
            parts = (node.key, node.value) if isinstance(node, ast.DictComp) else (node.elt,)
            body.intrinsic(parts[0], intrinsic, (result, *(body.expression(part) for part in parts)))

        outer_scope = body.scope
        enter(body, node, body.unit.symbols.by_node[node])
        loops(body, node, first, add)
        body.scope = outer_scope
        return result

    return lower


def loops(
    body: Body,
    node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp,
    iterable: int,
    add: Callable[[], None],
    number: int = 0,
) -> None:
    """The loops and conditions of a comprehension; `add` lowers what happens to each element."""
    generator = node.generators[number]

    def element() -> None:
        if number + 1 == len(node.generators):
            add()
        else:
            inner = body.expression(node.generators[number + 1].iter)
            loops(body, node, inner, add, number=number + 1)

    def filtered(conditions: Sequence[ast.expr]) -> None:
        if conditions:
            branch(body, conditions[0], conditions[0], lambda: filtered(conditions[1:]), None)
        else:
            element()

    outer = body.ops
    loop_body: Block = []
    item = target_register(body, generator.target)
    line, column = generator.target.lineno, generator.target.col_offset + 1
    outer.append(ForEach(line, column, item, iterable, loop_body, [], bool(generator.is_async)))
    body.ops = loop_body
    finish_target(body, generator.target, item)
    filtered(generator.ifs)
    body.ops = outer


EXPRESSIONS: Final[Mapping[type, Callable[[Body, Any], int]]] = {
    ast.ListComp: comprehension("list", "append"),
    ast.SetComp: comprehension("set", "set_add"),
    ast.DictComp: comprehension("dict", "dict_set"),
}
