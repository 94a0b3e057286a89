# SPDX-License-Identifier: Apache-2.0
"""Which names does a file declare, in which scopes?

    namespace lamp { class Lamp : public rclcpp::Node { Lamp(); … }; }      ->  class lamp::Lamp, and in it function Lamp
    void lamp::Lamp::on_switch(const String & msg) { … }                    ->  function on_switch, defined, with lamp::Lamp before it

Only declarations are looked at, bodies of functions are not, and those of classes when they are asked for. What stands in a branch of
an `#if` that nobody knows says so.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.declarators import (
    DEPTH,
    Part,
    dense,
    named,
    spelled,
    template_parameter_name,
    text_of,
    unnamed,
)
from rosward.frontends.cpp.prepared import Choice
from rosward.ir.symbols import Scope, SymbolKind
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.parse import Parsed

CLASSES: Final = frozenset({"class_specifier", "struct_specifier", "union_specifier"})
_GROUPS: Final = frozenset({"translation_unit", "declaration_list", "field_declaration_list", "linkage_specification"})
_DECLARATIONS: Final = frozenset({"declaration", "field_declaration", "function_definition", "type_definition"})
_MADE_UP: Final = (b"= default;", b"=default;")
"""How a friend ends that is defined without a body."""


class Declared(NamedTuple):
    """One declaration: `node` is the class, the function with its declarator, or the declarator of a variable; `whole` is what it is part of.

    `scope` are the names of the namespaces and classes around it ('' for an unnamed namespace), `before` what is written before the name.
    `templates` are the lists of parameters of the templates around it in the same declaration, those of the class that `before` names included;
    `arguments` what it specialises them for. `defined`: a class or function with its body. `friend`: it stands in a class.
    """

    kind: SymbolKind
    scope: Scope
    name: str
    node: Node
    whole: Node
    templates: tuple[Node, ...] = ()
    arguments: Node | None = None
    before: tuple[Part, ...] = ()
    defined: bool = False
    friend: bool = False
    choices: tuple[Choice, ...] = ()

    @property
    def label(self) -> str:
        """The name of the scope that it makes: a specialisation has its own."""
        return self.name + dense(self.arguments)

    @property
    def called(self) -> tuple[str, ...]:
        """What a definition elsewhere calls the parameters of the only class template that is written before its name."""
        if not self.templates or [part.arguments is not None for part in self.before].count(True) != 1:
            return ()
        return tuple(template_parameter_name(each) for each in self.templates[0].named_children)


class Outline(NamedTuple):
    """What a file declares outside of classes; `spaces` are its namespaces, `inlines` those in which names are seen from outside."""

    declared: list[Declared]
    spaces: dict[Scope, None]
    inlines: dict[Scope, Scope]


class _Waiting(NamedTuple):
    node: Node
    scope: Scope
    templates: tuple[Node, ...] = ()


def outline(parsed: Parsed) -> Outline:
    """The declarations of a file outside of classes, in their order; functions that are defined in a class as its friends included."""
    found = Outline([], {(): None}, {})
    for each in _walk(_Waiting(parsed.tree.root_node, ()), found):
        found.declared.append(_chosen(parsed, each))
        if each.kind is SymbolKind.CLASS:
            found.declared.extend(e._replace(scope=each.scope) for e in _friends(parsed, each))
    return found


def namespace_at(parsed: Parsed, line: int) -> Scope:
    """The namespace around a line of a file."""
    scope: Scope = ()
    waiting = [_Waiting(parsed.tree.root_node, scope)]
    while waiting:
        node, scope, _ = waiting.pop()
        for child in node.named_children:
            if child.start_point[0] < line <= child.end_point[0] + 1:
                if child.type == "namespace_definition":
                    _namespace(child, scope, waiting, Outline([], {}, {}))
                elif child.type in _GROUPS:
                    waiting.append(_Waiting(child, scope))
    return scope


def _friends(parsed: Parsed, of: Declared) -> Iterator[Declared]:
    """The functions that a class defines as its friends, which are not its members. Most classes are not looked into."""
    waiting = [of]
    while waiting:
        here = waiting.pop()
        if b"friend" in (here.node.text or b""):
            inner = list(_members(parsed, here))
            yield from (each for each in inner if each.friend)
            waiting += [each for each in inner if each.kind is SymbolKind.CLASS]


def members(parsed: Parsed, of: Declared) -> Iterator[Declared]:
    """What a class or enum declares, in its order."""
    return (each for each in _members(parsed, of) if not each.friend)


def _members(parsed: Parsed, of: Declared) -> Iterator[Declared]:
    body = of.node.child_by_field_name("body")
    scope = (*of.scope, *(part.name for part in of.before), of.label)
    if body is None:
        return
    if of.kind is SymbolKind.ENUM:
        yield from _enumerators(body, scope if is_scoped(of.node) else of.scope)
        return
    for each in _walk(_Waiting(body, scope), Outline([], {}, {})):
        yield _chosen(parsed, each)


def is_scoped(node: Node) -> bool:
    """Whether it is an `enum class`."""
    return any(child.type in {"class", "struct"} for child in node.children)


def local(parsed: Parsed, node: Node, scope: Scope) -> Declared | None:
    """The class or enum that a function body declares at `node`, with or without a name."""
    if node.child_by_field_name("name") is None:
        found = _type(node, node, scope, (), [], unnamed(node))
        return next((_chosen(parsed, each) for each in found), None)
    return next((_chosen(parsed, each) for each in _walk(_Waiting(node, scope), Outline([], {}, {}))), None)


def _chosen(parsed: Parsed, each: Declared) -> Declared:
    line = each.node.start_point[0] + 1
    choices = tuple(c for c in parsed.prepared.choices if c.first <= line <= c.last)
    return each._replace(choices=choices) if choices else each


def _walk(start: _Waiting, into: Outline) -> Iterator[Declared]:
    waiting = [start]
    while waiting:
        inner: list[_Waiting] = []
        yield from _declared(waiting.pop(), inner, into)
        waiting += reversed(inner)


def _declared(here: _Waiting, inner: list[_Waiting], into: Outline) -> Iterator[Declared]:
    """What one node declares; what is to be looked at within goes to `inner`."""
    node, scope, templates = here
    kind = node.type
    if kind in _GROUPS:
        if len(scope) < DEPTH:
            inner += [_Waiting(child, scope) for child in node.named_children]
    elif kind == "namespace_definition":
        _namespace(node, scope, inner, into)
    elif kind == "template_declaration":
        parameters = node.child_by_field_name("parameters")
        more = (*templates, parameters) if parameters is not None else templates
        inner += [_Waiting(child, scope, more) for child in node.named_children[1:]]
    elif kind in CLASSES or kind == "enum_specifier":
        yield from _type(node, node, scope, templates, inner, None)
    elif kind in _DECLARATIONS:
        yield from _declaration(node, scope, templates, inner)
    elif kind == "friend_declaration":
        for child in node.named_children:
            if child.type == "function_definition" or (child.text or b"").endswith(_MADE_UP):
                yield from (each._replace(friend=True) for each in _declaration(child, scope, templates, inner))
    elif kind == "alias_declaration":
        name = text_of(node.child_by_field_name("name"))
        yield Declared(SymbolKind.ALIAS, scope, name, node, node, templates)
    elif kind == "namespace_alias_definition":
        yield Declared(SymbolKind.NAMESPACE_ALIAS, scope, text_of(node.child_by_field_name("name")), node, node)
    elif kind == "using_declaration":
        if any(child.type == "namespace" for child in node.children):
            name = dense(node.named_children[-1]) if node.named_children else ""
            yield Declared(SymbolKind.USING_NAMESPACE, scope, name.removeprefix("::"), node, node)
        else:
            for child in node.named_children:
                yield Declared(SymbolKind.USING, scope, spelled(child).last.name, child, node)


def _namespace(node: Node, scope: Scope, inner: list[_Waiting], into: Outline) -> None:
    """`inline` ones and those within them are the ones around them."""
    parts = text_of(node.child_by_field_name("name")).split("::")
    is_inline = any(child.type == "inline" for child in node.children)
    for part in parts:
        name = part.strip()
        within = (*scope, name.removeprefix("inline ").strip())
        if is_inline or name.startswith("inline "):
            into.inlines[within] = scope
            is_inline = False
        else:
            scope = within
        into.spaces[within] = None
    body = node.child_by_field_name("body")
    if body is not None:
        inner.append(_Waiting(body, scope))


def _type(
    node: Node, whole: Node, scope: Scope, templates: tuple[Node, ...], inner: list[_Waiting], standing: str | None
) -> Iterator[Declared]:
    """A class or enum. Without a name it has the one `standing` for it; without that, what is in it belongs to what is around it."""
    name = node.child_by_field_name("name")
    body = node.child_by_field_name("body")
    is_enum = node.type == "enum_specifier"
    if name is None and not standing:
        if body is not None and is_enum:
            yield from _enumerators(body, scope)
        elif body is not None:
            inner.append(_Waiting(body, scope))
        return
    word = spelled(name) if name is not None else None
    last = word.last if word is not None else Part(standing or "")
    kind = SymbolKind.ENUM if is_enum else SymbolKind.CLASS
    before = word.scope if word is not None else ()
    yield Declared(kind, scope, last.name, node, whole, templates, last.arguments, before, defined=body is not None)
    if is_enum and body is not None and not is_scoped(node):
        yield from _enumerators(body, (*scope, *(part.name for part in before)))


def _enumerators(body: Node, scope: Scope) -> Iterator[Declared]:
    for child in body.named_children:
        if child.type == "enumerator":
            yield Declared(SymbolKind.ENUMERATOR, scope, text_of(child.child_by_field_name("name")), child, child)


def _declaration(node: Node, scope: Scope, templates: tuple[Node, ...], inner: list[_Waiting]) -> Iterator[Declared]:
    """`class A {…} a, * b;`, `int f(), x = 1;`, `void A::f() {…}`."""
    declarators = node.children_by_field_name("declarator")
    type_node = node.child_by_field_name("type")
    if type_node is not None and (type_node.type in CLASSES or type_node.type == "enum_specifier"):
        has_body = type_node.child_by_field_name("body") is not None
        if has_body or not declarators:
            yield from _type(type_node, node, scope, templates, inner, _standing(node, type_node, declarators))
    for declarator in declarators:
        name, is_function = named(declarator)
        if name is None:
            continue
        if node.type == "type_definition":
            if type_node is None or text_of(name) != _standing(node, type_node, declarators):
                yield Declared(SymbolKind.ALIAS, scope, text_of(name), declarator, node, templates)
        elif name.type == "structured_binding_declarator":
            continue
        else:
            before, last, absolute = spelled(name)
            yield Declared(
                SymbolKind.FUNCTION if is_function else SymbolKind.VARIABLE,
                () if absolute else scope,
                last.name,
                node if is_function else declarator,
                node,
                templates,
                last.arguments,
                before,
                is_function and _has_body(node),
            )


def _has_body(node: Node) -> bool:
    """`{ … }`, or `try { … } catch …` around what a constructor does."""
    return node.child_by_field_name("body") is not None or any(c.type == "try_statement" for c in node.named_children)


def _standing(node: Node, type_node: Node, declarators: list[Node]) -> str | None:
    """What names a class without a name: `typedef struct {…} Name;`, or a word of ours where variables have its type."""
    if (
        type_node.child_by_field_name("body") is None
        or type_node.child_by_field_name("name") is not None
        or not declarators
    ):
        return None
    if node.type == "type_definition" and declarators[0].type == "type_identifier":
        return text_of(declarators[0])
    return unnamed(type_node)


def enumeration_name(node: Node) -> str:
    """What an enum is called: by itself, by its `typedef`, or by a word of ours where variables have its type; else ''."""
    name = node.child_by_field_name("name")
    if name is not None:
        return spelled(name).last.name
    whole = node.parent
    return (_standing(whole, node, whole.children_by_field_name("declarator")) if whole is not None else None) or ""


def has_variables(node: Node) -> bool:
    """Whether a class stands where variables are declared of it: `struct {float x; float y;} part;`."""
    return node.parent is not None and bool(node.parent.children_by_field_name("declarator"))
