# SPDX-License-Identifier: Apache-2.0
"""What is something initialised with? `(a, b)`, `{a, {b, c}}`, `{.x = 1}`, `= a`.

T x{a, b};        Construct T (a, b) brace
f({a, b})         Braces (a, b), for whoever makes something of it
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.arithmetic import type_written
from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.lvalues import is_lvalue
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import builtin, declared_type, type_of
from rosward.ir.cpp import AddressOf, Argued, Braces, Construct, Convert, Deref, Form, MakeType
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node


_NAMES: Final = frozenset({"qualified_identifier", "field_expression"})


class Given(NamedTuple):
    """Arguments and how they are written."""

    arguments: tuple[Argued, ...]
    form: Form


def _designated(node: Node) -> tuple[str, Node]:
    """`.a = 1`: the name and the value."""
    value = node.child_by_field_name("value")
    if node.type != "initializer_pair" or value is None:
        return "", node
    designator = node.child_by_field_name("designator")
    return word(designator).lstrip(". "), value


def arguments(body: Body, node: Node | None) -> tuple[Argued, ...]:
    """Those in an `argument_list`, or in brackets that read like those of an expression."""
    listed = node.named_children if node is not None else []
    if node is not None and node.type == "parenthesized_expression":
        listed = _between_commas(listed)
    return tuple(_argued(body, child) for child in listed if child.type != "comment")


def _between_commas(nodes: list[Node]) -> list[Node]:
    found: list[Node] = []
    waiting = [*reversed(nodes)]
    while waiting:
        node = waiting.pop()
        if node.type == "comma_expression":
            waiting += [*reversed(node.named_children)]
        else:
            found.append(node)
    return found


def _argued(body: Body, node: Node) -> Argued:
    found, number = body.argued(node), "char" if node.type == "char_literal" else type_written(body, node)
    return found if number in _PLAIN else found._replace(number=number)


_PLAIN: Final = frozenset({"", "int", "double"})
"""Types of numbers that show in their values."""


def given(body: Body, node: Node | None, *, copy: bool = False) -> Given:
    """What a type is made with: `argument_list`, `initializer_list` or (`copy`: after `=`) an expression."""
    if node is None:
        return Given((), "default")
    if node.type == "argument_list":
        return Given(arguments(body, node), "paren")
    if node.type != "initializer_list":
        return Given((body.argued(node),), "copy")
    form: Form = "brace-copy" if copy else "brace"
    if any(child.type == "initializer_pair" for child in node.named_children):
        return Given((body.argued(node),), form)
    return Given(arguments(body, node), form)


def construct(body: Body, node: Node, type_: int, what: Given, *, local: bool = False) -> int:
    """A new value of a type; `local`: of a variable of a block."""
    dst = body.register()
    body.emit(Construct(*body.place(node), dst, type_, what.arguments, what.form, local=local))
    return dst


def is_place(body: Body, what: Node) -> bool:
    """Whether `decltype(auto)` stands for a reference to a value, or, where that is new, for what lives as long."""
    if what.type == "identifier":  # not in parentheses: of the type of the variable
        variable = body.variable(word(what))
        return variable is not None and variable.reference
    return what.type == "call_expression" or (is_lvalue(what) and what.type not in _NAMES)


def _literal(body: Body, node: Node, _want: Want) -> int:
    """`T{a}`, and `(T){a}` of C."""
    kind = type_of(body, node.child_by_field_name("type"))
    return construct(body, node, kind, given(body, node.child_by_field_name("value")))


def _braces(body: Body, node: Node, _want: Want) -> int:
    """`{a, b}` as a value."""
    items: list[Argued] = []
    names: list[str] = []
    for child in node.named_children:
        name, value = _designated(child)
        names.append(name)
        items.append(body.argued(value))
    dst = body.register()
    body.emit(Braces(*body.place(node), dst, tuple(items), tuple(names) if any(names) else ()))
    return dst


def _new(body: Body, node: Node, _want: Want) -> int:
    """`new T(a)`, `new T[n]`."""
    declarator = node.child_by_field_name("declarator")
    kind = declared_type(body, node.child_by_field_name("type"), None)
    if declarator is not None:
        length = declarator.child_by_field_name("length")
        kind = _array(body, declarator, kind, length)
    made = construct(body, node, kind, given(body, node.child_by_field_name("arguments")))
    where = _placed(node)
    if where is not None:
        place, made = body.register(), _put_there(body, node, where, made)
        body.emit(AddressOf(*body.place(node), place, made))
        return place
    dst = body.register()
    body.emit(AddressOf(*body.place(node), dst, made))
    if (
        declarator is not None and builtin(node.child_by_field_name("type")) == "char"
    ):  # kept as the text that they make
        slot, first = body.register(), body.register()
        body.emit(Deref(*body.place(node), slot, dst, slot=True))
        body.emit(Convert(*body.place(node), first, slot, kind, "buffer"))
        return first
    return dst


def _placed(node: Node) -> Node | None:
    """The pointer in `new (pointer) T(a)`; None where there is none, or nothing else leads to what it does."""
    listed = node.child_by_field_name("placement")
    inner = [child for child in listed.named_children if child.type != "comment"] if listed is not None else []
    if len(inner) != 1 or inner[0].type == "call_expression" or (inner[0].text or b"").endswith(b"nothrow"):
        return None
    return inner[0]


def _put_there(body: Body, node: Node, where: Node, made: int) -> int:
    """The slot to which a pointer leads, in which a new value stands now."""
    slot = body.register()
    body.emit(Deref(*body.place(node), slot, body.value(where), slot=True))
    put = body.register()
    body.emit(Convert(*body.place(node), put, made, slot, "placed"))
    return put


def _array(body: Body, node: Node, element: int, length: Node | None) -> int:
    inner = (element,) if length is None else (element, body.value(length))
    dst = body.register()
    body.emit(MakeType(*body.place(node), dst, "array", inner))
    return dst


EXPRESSIONS: Final = {
    "compound_literal_expression": _literal,
    "initializer_list": _braces,
    "new_expression": _new,
}
