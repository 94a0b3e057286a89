# SPDX-License-Identifier: Apache-2.0
"""Which names does a file declare, in which scopes?

    namespace lamp { class Lamp : public rclcpp::Node { Lamp(); … }; }      ->  class lamp::Lamp, function lamp::Lamp::Lamp, …
    void lamp::Lamp::on_switch(const String & msg) { … }                    ->  function lamp::Lamp::on_switch, defined

Only declarations are looked at, bodies of functions are not. What stands in a branch of an `#if` that nobody knows says so.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple

from rosward.frontends.cpp.prepared import Choice

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.parse import Parsed

_CLASSES: Final = frozenset({"class_specifier", "struct_specifier", "union_specifier"})
_GROUPS: Final = frozenset({"translation_unit", "declaration_list", "field_declaration_list", "linkage_specification"})
_DECLARATIONS: Final = frozenset({"declaration", "field_declaration", "function_definition", "type_definition"})
_NAMES: Final = frozenset(
    {
        "identifier", "field_identifier", "type_identifier", "qualified_identifier", "destructor_name", "operator_name",
        "operator_cast", "template_function", "template_method", "template_type", "structured_binding_declarator",
    }
)  # fmt: skip
_WITHOUT_FIELD: Final = frozenset(
    {"reference_declarator", "parenthesized_declarator", "attributed_declarator", "variadic_declarator"}
)
_DEPTH: Final = 200

Scope = tuple[str, ...]


class DeclaredKind(enum.Enum):
    """What is declared."""

    CLASS = "class"
    ENUM = "enum"
    ENUMERATOR = "enumerator"
    FUNCTION = "function"
    VARIABLE = "variable"
    ALIAS = "alias"
    USING = "using"
    USING_NAMESPACE = "using namespace"
    NAMESPACE_ALIAS = "namespace alias"


class Declared(NamedTuple):
    """One declaration: `node` is the class, the function with its declarator, or the declarator of a variable.

    `scope` are the names of the namespaces and classes around it ('' for an unnamed namespace), `template` the parameters of the templates
    that it is, `arguments` what it specialises them for. `defined`: a class or function with its body.
    """

    kind: DeclaredKind
    scope: Scope
    name: str
    node: Node
    template: tuple[Node, ...] = ()
    arguments: str = ""
    defined: bool = False
    choices: tuple[Choice, ...] = ()


class _Waiting(NamedTuple):
    node: Node
    scope: Scope
    template: tuple[Node, ...] = ()


def outline(parsed: Parsed) -> list[Declared]:
    """The declarations of a file, in their order."""
    found: list[Declared] = []
    waiting = [_Waiting(parsed.tree.root_node, ())]
    while waiting:
        here = waiting.pop()
        inner: list[_Waiting] = []
        for each in _declared(here, inner):
            line = each.node.start_point[0] + 1
            choices = tuple(c for c in parsed.prepared.choices if c.first <= line <= c.last)
            found.append(each._replace(choices=choices) if choices else each)
        waiting += reversed(inner)
    return found


def text_of(node: Node | None) -> str:
    """The text of a node, with single blanks."""
    return "" if node is None else " ".join((node.text or b"").decode("utf-8", "replace").split())


def _declared(here: _Waiting, inner: list[_Waiting]) -> Iterator[Declared]:
    """What one node declares; what is to be looked at within goes to `inner`."""
    node, scope, template = here
    kind = node.type
    if kind in _GROUPS:
        if len(scope) < _DEPTH:
            inner += [_Waiting(child, scope) for child in node.named_children]
    elif kind == "namespace_definition":
        name = text_of(node.child_by_field_name("name"))
        body = node.child_by_field_name("body")
        if body is not None:
            inner.append(_Waiting(body, (*scope, *(part.strip().removeprefix("inline ") for part in name.split("::")))))
    elif kind == "template_declaration":
        parameters = node.child_by_field_name("parameters")
        more = (*template, parameters) if parameters is not None else template
        inner += [_Waiting(child, scope, more) for child in node.named_children[1:]]
    elif kind in _CLASSES:
        yield from _class(node, scope, template, inner)
    elif kind == "enum_specifier":
        yield from _enum(node, scope)
    elif kind in _DECLARATIONS:
        yield from _declaration(node, scope, template, inner)
    elif kind == "alias_declaration":
        yield Declared(DeclaredKind.ALIAS, scope, text_of(node.child_by_field_name("name")), node, template)
    elif kind == "namespace_alias_definition":
        yield Declared(DeclaredKind.NAMESPACE_ALIAS, scope, text_of(node.child_by_field_name("name")), node)
    elif kind == "using_declaration":
        named = text_of(node.named_children[-1]) if node.named_children else ""
        if any(child.type == "namespace" for child in node.children):
            yield Declared(DeclaredKind.USING_NAMESPACE, scope, named, node)
        else:
            yield Declared(DeclaredKind.USING, scope, named.rpartition("::")[2], node)


def _class(node: Node, scope: Scope, template: tuple[Node, ...], inner: list[_Waiting]) -> Iterator[Declared]:
    named = node.child_by_field_name("name")
    if named is None:
        return  # what is in it belongs to a variable, or to the class around it
    body = node.child_by_field_name("body")
    outer, name, arguments = _split(named)
    scope = (*scope, *outer)
    yield Declared(DeclaredKind.CLASS, scope, name, node, template, arguments, defined=body is not None)
    if body is not None:
        inner.append(_Waiting(body, (*scope, name + arguments)))


def _enum(node: Node, scope: Scope) -> Iterator[Declared]:
    name = text_of(node.child_by_field_name("name"))
    body = node.child_by_field_name("body")
    if name:
        yield Declared(DeclaredKind.ENUM, scope, name, node, defined=body is not None)
    scoped = any(child.type in {"class", "struct"} for child in node.children)
    for child in body.named_children if body is not None else ():
        if child.type == "enumerator":
            into = (*scope, name) if scoped else scope
            yield Declared(DeclaredKind.ENUMERATOR, into, text_of(child.child_by_field_name("name")), child)


def _declaration(node: Node, scope: Scope, template: tuple[Node, ...], inner: list[_Waiting]) -> Iterator[Declared]:
    """`class A {…} a, * b;`, `int f(), x = 1;`, `void A::f() {…}`."""
    type_node = node.child_by_field_name("type")
    if type_node is not None and (type_node.type in _CLASSES or type_node.type == "enum_specifier"):
        declarators = node.children_by_field_name("declarator")
        if type_node.child_by_field_name("body") is not None or not declarators:
            inner.append(_Waiting(type_node, scope, template))
    for declarator in node.children_by_field_name("declarator"):
        named, is_function = _named(declarator)
        if named is None:
            continue
        if node.type == "type_definition":
            yield Declared(DeclaredKind.ALIAS, scope, text_of(named), node, template)
            continue
        outer, name, arguments = _split(named)
        if is_function:
            defined = node.type == "function_definition"
            yield Declared(DeclaredKind.FUNCTION, (*scope, *outer), name, node, template, arguments, defined)
        else:
            yield Declared(DeclaredKind.VARIABLE, (*scope, *outer), name, declarator, template, arguments)


def _named(declarator: Node) -> tuple[Node | None, bool]:
    """The name in a declarator, and whether the name itself is that of a function."""
    node: Node | None = declarator
    is_function = False
    for _ in range(_DEPTH):
        if node is None or node.type in _NAMES:
            return node, is_function or (node is not None and node.type in {"destructor_name", "operator_cast"})
        is_function = node.type == "function_declarator" or (is_function and node.type == "attributed_declarator")
        if node.type in _WITHOUT_FIELD:
            node = next(
                (child for child in node.named_children if child.type.endswith(("declarator", "identifier"))), None
            )
        else:
            node = node.child_by_field_name("declarator")
    return None, False


def _split(named: Node) -> tuple[Scope, str, str]:
    """The scope that is written before a name, the name, and the arguments of a template behind it."""
    outer: list[str] = []
    node = named
    for _ in range(_DEPTH):
        if node.type != "qualified_identifier":
            break
        before = node.child_by_field_name("scope")
        if before is not None:
            name = before.child_by_field_name("name") if before.type == "template_type" else before
            outer.append(text_of(name))
        after = node.child_by_field_name("name")
        if after is None:
            break
        node = after
    if node.type in {"template_type", "template_function", "template_method"}:
        return tuple(outer), text_of(node.child_by_field_name("name")), text_of(node.child_by_field_name("arguments"))
    return tuple(outer), text_of(node), ""
