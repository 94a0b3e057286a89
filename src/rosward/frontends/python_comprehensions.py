# SPDX-License-Identifier: Apache-2.0
"""Comprehensions become loops on the spot; a generator expression is taken for a list.

    [f(x) for x in xs if x]      %1 = []; for %2 in xs: if %2: { %3 = f(%2); append(%1, %3) }

Their variables are registers of their own, or fresh cells where a lambda inside captures them.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python_assignments import finish_target, target_register
from rosward.frontends.python_body import Body, Located
from rosward.frontends.python_expressions import build
from rosward.frontends.python_narrowing import branch
from rosward.frontends.python_scopes import Scope
from rosward.ir.ops import Block, ForEach, NewCell


def enter(body: Body, node: Located, scope: Scope) -> None:
    """Give the variables of an INLINE scope their places and go into it."""
    for name in scope.bound:
        if name in scope.captured:
            body.ops.append(NewCell(node.lineno, node.col_offset + 1, scope.captured[name]))
        else:
            scope.registers[name] = body.register()
    body.scope = scope


def _comprehension(kind: str, intrinsic: str) -> Callable[[Body, Any], int]:
    def lower(body: Body, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp) -> int:
        result = build(body, node, kind, ())
        first = body.expression(node.generators[0].iter)

        def add() -> None:
            parts = (node.key, node.value) if isinstance(node, ast.DictComp) else (node.elt,)
            body.intrinsic(parts[0], intrinsic, (result, *(body.expression(part) for part in parts)))

        outer_scope = body.scope
        enter(body, node, body.unit.symbols.by_node[node])
        _loops(body, node, first, add)
        body.scope = outer_scope
        return result

    return lower


def _loops(
    body: Body,
    node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp,
    iterable: int,
    add: Callable[[], None],
    number: int = 0,
) -> None:
    generator = node.generators[number]

    def element() -> None:
        if number + 1 == len(node.generators):
            add()
        else:
            inner = body.expression(node.generators[number + 1].iter)
            _loops(body, node, inner, add, number=number + 1)

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
    ast.ListComp: _comprehension("list", "append"),
    ast.GeneratorExp: _comprehension("list", "append"),
    ast.SetComp: _comprehension("set", "set_add"),
    ast.DictComp: _comprehension("dict", "dict_set"),
}
