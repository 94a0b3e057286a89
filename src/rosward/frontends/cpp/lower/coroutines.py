# SPDX-License-Identifier: Apache-2.0
"""Coroutines: who calls one goes on, whether or not it comes to its end.

Task<void> listen() { while (true) { auto message = co_await stream->next(); … } }
        the body runs, or does not, and the call gives something that nobody knows; what is awaited is evaluated
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.initialisers import Given, construct
from rosward.frontends.cpp.lower.types import declared_type
from rosward.ir.control import If, Return

if TYPE_CHECKING:
    from tree_sitter import Node

__all__ = ["EXPRESSIONS", "STATEMENTS", "content"]

_WORDS: Final = frozenset({"co_await_expression", "co_return_statement", "co_yield_statement", "co_yield_expression"})
_APART: Final = frozenset({"lambda_expression", "class_specifier", "struct_specifier"})
_LOOKED_AT: Final = 20_000


def content(body: Body, node: Node) -> None:
    """The statements of a function or lambda."""
    if not _is_coroutine(node):
        body.statement(node)
        return
    place = body.place(node)
    test = body.unknown(node, "language", "coroutine")
    body.floor = body.free_register
    body.emit(If(*place, test, body.block(lambda: body.statement(node)), []))
    body.emit(Return(*place, _handle(body, node)))


def _handle(body: Body, node: Node) -> int:
    """What a call gives: an object of the type that is written, of which nothing else is known."""
    returns = body.returns
    if returns.type is None or returns.plain:
        return body.unknown(node, "language", "coroutine")
    kind = declared_type(body, returns.type, returns.declarator, result=True)
    return construct(body, node, kind, Given((), "default"))


def _is_coroutine(node: Node) -> bool:
    if b"co_" not in (node.text or b""):
        return False
    waiting = [node]
    for _ in range(_LOOKED_AT):
        if not waiting:
            return False
        here = waiting.pop()
        if here.type in _WORDS:
            return True
        if here.type not in _APART:
            waiting += here.named_children
    return True


def _awaited(body: Body, node: Node, _want: str) -> int:
    """`co_await f()`: it is called; what comes of it nobody knows."""
    for child in node.named_children:
        body.expression(child, "effect")
    return body.unknown(node, "language", "co_await")


def _yielded(body: Body, node: Node) -> None:
    for child in node.named_children:
        body.expression(child, "effect")


def _returned(body: Body, node: Node) -> None:
    _yielded(body, node)
    body.emit(Return(*body.place(node), _handle(body, node)))


EXPRESSIONS: Final[dict[str, Callable[[Body, Node, str], int]]] = {"co_await_expression": _awaited}
STATEMENTS: Final[dict[str, Callable[[Body, Node], None]]] = {
    "co_return_statement": _returned,
    "co_yield_statement": _yielded,
}
