# SPDX-License-Identifier: Apache-2.0
"""Expressions: each function lowers one kind and returns the register of the value.

    node.create_publisher(String, 'chatter', 10)
        %1 = node.create_publisher; %2 = global String; %3 = 'chatter'; %4 = 10; %5 = call %1(%2, %3, %4)

Chains that lean to the left (`a + b + c`, `a.b().c[0]`) are walked in a loop: generated code has thousands of links.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python.body import Body, misplaced
from rosward.frontends.python.narrowing import branch, compare, conjunction
from rosward.frontends.python.scopes import PlaceKind
from rosward.ir.ops import (
    NO_REGISTER,
    Argument,
    Await,
    Binary,
    Build,
    Call,
    Format,
    LoadAttr,
    LoadGlobal,
    LoadItem,
    Unary,
    Yield,
)
from rosward.ir.python import BuildKind

BINARY: Final[Mapping[type, str]] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.MatMult: "@",
    ast.Div: "/",
    ast.Mod: "%",
    ast.Pow: "**",
    ast.LShift: "<<",
    ast.RShift: ">>",
    ast.BitOr: "|",
    ast.BitXor: "^",
    ast.BitAnd: "&",
    ast.FloorDiv: "//",
}

UNARY: Final[Mapping[type, str]] = {ast.Not: "not", ast.USub: "-", ast.UAdd: "+", ast.Invert: "~"}


def _constant(body: Body, node: ast.Constant) -> int:
    value = node.value
    if value is ...:
        dst = body.register()
        body.ops.append(LoadGlobal(node.lineno, node.col_offset + 1, dst, "Ellipsis"))
        return dst
    return body.constant(node, value)


def _name(body: Body, node: ast.Name) -> int:
    return body.load(node, node.id)


def _binary(body: Body, node: ast.BinOp) -> int:
    chain = [node]
    left: ast.expr = node.left
    while isinstance(left, ast.BinOp):
        chain.append(left)
        left = left.left
    value = body.expression(left)
    for link in reversed(chain):
        right = body.expression(link.right)
        dst = body.register()
        body.ops.append(Binary(link.lineno, link.col_offset + 1, dst, BINARY[type(link.op)], value, right))
        value = dst
    return value


def _unary(body: Body, node: ast.UnaryOp) -> int:
    src = body.expression(node.operand)
    dst = body.register()
    body.ops.append(Unary(node.lineno, node.col_offset + 1, dst, UNARY[type(node.op)], src))
    return dst


def _postfix(body: Body, node: ast.Attribute | ast.Call | ast.Subscript) -> int:
    chain: list[ast.Attribute | ast.Call | ast.Subscript] = [node]
    base: ast.expr = node.func if isinstance(node, ast.Call) else node.value
    while isinstance(base, (ast.Attribute, ast.Call, ast.Subscript)):
        chain.append(base)
        base = base.func if isinstance(base, ast.Call) else base.value
    value = body.expression(base)
    for link in reversed(chain):
        line, column = link.lineno, link.col_offset + 1
        if isinstance(link, ast.Attribute):
            dst = body.register()
            body.ops.append(LoadAttr(line, column, dst, value, body.scope.mangle(link.attr)))
        elif isinstance(link, ast.Call):
            given = arguments(body, link.args, link.keywords)
            dst = body.register()
            body.ops.append(Call(line, column, dst, value, given))
            body.effects += 1
        else:
            index = body.expression(link.slice)
            dst = body.register()
            body.ops.append(LoadItem(line, column, dst, value, index))
        value = dst
    return value


def arguments(body: Body, positional: Sequence[ast.expr], keywords: Sequence[ast.keyword]) -> tuple[Argument, ...]:
    """The arguments of a call, or the bases and keywords of a class."""
    given: list[Argument] = []
    for argument in positional:
        if isinstance(argument, ast.Starred):
            given.append(Argument("star", body.expression(argument.value)))
        else:
            given.append(Argument("positional", body.expression(argument)))
    for keyword in keywords:
        register = body.expression(keyword.value)
        given.append(
            Argument("doublestar", register) if keyword.arg is None else Argument("keyword", register, keyword.arg)
        )
    return tuple(given)


def _display(kind: BuildKind) -> Callable[[Body, Any], int]:
    def lower(body: Body, node: ast.List | ast.Tuple | ast.Set) -> int:
        items: list[tuple[bool, int]] = []
        for item in node.elts:
            if isinstance(item, ast.Starred):
                items.append((True, body.expression(item.value)))
            else:
                items.append((False, body.expression(item)))
        return build(body, node, kind, items)

    return lower


def _dict(body: Body, node: ast.Dict) -> int:
    items: list[tuple[bool, int]] = []
    for key, value in zip(node.keys, node.values, strict=True):
        if key is None:
            items.append((True, body.expression(value)))
        else:
            items.append((False, body.expression(key)))
            items.append((False, body.expression(value)))
    return build(body, node, "dict", items)


def build(body: Body, node: ast.expr, kind: BuildKind, items: Sequence[tuple[bool, int]]) -> int:
    """A register with a new list, tuple, set or dict."""
    dst = body.register()
    body.ops.append(Build(node.lineno, node.col_offset + 1, dst, kind, tuple(items)))
    return dst


def _starred(_body: Body, node: ast.Starred) -> int:
    raise misplaced(node, "can't use starred expression here")


def _slice(body: Body, node: ast.Slice) -> int:
    parts = tuple(
        body.constant(node, None) if part is None else body.expression(part)
        for part in (node.lower, node.upper, node.step)
    )
    return body.intrinsic(node, "slice", parts)


def _f_string(body: Body, node: ast.JoinedStr) -> int:
    parts: list[str | tuple[int, str, int]] = []
    for part in node.values:
        if isinstance(part, ast.Constant):
            parts.append(str(part.value))
        elif isinstance(part, ast.FormattedValue):
            parts.append(_formatted_part(body, part))
        else:
            parts.append((body.expression(part), "", NO_REGISTER))
    dst = body.register()
    body.ops.append(Format(node.lineno, node.col_offset + 1, dst, tuple(parts)))
    return dst


def _formatted_part(body: Body, node: ast.FormattedValue) -> tuple[int, str, int]:
    value = body.expression(node.value)
    conversion = "" if node.conversion < 0 else chr(node.conversion)
    return value, conversion, NO_REGISTER if node.format_spec is None else body.expression(node.format_spec)


def _formatted(body: Body, node: ast.FormattedValue) -> int:
    part = _formatted_part(body, node)
    dst = body.register()
    body.ops.append(Format(node.lineno, node.col_offset + 1, dst, (part,)))
    return dst


def _template(body: Body, node: Any) -> int:
    """A t-string (3.14): its parts are evaluated, the template object is unknown."""
    parts = tuple(body.expression(part) for part in node.values)
    return body.intrinsic(node, "doc", parts)


def _interpolation(body: Body, node: Any) -> int:
    value = body.expression(node.value)
    spec = () if node.format_spec is None else (body.expression(node.format_spec),)
    return body.intrinsic(node, "doc", (value, *spec))


def _walrus(body: Body, node: ast.NamedExpr) -> int:
    value = body.expression(node.value)
    body.store(node.target, node.target.id, value)
    if body.place(node.target.id).kind is PlaceKind.REGISTER:
        return body.load(node.target, node.target.id)
    body.effects += 1
    return value


def _bool(body: Body, node: ast.BoolOp) -> int:
    return conjunction(body, node)[0]


def _compare(body: Body, node: ast.Compare) -> int:
    return compare(body, node)[0]


def _conditional(body: Body, node: ast.IfExp) -> int:
    dst = body.register()

    def put(part: ast.expr) -> Callable[[], None]:
        return lambda: body.settle(part, dst, body.expression(part))

    branch(body, node, node.test, put(node.body), put(node.orelse))
    return dst


def _yield(body: Body, node: ast.Yield | ast.YieldFrom) -> int:
    if not body.in_function:
        raise misplaced(node, "'yield' outside function")
    src = body.constant(node, None) if node.value is None else body.expression(node.value)
    dst = body.register()
    body.ops.append(Yield(node.lineno, node.col_offset + 1, dst, src, isinstance(node, ast.YieldFrom)))
    body.effects += 1
    return dst


def _await(body: Body, node: ast.Await) -> int:
    # A generator expression may await anywhere; in a model, `await` in a plain function means "run it here".
    if not body.is_coroutine and body.scope is body.owner and not body.unit.file.startswith("models:"):
        raise misplaced(node, "'await' outside async function")
    src = body.expression(node.value)
    dst = body.register()
    body.ops.append(Await(node.lineno, node.col_offset + 1, dst, src))
    body.effects += 1
    return dst


def _expressions() -> dict[type, Callable[[Body, Any], int]]:
    table: dict[type, Callable[[Body, Any], int]] = {
        ast.Constant: _constant,
        ast.Name: _name,
        ast.BinOp: _binary,
        ast.UnaryOp: _unary,
        ast.BoolOp: _bool,
        ast.Compare: _compare,
        ast.IfExp: _conditional,
        ast.Attribute: _postfix,
        ast.Call: _postfix,
        ast.Subscript: _postfix,
        ast.Slice: _slice,
        ast.List: _display("list"),
        ast.Tuple: _display("tuple"),
        ast.Set: _display("set"),
        ast.Dict: _dict,
        ast.Starred: _starred,
        ast.JoinedStr: _f_string,
        ast.FormattedValue: _formatted,
        ast.NamedExpr: _walrus,
        ast.Yield: _yield,
        ast.YieldFrom: _yield,
        ast.Await: _await,
    }
    for name, handler in (("TemplateStr", _template), ("Interpolation", _interpolation)):
        kind = getattr(ast, name, None)
        if kind is not None:
            table[kind] = handler
    return table


EXPRESSIONS: Final[Mapping[type, Callable[[Body, Any], int]]] = _expressions()
