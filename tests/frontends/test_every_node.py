# SPDX-License-Identifier: Apache-2.0
"""No node type of the running Python is skipped: each kind of statement, expression and pattern has a lowering."""

from __future__ import annotations

import ast

import pytest

from rosward.frontends.python import patterns
from rosward.frontends.python.body import Body, Unit
from rosward.frontends.python.expressions import BINARY, UNARY
from rosward.frontends.python.module import EXPRESSIONS, STATEMENTS, lower_module
from rosward.frontends.python.narrowing import COMPARE
from rosward.frontends.python.symbols import collect
from rosward.ir.text import code_text

DEPRECATED = {"Num", "Str", "Bytes", "NameConstant", "Ellipsis", "Index", "ExtSlice", "Suite", "AugLoad", "AugStore"}


def kinds(base: type[ast.AST]) -> list[type[ast.AST]]:
    return sorted((kind for kind in base.__subclasses__() if kind.__name__ not in DEPRECATED), key=lambda k: k.__name__)


@pytest.mark.parametrize("kind", kinds(ast.stmt))
def test_statement(kind: type[ast.AST]) -> None:
    assert kind in STATEMENTS


@pytest.mark.parametrize("kind", kinds(ast.expr))
def test_expression(kind: type[ast.AST]) -> None:
    assert kind in EXPRESSIONS


@pytest.mark.parametrize("kind", kinds(ast.pattern))
def test_pattern(kind: type[ast.AST]) -> None:
    assert kind in patterns.PATTERNS


def test_operators() -> None:
    assert set(kinds(ast.operator)) == set(BINARY)
    assert set(kinds(ast.unaryop)) == set(UNARY)
    assert set(kinds(ast.cmpop)) == set(COMPARE)


def test_unknown_node_is_said() -> None:
    """A node type of a Python to come becomes `unsupported`, not nothing."""
    tree = ast.parse("x")
    symbols = collect(tree)
    body = Body(Unit("a.py", "a.py", symbols, {}, {}), symbols.by_node[tree], "<module>")
    body.statements(tree.body)
    assert [type(op).__name__ for op in body.ops] == ["Intrinsic"]
    assert "unsupported" not in code_text(lower_module("x", "a.py").code)
