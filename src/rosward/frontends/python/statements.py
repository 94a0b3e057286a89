# SPDX-License-Identifier: Apache-2.0
"""Statements that steer: if, loops, with, try, raise, assert. A new block for each part, in the IR as in the source."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python.assignments import delete_name, finish_target, target_register
from rosward.frontends.python.body import Body, misplaced
from rosward.frontends.python.narrowing import assume, branch, condition, guards
from rosward.frontends.python.scopes import PlaceKind, ScopeKind
from rosward.ir.ops import (
    NO_REGISTER,
    Argument,
    Block,
    Break,
    Call,
    Continue,
    ForEach,
    Handler,
    LoadGlobal,
    Raise,
    Try,
    While,
    With,
)


def _if(body: Body, node: ast.If) -> None:
    if body.owner.kind is ScopeKind.MODULE and _asks_for_main(node.test):
        body.unit.has_main = True
    if guards(body, node):
        return
    orelse = node.orelse
    branch(
        body,
        node,
        node.test,
        lambda: body.statements(node.body),
        (lambda: body.statements(orelse)) if orelse else None,
    )


def _asks_for_main(test: ast.expr) -> bool:
    if isinstance(test, ast.BoolOp):
        return any(_asks_for_main(value) for value in test.values)
    if not isinstance(test, ast.Compare) or len(test.ops) != 1 or not isinstance(test.ops[0], ast.Eq):
        return False
    sides = (test.left, test.comparators[0])
    named = any(isinstance(side, ast.Name) and side.id == "__name__" for side in sides)
    return named and any(isinstance(side, ast.Constant) and side.value == "__main__" for side in sides)


def _while(body: Body, node: ast.While) -> None:
    outer = body.ops
    test_block: Block = []
    body.ops = test_block
    test, true, false = condition(body, node.test)
    inner: Block = []
    body.ops = inner
    assume(body, node.test, true)
    body.loop_suite(node.body)
    orelse: Block = []
    body.ops = orelse
    assume(body, node.test, false)
    body.statements(node.orelse)
    body.ops = outer
    outer.append(While(node.lineno, node.col_offset + 1, test_block, test, inner, orelse))


def _for(body: Body, node: ast.For | ast.AsyncFor) -> None:
    is_async = isinstance(node, ast.AsyncFor)
    _require_coroutine(body, node, is_async, "async for")
    iterable = body.expression(node.iter)
    item = target_register(body, node.target)
    outer = body.ops
    inner: Block = []
    body.ops = inner
    finish_target(body, node.target, item)
    body.loop_suite(node.body)
    body.ops = outer
    orelse = body.suite(node.orelse)
    outer.append(ForEach(node.lineno, node.col_offset + 1, item, iterable, inner, orelse, is_async))


def _require_coroutine(body: Body, node: ast.stmt, is_async: bool, what: str) -> None:
    if is_async and not body.is_coroutine:
        raise misplaced(node, f"'{what}' outside async function")


def _with(body: Body, node: ast.With | ast.AsyncWith) -> None:
    is_async = isinstance(node, ast.AsyncWith)
    _require_coroutine(body, node, is_async, "async with")
    outer = body.ops
    for item in node.items:
        line, column = item.context_expr.lineno, item.context_expr.col_offset + 1
        context = body.expression(item.context_expr)
        bind = target_register(body, item.optional_vars)
        inner: Block = []
        body.ops.append(With(line, column, context, bind, inner, is_async))
        body.ops = inner
        finish_target(body, item.optional_vars, bind)
    body.statements(node.body)
    body.ops = outer


def _try(body: Body, node: ast.Try) -> None:
    tried = body.suite(node.body)
    handlers = tuple(_handler(body, handler) for handler in node.handlers)
    orelse = body.suite(node.orelse)
    final = body.suite(node.finalbody)
    star = type(node) is not ast.Try
    body.ops.append(Try(node.lineno, node.col_offset + 1, tried, handlers, orelse, final, star))


def _handler(body: Body, node: ast.ExceptHandler) -> Handler:
    outer = body.ops
    match: Block = []
    body.ops = match
    caught = NO_REGISTER if node.type is None else body.expression(node.type)
    inner: Block = []
    body.ops = inner
    bind = NO_REGISTER
    if body.owner.is_generator:  # what is being handled is kept where it waits
        bind = body.register()
        if node.name is not None:
            body.store(node, node.name, bind)
    elif node.name is not None:
        kind, number = body.place(node.name)
        bind = number if kind is PlaceKind.REGISTER else body.register()
        if kind is not PlaceKind.REGISTER:
            body.store(node, node.name, bind)
    body.statements(node.body)
    if node.name is not None:
        delete_name(body, node, node.name)
    body.ops = outer
    return Handler(match, caught, bind, inner)


def _raise(body: Body, node: ast.Raise) -> None:
    src = NO_REGISTER if node.exc is None else body.expression(node.exc)
    cause = NO_REGISTER if node.cause is None else body.expression(node.cause)
    body.ops.append(Raise(node.lineno, node.col_offset + 1, src, cause))


def _assert(body: Body, node: ast.Assert) -> None:
    line, column = node.lineno, node.col_offset + 1

    def fail() -> None:
        error = body.register()
        body.ops.append(LoadGlobal(line, column, error, "AssertionError"))
        given: Sequence[Argument] = ()
        if node.msg is not None:
            given = (Argument("positional", body.expression(node.msg)),)
        dst = body.register()
        body.ops.append(Call(line, column, dst, error, tuple(given)))
        body.ops.append(Raise(line, column, dst))

    branch(body, node, node.test, lambda: None, fail)


def _expression(body: Body, node: ast.Expr) -> None:
    if not isinstance(node.value, ast.Constant):
        body.expression(node.value)


def _break(body: Body, node: ast.Break) -> None:
    if not body.loops:
        raise misplaced(node, "'break' outside loop")
    body.ops.append(Break(node.lineno, node.col_offset + 1))


def _continue(body: Body, node: ast.Continue) -> None:
    if not body.loops:
        raise misplaced(node, "'continue' not properly in loop")
    body.ops.append(Continue(node.lineno, node.col_offset + 1))


def _nothing(_body: Body, _node: ast.stmt) -> None:
    """`pass`, `global`, `nonlocal`: no operation."""


def _type_alias(body: Body, node: Any) -> None:
    """`type X = …` (PEP 695): the value is never evaluated, unless somebody asks for it."""
    body.store(node.name, node.name.id, body.intrinsic(node, "doc", ()))


def _statements() -> dict[type, Callable[[Body, Any], None]]:
    table: dict[type, Callable[[Body, Any], None]] = {
        ast.If: _if,
        ast.While: _while,
        ast.For: _for,
        ast.AsyncFor: _for,
        ast.With: _with,
        ast.AsyncWith: _with,
        ast.Try: _try,
        ast.Raise: _raise,
        ast.Assert: _assert,
        ast.Expr: _expression,
        ast.Pass: _nothing,
        ast.Global: _nothing,
        ast.Nonlocal: _nothing,
        ast.Break: _break,
        ast.Continue: _continue,
    }
    for name, handler in (("TryStar", _try), ("TypeAlias", _type_alias)):
        kind = getattr(ast, name, None)
        if kind is not None:
            table[kind] = handler
    return table


STATEMENTS: Final[Mapping[type, Callable[[Body, Any], None]]] = _statements()
