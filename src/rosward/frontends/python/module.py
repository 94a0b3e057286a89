# SPDX-License-Identifier: Apache-2.0
"""From the text of a Python file to its IR.

    lower_module("import rclpy\n", "talker.py").imports == {"rclpy"}

A text that can't be read raises `FrontendError`. Nothing of it is run.
"""

from __future__ import annotations

import ast
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.front_end import FrontendError
from rosward.frontends.python import (
    assignments,
    comprehensions,
    definitions,
    expressions,
    generators,
    patterns,
    statements,
)
from rosward.frontends.python.body import Body, Unit, misplaced
from rosward.frontends.python.definitions import lower_code
from rosward.frontends.python.fstrings import parse_with_fstrings
from rosward.frontends.python.loads import loads
from rosward.frontends.python.newer import older
from rosward.frontends.python.scopes import link, unresolved_nonlocal
from rosward.frontends.python.symbols import collect
from rosward.ir.ops import Const, StoreGlobal
from rosward.ir.program import Module

__all__ = ["EXPRESSIONS", "STATEMENTS", "FrontendError", "lower_module"]

EXPRESSIONS: Final[Mapping[type, Callable[[Body, Any], int]]] = {
    **expressions.EXPRESSIONS,
    **comprehensions.EXPRESSIONS,
    **definitions.EXPRESSIONS,
    **generators.EXPRESSIONS,
}

STATEMENTS: Final[Mapping[type, Callable[[Body, Any], None]]] = {
    **assignments.STATEMENTS,
    **definitions.STATEMENTS,
    **statements.STATEMENTS,
    **patterns.STATEMENTS,
}

_PYTHON_2_MESSAGE: Final = re.compile(
    r"Missing parentheses in call to '(print|exec)'"
    r"|multiple exception types must be parenthesized"
    r"|leading zeros in decimal integer literals"
)
_PYTHON_2_LINE: Final = re.compile(
    r"\s*print\b(?!\s*[(=.])"  # print x
    r"|\s*exec\s+[\w'\"]"  # exec code
    r"|\s*except\s+[\w.]+\s*,\s*\w+\s*:"  # except E, e:
    r"|\s*raise\s+[\w.]+\s*,"  # raise E, 'text'
    r"|.*`[^`]+`"  # `x`
    r"|.*<>"
    r"|.*\b[uU][rR]['\"]"
    r"|.*\b(0[0-7]+|\d+[lL])\b"  # 0777, 10L
)


def lower_module(text: str, file: str, origins: Sequence[int] = (), name: str = "") -> Module:
    """Lower a file; see `front_end.Lower`."""
    text = text.removeprefix("\ufeff")
    tree = _parse(text)
    if origins:
        _move(tree, origins)
    lines = text.count("\n") + (not text.endswith("\n") and bool(text))
    try:
        return _lower(tree, file, name or file, lines, loads(tree, text))
    except (RecursionError, MemoryError) as error:
        raise FrontendError("depth", "the code is nested too deeply to be analysed", 1, 1) from error


def _move(tree: ast.Module, origins: Sequence[int]) -> None:
    """Let all that a tree holds stand in the lines that it comes from, each place apart: the columns count them."""
    columns: dict[int, dict[tuple[int, int], int]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.expr | ast.stmt | ast.excepthandler | ast.arg | ast.keyword | ast.alias):
            line = origins[node.lineno - 1]
            here = columns.setdefault(line, {})
            node.col_offset = here.setdefault((node.lineno, node.col_offset), len(here))
            node.lineno = node.end_lineno = line


def _lower(tree: ast.Module, file: str, name: str, lines: int, loaded: Iterable[str]) -> Module:
    symbols = collect(tree)
    link(symbols.scopes)
    unresolved = unresolved_nonlocal(symbols.scopes)
    if unresolved is not None:
        raise misplaced(unresolved[1], f"no binding for nonlocal '{unresolved[0]}' found")
    unit = Unit(file, name, symbols, EXPRESSIONS, STATEMENTS)

    def body(of: Body) -> None:
        documentation = ast.get_docstring(tree, clean=False)
        if documentation is not None:
            register = of.register()
            of.ops.append(Const(1, 1, register, documentation))
            of.ops.append(StoreGlobal(1, 1, "__doc__", register))
            of.free_register = 0
        of.statements(tree.body)

    code = lower_code(
        unit,
        symbols.by_node[tree],
        body,
        name="<module>",
        qualname="<module>",
        line=1,
        doc=ast.get_docstring(tree, clean=False),
    )
    return Module(file, code, frozenset({*unit.imports, *loaded}), frozenset(unit.first), unit.has_main, lines)


def _parse(text: str) -> ast.Module:
    position = text.find("\0")
    if position >= 0:
        line = text.count("\n", 0, position) + 1
        raise FrontendError("null", "the file contains null bytes", line, 1)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text)
    except SyntaxError as error:
        tree = _of_newer(text)
        if tree is not None:
            return tree
        raise _unreadable(error, text) from error
    except (RecursionError, MemoryError) as error:
        raise FrontendError("depth", "the code is nested too deeply to be parsed", 1, 1) from error
    except ValueError as error:  # lone surrogates, numbers with too many digits
        raise FrontendError("syntax", str(error), 1, 1) from error


def _of_newer(text: str) -> ast.Module | None:
    """What a text says in the syntax of a Python that is newer than the running one; None where that is not it."""
    return _rewritten(text) or parse_with_fstrings(text, _tree_of_newer)


def _tree_of_newer(text: str) -> ast.Module:
    """What a text without f-strings says. Raises SyntaxError."""
    try:
        return ast.parse(text)
    except SyntaxError:
        found = _rewritten(text)
        if found is None:
            raise
        return found


def _rewritten(text: str) -> ast.Module | None:
    """What a text says once its newer forms are older ones."""
    rewritten = older(text)
    if rewritten is None:
        return None
    try:
        return ast.parse(rewritten)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


_TEMPLATE: Final = re.compile(r"""(?<!\w)(?:[tT][rR]?|[rR][tT])["']""")


def _unreadable(error: SyntaxError, text: str) -> FrontendError:
    message = error.msg
    number, column = error.lineno or 1, error.offset or 1
    kind = "syntax"
    if any(words in message for words in ("too many nested", "too many levels of indentation", "too complex")):
        kind = "depth"
    elif _PYTHON_2_MESSAGE.search(message):
        kind = "python2"
    else:
        lines = text.splitlines()
        line = lines[number - 1] if 0 < number <= len(lines) else ""
        if _PYTHON_2_LINE.match(line):
            kind = "python2"
        if kind == "syntax" and _TEMPLATE.search(line) and sys.version_info < (3, 14):
            message += " (template strings need Python 3.14: run rosward with it)"
    return FrontendError(kind, message, number, max(column, 1))
