# SPDX-License-Identifier: Apache-2.0
"""Statements: blocks, `if`, `return`, `throw`, `try`, and those that only hold an expression.

Statements of a branch of `#if` that nobody knows are in an `If` of their own.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.declarators import named
from rosward.frontends.cpp.lower import narrowing
from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.choices import statements
from rosward.frontends.cpp.lower.declarations import condition
from rosward.frontends.cpp.lower.initialisers import construct, given, is_place
from rosward.frontends.cpp.lower.jumps import goto, leaves
from rosward.frontends.cpp.lower.literals import is_of
from rosward.frontends.cpp.lower.lvalues import is_lvalue
from rosward.frontends.cpp.lower.narrowing import Outcome
from rosward.frontends.cpp.lower.seen import own
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import POINTERS, REFERENCES, builtin, declared_type, has, is_as_written
from rosward.frontends.cpp.patterns import has_const
from rosward.ir.control import Break, Continue, Handler, If, Raise, Return, Try
from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp import Convert, Copy, Deref, EndScope
from rosward.ir.op import Block

if TYPE_CHECKING:
    from tree_sitter import Node


_CHAINED: Final = 300
"""So many `else if` in a row are followed."""
_LEAVING: Final = frozenset({"return_statement", "break_statement", "continue_statement", "throw_statement"})


def compound(body: Body, node: Node) -> None:
    """`{ … }`."""
    body.open()
    statements(body, node.named_children)
    body.close(node)


def _expression(body: Body, node: Node) -> None:
    for child in node.named_children:
        if child.type != "comment":
            body.expression(child, "effect")


def _bare(body: Body, node: Node) -> None:
    """A name alone, which the parser takes for a statement."""
    body.expression(node, "effect")


def tested(body: Body, node: Node | None) -> Outcome:
    """What stands in the brackets of `if`, `while`, `switch`: a statement, then a value or a declaration."""
    value = begun(body, node)
    if value is None or value.type != "declaration":
        return narrowing.condition(body, value)
    found = condition(body, value)
    if found is None:
        return Outcome(body.unknown(value, "syntax"), [], [])
    return narrowing.tested(body, value, found)


def begun(body: Body, node: Node | None) -> Node | None:
    """The value or declaration in those brackets, behind the statement."""
    if node is None or node.type != "condition_clause":
        return node
    before = node.child_by_field_name("initializer")
    for child in before.named_children if before is not None else ():
        body.statement(child)
    return node.child_by_field_name("value")


def _if(body: Body, node: Node) -> None:
    """`if … else if … else …`: a chain of any length is no nesting of the source."""
    around: list[tuple[Node, Block]] = []
    for _ in range(_CHAINED):
        body.open()
        then, orelse = node.child_by_field_name("consequence"), node.child_by_field_name("alternative")
        following = _else_if(orelse)
        if following is None:
            break
        found = tested(body, node.child_by_field_name("condition"))
        first = narrowing.assumed(body, node, found.true, lambda: branch(body, then))  # noqa: B023 - it is called at once
        second: Block = []
        body.emit(If(*body.place(node), found.register, first, second))
        around.append((node, body.ops))
        body.ops = second
        narrowing.assume(body, node, found.false)
        node = following
    else:
        body.open()
        body.unknown(node, "syntax")
        then = orelse = None
    _last_if(body, node, then, orelse)
    body.close(node)
    for outer, ops in reversed(around):
        body.ops = ops
        body.close(outer)


def _else_if(node: Node | None) -> Node | None:
    """The `if` that is all that an `else` has."""
    inner = [child for child in node.named_children if child.type != "comment"] if node is not None else []
    return inner[0] if len(inner) == 1 and inner[0].type == "if_statement" else None


def _last_if(body: Body, node: Node, then: Node | None, orelse: Node | None) -> None:
    clause = node.child_by_field_name("condition")
    test = begun(body, clause)

    def first() -> None:
        branch(body, then)

    def second() -> None:
        branch(body, orelse)

    if test is not None and test.type == "declaration":
        narrowing.split(body, node, tested(body, test), first, second)
    elif orelse is not None or then is None or not _only_leaves(then):
        narrowing.branch(body, node, test, first, None if orelse is None else second)
    elif not narrowing.guards(body, node, test, first, then.descendant_count):
        narrowing.branch(body, node, test, first, None)


def _only_leaves(node: Node) -> bool:
    """Whether a branch ends by leaving what is around it, and has no function of its own."""
    last = node
    while last.type == "compound_statement" and last.named_children:
        last = last.named_children[-1]
    return last.type in _LEAVING and b"[" not in (node.text or b"")


def branch(body: Body, node: Node | None) -> None:
    """A statement that is a block of its own."""
    if node is None:
        return
    if node.type == "else_clause":
        inner = [child for child in node.named_children if child.type != "comment"]
        node = inner[0] if inner else node
    body.open()
    statements(body, [node])
    body.close(node)


def _return(body: Body, node: Node) -> None:
    inner = [child for child in node.named_children if child.type != "comment"]
    if not inner or (node.has_error and any(child.is_error for child in node.children)):
        src = body.unknown(node, "syntax") if inner else body.constant(node, None)
    else:
        src = _returned(body, node, inner[0])
    named = body.variable(word(inner[0])) if inner and inner[0].type == "identifier" else None
    body.end_objects(node, body.scopes, but=named)
    body.emit(Return(*body.place(node), src))


def _returned(body: Body, node: Node, value: Node) -> int:
    returns = body.returns
    if returns.reference:
        return body.slot(value)
    if value.type == "initializer_list":
        if returns.plain:
            return body.value(value)
        kind = declared_type(body, returns.type, returns.declarator, result=True)
        return construct(body, node, kind, given(body, value, copy=True))
    variable = body.variable(word(value)) if value.type == "identifier" else None
    is_own = variable is not None and not variable.reference
    if is_as_written(returns.type) and is_place(
        body, value
    ):  # a reference, of which a copy is given: of the whole object
        dst = body.register()
        body.emit(Copy(*body.place(node), dst, body.slot(value), NO_REGISTER))
        return dst
    if returns.plain or (is_of(builtin(returns.type), value) and not has(returns.declarator, POINTERS)):
        return body.value(value) if is_own else body.own(value)
    dst = body.register()
    if is_own or not is_lvalue(value):
        src = body.value(value) if is_own else body.own(value)
        kind = declared_type(body, returns.type, returns.declarator, result=True)
        body.emit(Convert(*body.place(node), dst, src, kind, "value"))
        return dst
    src = body.value(value) if variable is not None and variable.buffer else body.slot(value)
    kind = declared_type(body, returns.type, returns.declarator, result=True)
    if has(returns.declarator, POINTERS):  # to an array that stays where it is
        body.emit(Convert(*body.place(node), dst, src, kind, "init"))
        return dst
    body.emit(Copy(*body.place(node), dst, src, kind))
    body.emit(Convert(*body.place(node), dst, dst, kind, "init"))
    return dst


def _throw(body: Body, node: Node) -> None:
    inner = [child for child in node.named_children if child.type != "comment"]
    src = own(body, inner[0]) if inner else NO_REGISTER
    body.emit(Raise(*body.place(node), src))


def _throw_expression(body: Body, node: Node, _want: str) -> int:
    _throw(body, node)
    return body.nothing()


def try_(body: Body, node: Node, begin: Callable[[], None] | None = None) -> None:
    """`try { … } catch (const E & e) { … }`; `begin` is what a constructor does first: what it catches, it raises again."""
    tried = node.child_by_field_name("body")

    def run() -> None:
        if begin is not None:
            begin()
        branch(body, tried)

    block = body.block(run)
    clauses = [child for child in node.named_children if child.type == "catch_clause"]
    handlers = tuple(_handler(body, child, again=begin is not None) for child in clauses)
    body.emit(Try(*body.place(node), block, handlers, [], []))


def _handler(body: Body, node: Node, *, again: bool) -> Handler:
    listed = node.child_by_field_name("parameters")
    parameter = next((c for c in listed.named_children if c.type == "parameter_declaration"), None) if listed else None
    inner = node.child_by_field_name("body")
    match: Block = []
    caught = NO_REGISTER
    body.open()
    if parameter is not None:
        type_node, shape = parameter.child_by_field_name("type"), parameter.child_by_field_name("declarator")

        def lower() -> None:
            nonlocal caught
            caught = declared_type(body, type_node, shape)

        match = body.block(lower)
    bind = NO_REGISTER if parameter is None else body.register()

    def run() -> None:
        if parameter is not None:
            _caught(body, parameter, bind)
        branch(body, inner)
        if again and not body.ends():
            body.emit(Raise(*body.place(node), NO_REGISTER))

    block = body.block(run)
    body.close(node)
    return Handler(match, caught, bind, block)


def _caught(body: Body, node: Node, bind: int) -> None:
    declarator = node.child_by_field_name("declarator")
    name = None if declarator is None else named(declarator)[0]
    if name is not None and name.type == "identifier":
        is_reference = has(declarator, REFERENCES)
        found = body.declare(
            word(name), reference=is_reference, pointer=True, constant=has_const(node) and not has(declarator, POINTERS)
        )
        type_node = node.child_by_field_name("type")
        found.written = None if type_node is None else (type_node, declarator)
        if not is_reference and not has(declarator, POINTERS) and type_node is not None:
            copy = body.register()
            body.emit(Copy(*body.place(node), copy, bind, declared_type(body, type_node, declarator)))
            bind = copy
        body.write(node, found, bind)


def _break(body: Body, node: Node) -> None:
    if not body.loops:
        body.unknown(node, "syntax")
        return
    if leaves(body, node, "break"):
        return
    body.end_objects(node, body.scopes[body.loops[-1].scopes :])
    body.emit(Break(*body.place(node)))


def continue_(body: Body, node: Node) -> None:
    """Within a `switch`, which is a loop here, a register says that the one around it goes on."""
    loop = body.loops[-1] if body.loops else None
    if loop is None or (loop.is_switch and loop.flag == NO_REGISTER):
        body.unknown(node, "syntax")
        return
    if leaves(body, node, "continue"):
        return
    body.end_objects(node, body.scopes[loop.scopes :])
    if loop.is_switch:
        body.move(node, loop.flag, body.constant(node, True))
        body.emit(Break(*body.place(node)))
        return
    if loop.step is not None:
        scopes, body.scopes = body.scopes, body.scopes[: loop.scopes]
        loop.step()
        body.scopes = scopes
    body.emit(Continue(*body.place(node)))


def _delete(body: Body, node: Node, _want: str) -> int:
    """`delete p`: the destructor runs."""
    if not node.named_children:
        return body.unknown(node, "syntax")
    src = body.value(node.named_children[-1])
    obj = body.register()
    body.emit(Deref(*body.place(node), obj, src, slot=True))
    body.emit(EndScope(*body.place(node), (obj,)))
    return src


def _labeled(body: Body, node: Node) -> None:
    for child in node.named_children:
        if child.type not in ("statement_identifier", "attribute_declaration", "comment"):
            body.statement(child)


def _language_expression(body: Body, node: Node, _want: str) -> int:
    return body.unknown(node, "language", node.type.removesuffix("_expression"))


def _nothing(_body: Body, _node: Node) -> None:
    """What runs nothing."""


STATEMENTS: Final = {
    "compound_statement": compound,
    "expression_statement": _expression,
    "if_statement": _if,
    "return_statement": _return,
    "throw_statement": _throw,
    "try_statement": try_,
    "break_statement": _break,
    "continue_statement": continue_,
    "labeled_statement": _labeled,
    "attributed_statement": _labeled,
    "goto_statement": goto,
    "qualified_identifier": _bare,
    "identifier": _bare,
    "type_identifier": _bare,
    **dict.fromkeys(
        (
            "static_assert_declaration",
            "comment",
            "attribute_declaration",
            "access_specifier",
            ";",
            "template_declaration",
        ),
        _nothing,
    ),
}

EXPRESSIONS: Final = {
    "throw_statement": _throw_expression,
    "delete_expression": _delete,
    **dict.fromkeys(
        (
            "alignof_expression", "offsetof_expression", "gnu_asm_expression",
            "generic_expression", "requires_expression",
        ),
        _language_expression,
    ),
}  # fmt: skip
