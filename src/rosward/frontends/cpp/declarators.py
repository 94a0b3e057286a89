# SPDX-License-Identifier: Apache-2.0
"""Which name does a declarator declare, and in which scope?

void (Lamp::* const table[3])(int)      the name `table`
Box<T>::Inner::f(T x)                   the name `f`, with the scope Box<T>, Inner before it
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

_NAMES: Final = frozenset(
    {
        "identifier", "field_identifier", "type_identifier", "qualified_identifier", "destructor_name", "operator_name",
        "operator_cast", "template_function", "template_method", "template_type", "structured_binding_declarator",
    }
)  # fmt: skip
_TEMPLATES: Final = frozenset({"template_type", "template_function", "template_method"})
_WITHOUT_FIELD: Final = frozenset(
    {"reference_declarator", "parenthesized_declarator", "attributed_declarator", "variadic_declarator"}
)
_FUNCTIONS: Final = frozenset({"destructor_name", "operator_cast"})
_NEEDLESS: Final = re.compile(r"(?<=[^\w\s])\s+|\s+(?=[^\w\s])")

DEPTH: Final = 200
"""How deep declarators and scopes are looked into."""


class Part(NamedTuple):
    """One part of a name: `Box<T>` is Box with its arguments."""

    name: str
    arguments: Node | None = None


class Spelled(NamedTuple):
    """A name as it is written: the parts of its scope, the name itself; `absolute` where it begins with `::`."""

    scope: tuple[Part, ...]
    last: Part
    absolute: bool = False


def text_of(node: Node | None) -> str:
    """The text of a node, with single blanks."""
    return "" if node is None else " ".join((node.text or b"").decode("utf-8", "replace").split())


def dense(node: Node | None) -> str:
    """The text of a node, with blanks only between words: two ways to write the same thing are one."""
    return _NEEDLESS.sub("", text_of(node))


def named(declarator: Node) -> tuple[Node | None, bool]:
    """The name in a declarator, and whether the name itself is that of a function."""
    node: Node | None = declarator
    is_function = False
    for _ in range(DEPTH):
        if node is None or node.type in _NAMES:
            return node, is_function or (node is not None and _last(node).type in _FUNCTIONS)
        is_function = node.type == "function_declarator" or (is_function and node.type == "attributed_declarator")
        node = inner(node)
    return None, False


def inner(declarator: Node) -> Node | None:
    """What a declarator is about: of `& x`, `* x`, `x[3]`, `x(int)`, `x = 1` the `x`."""
    if declarator.type in _WITHOUT_FIELD:
        return next((c for c in declarator.named_children if c.type.endswith(("declarator", "identifier"))), None)
    return declarator.child_by_field_name("declarator")


def spelled(node: Node) -> Spelled:
    """The parts of a name."""
    outer: list[Part] = []
    absolute = False
    for depth in range(DEPTH):
        if node.type != "qualified_identifier":
            break
        before = node.child_by_field_name("scope")
        if before is not None:
            outer.append(_part(before))
        elif depth == 0:
            absolute = True
        after = node.child_by_field_name("name")
        if after is None:
            break
        node = after
    return Spelled(tuple(outer), _part(node), absolute)


def unnamed(node: Node) -> str:
    """What stands for the name of a class or enum without one."""
    return f"<unnamed {node.start_byte}>"


def _last(node: Node) -> Node:
    for _ in range(DEPTH):
        after = node.child_by_field_name("name") if node.type == "qualified_identifier" else None
        if after is None:
            break
        node = after
    return node


def _part(node: Node) -> Part:
    kind = node.type
    if kind in _TEMPLATES:
        return Part(text_of(node.child_by_field_name("name")), node.child_by_field_name("arguments"))
    if kind == "operator_cast":
        behind = node.child_by_field_name("declarator")
        text = (node.text or b"")[: None if behind is None else behind.start_byte - node.start_byte]
        pointers = dense(behind).partition("(")[0]
        words = _NEEDLESS.sub("", " ".join(text.decode("utf-8", "replace").split()))
        return Part(words + pointers)
    if kind == "operator_name":
        words = dense(node)
        return Part(words)
    return Part(dense(node) if kind == "destructor_name" else text_of(node))


def template_parameter_name(node: Node) -> str:
    """The name of a parameter of a template, '' for one without."""
    if node.type == "template_template_parameter_declaration" and node.named_children:
        return template_parameter_name(node.named_children[-1])
    name = node.child_by_field_name("name") or node.child_by_field_name("declarator")
    if name is None and node.type.endswith("type_parameter_declaration"):
        name = next((child for child in node.named_children if child.type == "type_identifier"), None)
    while name is not None and name.type.endswith("declarator"):
        name = inner(name)
    return dense(name)
