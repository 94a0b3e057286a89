# SPDX-License-Identifier: Apache-2.0
"""Which attributes and specifiers has a declaration?

[[rosward::creator("publisher")]] static int f() = delete;      marks: creator ("publisher"), delete; words: static
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.declarators import inner, text_of

if TYPE_CHECKING:
    from tree_sitter import Node

_SPECIFIERS: Final = frozenset(
    {
        "storage_class_specifier", "type_qualifier", "virtual_specifier", "virtual", "explicit_function_specifier",
        "virtual_function_specifier",
    }
)  # fmt: skip
_CLAUSES: Final = {
    "default_method_clause": "default",
    "delete_method_clause": "delete",
    "pure_virtual_clause": "abstract",
    "delete_expression": "delete",
}
_VALUES: Final = {b"0": "abstract", b"default": "default"}
"""What the parser takes for a first value: `virtual void f() = 0`, `friend bool operator==(const A &, const A &) = default`."""
_OURS: Final = "rosward"


def marks_of(node: Node, whole: Node) -> Mapping[str, tuple[str, ...]]:
    """The attributes of a model with their words, and what stands in the place of a body."""
    found: dict[str, tuple[str, ...]] = {}
    for child in (*whole.children, *(node.children if node != whole else ())):
        if child.type == "attribute_declaration":
            found.update(ours(child))
        elif child.type in _CLAUSES:
            found[_CLAUSES[child.type]] = ()
    value = _value(whole)
    if value is not None and value.type in _CLAUSES:
        found[_CLAUSES[value.type]] = ()
    elif value is not None and value.text in _VALUES:
        found[_VALUES[value.text]] = ()
    return found


def _value(whole: Node) -> Node | None:
    """What stands behind the `=` of a function: the parser takes it for a first value."""
    value = whole.child_by_field_name("default_value")
    declarator = whole.child_by_field_name("declarator")
    if value is None and declarator is not None and declarator.type == "init_declarator":
        value = declarator.child_by_field_name("value")
    return value


def ours(declaration: Node) -> Iterator[tuple[str, tuple[str, ...]]]:
    """The attributes of models among those of a declaration."""
    for attribute in declaration.named_children:
        if text_of(attribute.child_by_field_name("prefix")) == _OURS:
            listed = next((c for c in attribute.named_children if c.type == "argument_list"), None)
            words = [text_of(c).strip('"') for c in listed.named_children] if listed is not None else []
            yield text_of(attribute.child_by_field_name("name")), tuple(words)


def words_of(whole: Node, function: Node | None) -> frozenset[str]:
    """`static`, `inline`, `virtual`, `constexpr`, …; `override` and `final` behind the parameters, `const`, `&` and `&&` there as `this const`, …."""
    found = {text_of(child) for child in whole.children if child.type in _SPECIFIERS}
    for child in function.children if function is not None else ():
        if child.type == "virtual_specifier":
            found.add(text_of(child))
        elif child.type in {"type_qualifier", "ref_qualifier"}:
            found.add(f"this {text_of(child)}")
    return frozenset(found)


def receiver_in(words: frozenset[str]) -> str:
    """`&` or `&&` behind the parameters."""
    return "&&" if "this &&" in words else "&" if "this &" in words else ""


def function_of(declarator: Node | None) -> Node | None:
    """The declarator with the parameters of a function, the innermost one."""
    node = declarator
    found: Node | None = None
    while node is not None:
        if node.type in {"function_declarator", "abstract_function_declarator"}:
            found = node
        if node.type == "qualified_identifier":
            node = node.child_by_field_name("name")
        else:
            node = node.child_by_field_name("declarator") if node.type == "operator_cast" else inner(node)
    return found
