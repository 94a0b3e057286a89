# SPDX-License-Identifier: Apache-2.0
"""Which reads of local variables may find none, so that Python raises UnboundLocalError?

if fast: rate = 50
return rate                 perhaps: not every way to here assigns it
for topic in topics: ...
print(topic)                perhaps: there may have been no turn

An assignment on every way to a read counts, whatever the conditions on that way say: a loop may have no turn. Whether it has one is known where the
program is interpreted: a mark goes with each variable that is found here (`Body.watch`).
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Sequence
from typing import Final

_Names = frozenset[str]
_State = _Names | None
"""What surely has a value; None where no execution comes."""

_SCOPES: Final = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)
_COMPREHENSIONS: Final = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
_LOOPS: Final = (ast.For, ast.AsyncFor, ast.While)
_TRIES: Final = tuple(getattr(ast, name) for name in ("Try", "TryStar") if hasattr(ast, name))


def unset_reads(body: Sequence[ast.stmt], given: Iterable[str], names: Iterable[str]) -> set[ast.Name]:
    """The reads of `names` in the body of a function that may find no value; `given` are its parameters."""
    walk = _Walk(frozenset(names) - frozenset(given))
    if walk.names:
        walk.suite(body, frozenset())
    return walk.found


def _both(left: _State, right: _State) -> _State:
    if left is None or right is None:
        return right if left is None else left
    return left & right


class _Walk:
    """One way through a function, with what is assigned on it."""

    __slots__ = ("broken", "continued", "found", "names")

    def __init__(self, names: _Names) -> None:
        self.names = names
        self.found: set[ast.Name] = set()
        self.broken: _State = None  # at the words `break` of the innermost loop
        self.continued: _State = None  # at its words `continue`

    def suite(self, nodes: Sequence[ast.stmt], state: _State) -> _State:
        """Behind some statements. What no execution reaches is not looked at."""
        for node in nodes:
            if state is None:
                return None
            state = self._statement(node, state)
        return state

    def _statement(self, node: ast.stmt, state: _Names) -> _State:
        if isinstance(node, ast.If):
            state = self._expression(node.test, state)
            return _both(self.suite(node.body, state), self.suite(node.orelse, state))
        if isinstance(node, _LOOPS):
            return self._loop(node, state)
        if isinstance(node, _TRIES):
            return self._try(node, state)
        if isinstance(node, (ast.With, ast.AsyncWith)):
            return self._with(node, state)
        if isinstance(node, ast.Match):
            return self._match(node, state)
        if isinstance(node, (ast.Return, ast.Raise)):
            self._children(node, state)
            return None
        if isinstance(node, ast.Break):
            self.broken = _both(self.broken, state)
            return None
        if isinstance(node, ast.Continue):
            self.continued = _both(self.continued, state)
            return None
        return self._simple(node, state)

    def _simple(self, node: ast.stmt, state: _Names) -> _State:
        if isinstance(node, ast.AugAssign):
            if isinstance(node.target, ast.Name):
                self._read(node.target, state)
            return self._children(node, state)
        if isinstance(node, ast.AnnAssign):
            if node.value is None:
                return state
            return self._expression(node.target, self._expression(node.value, state))
        if isinstance(node, ast.Assign):
            state = self._expression(node.value, state)
            for target in node.targets:
                state = self._expression(target, state)
            return state
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            return state | {(a.asname or a.name).partition(".")[0] for a in node.names}
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            return self._expression(node, state) | {node.name}
        return self._children(node, state)

    def _loop(self, node: ast.For | ast.AsyncFor | ast.While, state: _Names) -> _State:
        outer = self.broken, self.continued
        self.broken = self.continued = None
        ended: _State
        if isinstance(node, ast.While):
            ended = inside = self._expression(node.test, state)
            turns = isinstance(node.test, ast.Constant) and bool(node.test.value)
        else:
            ended = self._expression(node.iter, state)
            inside = self._expression(node.target, ended)
            turns = _has_elements(node.iter)
        turned = self.suite(node.body, inside)
        if turns:
            ended = None if isinstance(node, ast.While) else _both(turned, self.continued)
        behind = _both(self.suite(node.orelse, ended), self.broken)
        self.broken, self.continued = outer
        return behind

    def _try(self, node: ast.Try, state: _Names) -> _State:
        removed = {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Del)}
        removed |= {handler.name for handler in node.handlers if handler.name}
        least = state - removed
        behind = self.suite(node.orelse, self.suite(node.body, state))
        for handler in node.handlers:
            caught = least if handler.type is None else self._expression(handler.type, least)
            own = self.suite(handler.body, _bound(caught, handler))
            behind = _both(behind, None if own is None else own - {handler.name or ""})
        final = self.suite(node.finalbody, least)
        if final is None or behind is None:
            return None
        return behind | (final - least)

    def _with(self, node: ast.With | ast.AsyncWith, state: _Names) -> _State:
        for item in node.items:
            state = self._expression(item.context_expr, state)
            if item.optional_vars is not None:
                state = self._expression(item.optional_vars, state)
        inside = self.suite(node.body, state)
        return state if inside is None else state & inside  # it may swallow what leaves it

    def _match(self, node: ast.Match, state: _Names) -> _State:
        state = self._expression(node.subject, state)
        behind: _State = state
        for case in node.cases:
            inside = state | {n.name for n in ast.walk(case.pattern) if getattr(n, "name", None)}  # type: ignore[attr-defined]
            inside |= {n.rest for n in ast.walk(case.pattern) if isinstance(n, ast.MatchMapping) and n.rest}
            if case.guard is not None:
                inside = self._expression(case.guard, inside)
            behind = _both(behind, self.suite(case.body, inside))
        return behind

    def _expression(self, node: ast.AST, state: _Names) -> _Names:
        """Behind an expression, or the target of an assignment."""
        if isinstance(node, ast.Name):
            return self._name(node, state)
        if isinstance(node, ast.Constant):
            return state
        if isinstance(node, ast.Attribute):
            return self._expression(node.value, state)
        if isinstance(node, _SCOPES):
            return self._definition(node, state)
        if isinstance(node, _COMPREHENSIONS):
            return self._expression(node.generators[0].iter, state)
        if isinstance(node, ast.NamedExpr):
            return self._expression(node.value, state) | {node.target.id}
        if isinstance(node, ast.BoolOp):
            first = self._expression(node.values[0], state)
            inside = first
            for value in node.values[1:]:
                inside = self._expression(value, inside)
            return first
        if isinstance(node, ast.IfExp):
            state = self._expression(node.test, state)
            return self._expression(node.body, state) & self._expression(node.orelse, state)
        return self._children(node, state)

    def _children(self, node: ast.AST, state: _Names) -> _Names:
        for field in node._fields:
            child = getattr(node, field, None)
            if isinstance(child, list):
                for each in child:
                    if isinstance(each, ast.AST):
                        state = self._expression(each, state)
            elif isinstance(child, ast.AST) and field != "ctx":
                state = self._expression(child, state)
        return state

    def _definition(self, node: ast.AST, state: _Names) -> _Names:
        """What is evaluated where a function or class is made; what it captures is not looked at here."""
        outside: list[ast.AST] = list(getattr(node, "decorator_list", ()))
        if isinstance(node, ast.ClassDef):
            outside += [*node.bases, *node.keywords]
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            outside += [*node.args.defaults, *(d for d in node.args.kw_defaults if d is not None)]
        for part in outside:
            state = self._expression(part, state)
        return state

    def _name(self, node: ast.Name, state: _Names) -> _Names:
        if isinstance(node.ctx, ast.Store):
            return state | {node.id}
        self._read(node, state)
        return state - {node.id} if isinstance(node.ctx, ast.Del) else state

    def _read(self, node: ast.Name, state: _Names) -> None:
        if node.id in self.names and node.id not in state:
            self.found.add(node)


def _has_elements(node: ast.expr) -> bool:
    """Whether a loop over this has a turn: `(1, 2)`, `range(5)`."""
    if isinstance(node, (ast.Tuple, ast.List, ast.Set)):
        return any(not isinstance(element, ast.Starred) for element in node.elts)
    if (
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "range"
        and len(node.args) == 1
    ):
        node = node.args[0]
        return isinstance(node, ast.Constant) and isinstance(node.value, int) and node.value > 0
    return isinstance(node, ast.Constant) and bool(node.value)


def _bound(state: _Names, handler: ast.ExceptHandler) -> _Names:
    return state | {handler.name} if handler.name else state
