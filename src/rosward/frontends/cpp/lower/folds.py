# SPDX-License-Identifier: Apache-2.0
"""Packs: `f(args)...`, `(f(args), ...)`, `(args + ... + 0)`, `sizeof...(args)`.

g(std::forward<Args>(args)...)     Spread over Args and args side by side: forward<Args>(args); Invoke g (pack)
f(args...)                         Invoke f (pack args)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.survey import operator_of, word
from rosward.frontends.cpp.lower.variables import Scope, Variable
from rosward.ir.control import If
from rosward.ir.core import NO_REGISTER, Const
from rosward.ir.cpp import Assign, Spread

if TYPE_CHECKING:
    from tree_sitter import Node

_NAMES: Final = frozenset({"identifier", "type_identifier", "namespace_identifier"})
_ASSIGNING: Final = frozenset({"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="})
_STREAMING: Final = frozenset({"<<", ">>"})
_OPERATORS: Final = (
    frozenset({",", "+", "-", "*", "/", "%", "&", "|", "^", "&&", "||", "==", "!=", "<", "<=", ">", ">="})
    | _STREAMING
    | _ASSIGNING
)


def _packs(body: Body, node: Node) -> list[tuple[str, Node]]:
    """The packs that a pattern names, in their order; not those that are spread within it."""
    found: dict[str, Node] = {}
    waiting = [node]
    while waiting:
        here = waiting.pop()
        if here.type in _NAMES:
            variable = body.variable(word(here))
            if word(here) in body.shared.packs if variable is None else variable.pack:
                found[word(here)] = here
        elif here.type not in ("parameter_pack_expansion", "fold_expression", "sizeof_expression"):
            waiting += reversed(here.children)
    return list(found.items())


def _held(body: Body, name: Node) -> int:
    """A pack: a variable, or a parameter of the class template around."""
    variable = body.variable(word(name))
    return body.value(name) if variable is None else body.held(name, variable)


def _spread(
    body: Body,
    node: Node,
    pattern: Node,
    operator: str = "",
    init: int = NO_REGISTER,
    *,
    right: bool = False,
    each: Callable[[], int] | None = None,
) -> int:
    """Run the pattern for the items of its packs, which are variables as long; or `each`, which runs it."""
    packs = _packs(body, pattern)
    if not packs:
        return body.unknown(node, "syntax")
    registers = tuple(_held(body, name) for _, name in packs)
    items = tuple(body.register() for _ in packs)
    before = body.floor
    body.scopes.append(Scope(before))
    for (name, place), register in zip(packs, items, strict=True):
        variable = body.variable(word(place))
        is_type = variable is None or variable.type
        body.scopes[-1].names[name] = Variable(name, register, NO_REGISTER, reference=not is_type, type_=is_type)
    result = NO_REGISTER

    def run() -> None:
        nonlocal result
        result = each() if each else body.expression(pattern, "value" if operator not in ("", ",") else "slot")

    block = body.block(run)
    body.scopes.pop()
    dst = body.register()
    body.emit(
        Spread(*body.place(node), dst, registers, items, block, result, operator=operator, init=init, right=right)
    )
    return dst


def expanded(body: Body, pattern: Node) -> int:
    """The items of `pattern...`; a pack alone is itself."""
    inner = pattern.child_by_field_name("type") if pattern.type == "type_descriptor" else pattern
    if inner is not None and inner.type in _NAMES and pattern.child_by_field_name("declarator") is None:
        return _held(body, inner)
    if _packs(body, pattern):
        return _spread(body, pattern, pattern)
    return body.value(pattern)


def _expansion(body: Body, node: Node, _want: Want) -> int:
    """`pattern...`."""
    pattern = node.child_by_field_name("pattern")
    if pattern is None:
        return body.unknown(node, "syntax")
    return expanded(body, pattern)


def _fold(body: Body, node: Node, _want: Want) -> int:
    """`(… op pack)`, `(pack op …)`, `(init op … op pack)`, `(pack op … op init)`."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = operator_of(node)
    operands = [each for each in (left, right) if each is not None and each.type != "..."]
    if operator not in _OPERATORS or not operands:
        return body.unknown(node, "language", "fold")
    pattern = next((each for each in operands if _packs(body, each)), operands[-1])
    other = next((each for each in operands if each.id != pattern.id), None)
    is_right = left is not None and pattern.id == left.id
    first, last = (None, other) if is_right else (other, None)
    if operator in ("&&", "||"):
        return _decided(body, node, pattern, operator, first, last)
    if operator == ",":
        if first is not None:
            body.expression(first, "effect")
        found = _spread(body, node, pattern, operator)
        return found if last is None else body.slot(last)
    if operator in _ASSIGNING:
        return _assigned(body, node, pattern, operator, first)
    init = NO_REGISTER if other is None else body.slot(other) if operator in _STREAMING else body.value(other)
    return _spread(body, node, pattern, operator, init, right=is_right)


def _decided(body: Body, node: Node, pattern: Node, operator: str, first: Node | None, last: Node | None) -> int:
    """`(pack && …)`: as soon as one decides, the others do not run."""
    dst = body.register()
    place = body.place(node)
    body.emit(Const(*place, dst, operator == "&&"))

    def asked(operand: Node) -> int:
        decided = body.block(lambda: body.emit(Const(*place, dst, operator == "||")))
        going = body.block(lambda: body.move(node, dst, body.value(operand)))
        body.emit(If(*place, dst, *((going, decided) if operator == "&&" else (decided, going))))
        return dst

    if first is not None:
        asked(first)
    _spread(body, node, pattern, ",", each=lambda: asked(pattern))
    return dst if last is None else asked(last)


def _assigned(body: Body, node: Node, pattern: Node, operator: str, first: Node | None) -> int:
    """`(sum += … += pack)`: one after the other."""
    if first is None:
        return body.unknown(node, "language", "fold")
    slot = body.slot(first)

    def one() -> int:
        body.emit(Assign(*body.place(node), NO_REGISTER, operator, slot, body.value(pattern)))
        return slot

    _spread(body, node, pattern, ",", each=one)
    return slot


def _size(body: Body, node: Node, _want: Want) -> int:
    """`sizeof...(pack)`: one for each item, added. How large a type is, no one can say, but for an array of characters (`char text[32]`)."""
    name = node.child_by_field_name("value")
    inner = name.named_children[0] if name is not None and name.type == "parenthesized_expression" else name
    variable = body.variable(word(inner)) if inner is not None and inner.type == "identifier" else None
    if variable is not None and variable.buffer and variable.written is not None:
        shape = variable.written[1]
        size = shape.child_by_field_name("size") if shape is not None and shape.type == "array_declarator" else None
        if size is not None and size.type == "number_literal":
            return body.value(size)
    if name is None or not any(child.type == "..." for child in node.children) or not _packs(body, name):
        return body.unknown(node, "language", "sizeof")
    item, dst = body.register(), body.register()
    one = NO_REGISTER

    def run() -> None:
        nonlocal one
        one = body.constant(node, 1)

    zero, pack = body.constant(node, 0), _held(body, name)
    block = body.block(run)
    body.emit(Spread(*body.place(node), dst, (pack,), (item,), block, one, operator="+", init=zero))
    return dst


EXPRESSIONS: Final = {
    "sizeof_expression": _size,
    "parameter_pack_expansion": _expansion,
    "fold_expression": _fold,
}
