# SPDX-License-Identifier: Apache-2.0
"""Generator expressions: a generator function that is called on the spot, with what its outermost loop runs over.

any(f(x) for x in xs)      %1 = function <genexpr>(.0): for x in .0: yield f(x);   %2 = call %1(xs);   %3 = call any(%2)
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any, Final

from rosward.frontends.python.body import Body
from rosward.frontends.python.comprehensions import comprehension, loops
from rosward.frontends.python.definitions import captures_of, lower_code, qualified
from rosward.frontends.python.scopes import ScopeKind
from rosward.frontends.python.symbols import FIRST
from rosward.ir.ops import Argument, Call, MakeFunction, Yield
from rosward.ir.program import Parameters

_AS_LIST: Final = comprehension("list", "append")


def _generator(body: Body, node: ast.GeneratorExp) -> int:
    scope = body.unit.symbols.by_node[node]
    if scope.kind is ScopeKind.INLINE:
        return _AS_LIST(body, node)
    line, column = node.lineno, node.col_offset + 1
    given = [body.expression(node.generators[0].iter), *(body.load(node, name) for name in scope.given)]

    def lower(inner: Body) -> None:
        def give() -> None:
            item = inner.expression(node.elt)
            inner.ops.append(Yield(line, column, inner.register(), item, False))

        loops(inner, node, scope.registers[FIRST], give)

    code = lower_code(
        body.unit,
        scope,
        lower,
        name="<genexpr>",
        qualname=qualified(body, "<genexpr>"),
        line=node.lineno,
        parameters=Parameters((FIRST, *scope.given), 0, None, (), None),
    )
    function, dst = body.register(), body.register()
    body.ops.append(MakeFunction(line, column, function, code, (), (), captures_of(body, code)))
    body.ops.append(Call(line, column, dst, function, tuple(Argument("positional", register) for register in given)))
    return dst


EXPRESSIONS: Final[Mapping[type, Callable[[Body, Any], int]]] = {ast.GeneratorExp: _generator}
