# SPDX-License-Identifier: Apache-2.0
"""Which type is written, and which parameters has a function?

    const std::vector<T> & v = {}, Args &&... more      ->  v: std::vector (T), const, &, with a default; more: Args, &&, a pack

What no name is (`decltype(x)`, a member of a type that is a parameter) is its words: nothing is concluded from it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, Literal

from rosward.frontends.cpp.declarators import DEPTH, dense, inner, named, spelled, text_of
from rosward.ir.symbols import ParameterSymbol, TypePattern

if TYPE_CHECKING:
    from tree_sitter import Node

_NAMED: Final = frozenset(
    {"type_identifier", "qualified_identifier", "template_type", "identifier", "namespace_identifier"}
)
_PARAMETERS: Final = frozenset(
    {"parameter_declaration", "optional_parameter_declaration", "variadic_parameter_declaration"}
)
_POINTERS: Final = frozenset(
    {"pointer_declarator", "abstract_pointer_declarator", "array_declarator", "abstract_array_declarator"}
)
_ARRAYS: Final = frozenset({"array_declarator", "abstract_array_declarator"})
_REFERENCES: Final = frozenset({"reference_declarator", "abstract_reference_declarator"})
_FUNCTIONS: Final = frozenset({"function_declarator", "abstract_function_declarator"})
_VARIADIC: Final = frozenset({"variadic_declarator", "abstract_variadic_declarator"})
_NESTED: Final = 30
"""How deep types in types are looked into."""


def parameters(declarator: Node | None) -> tuple[ParameterSymbol, ...]:
    """The parameters in a function's declarator; `...` of C is a pack without a name."""
    c_pack = ParameterSymbol("", TypePattern(builtin="..."), pack=True)
    found = tuple(c_pack if node is None else _parameter(node) for node in parameter_nodes(declarator))
    return () if found == (ParameterSymbol("", TypePattern(builtin="void")),) else found


def parameter_nodes(declarator: Node | None) -> list[Node | None]:
    """The parameters in a function's declarator as they are written; None for the `...` of C."""
    listed = None if declarator is None else declarator.child_by_field_name("parameters")
    if listed is None:
        return []
    return [child if child.is_named else None for child in listed.children if child.type in {*_PARAMETERS, "..."}]


def _parameter(node: Node) -> ParameterSymbol:
    declarator = node.child_by_field_name("declarator")
    name = None if declarator is None else named(declarator)[0]
    pattern = written(node)
    pack = pattern.pack or node.type == "variadic_parameter_declaration"
    default = node.type == "optional_parameter_declaration"
    return ParameterSymbol(text_of(name), pattern._replace(pack=False), default, pack)


def written(node: Node, depth: int = 0) -> TypePattern:
    """The type that a declaration, parameter or `type_descriptor` writes: with its qualifiers, and what its declarator adds."""
    return pattern(
        node.child_by_field_name("type"), node.child_by_field_name("declarator"), const=has_const(node), depth=depth
    )


def declared(whole: Node, declarator: Node) -> TypePattern:
    """The type of a variable that a declaration declares; of an alias, what it stands for."""
    if whole.type == "alias_declaration":
        type_ = whole.child_by_field_name("type")
        return TypePattern() if type_ is None else written(type_)
    found = pattern(whole.child_by_field_name("type"), declarator)
    here: Node | None = declarator
    while here is not None and here.type == "init_declarator":
        here = inner(here)
    return found._replace(array=True) if here is not None and here.type in _ARRAYS else found


def has_const(node: Node) -> bool:
    """Whether `const` or `constexpr` stands beside a type."""
    return any(child.type == "type_qualifier" and child.text in {b"const", b"constexpr"} for child in node.children)


def pattern(type_: Node | None, declarator: Node | None, *, const: bool = False, depth: int = 0) -> TypePattern:
    """The type of a declarator."""
    found = _plain(type_, depth)
    if const:
        found = found._replace(const=True)
    pointers = 0
    reference: Literal["", "&", "&&"] = ""
    pack = found.pack
    size = ""
    node = declarator
    for _ in range(DEPTH):
        if node is None:
            break
        if node.type in _FUNCTIONS:
            takes = tuple(each.type._replace(pack=each.pack) for each in parameters(node))
            found = TypePattern(builtin="function", arguments=(found._replace(pointers=pointers), *takes))
            pointers = 0
        elif node.type in _POINTERS:
            pointers += 1
            counted = node.child_by_field_name("size")
            size = text_of(counted) if counted is not None and counted.type in _NAMED else size
        elif node.type in _REFERENCES:
            reference = "&&" if any(child.type == "&&" for child in node.children) else "&"
        elif node.type in _VARIADIC:
            pack = True
        node = inner(node) if node.type not in _REFERENCES | _VARIADIC else _within(node)
    return found._replace(pointers=found.pointers + pointers, reference=reference, pack=pack, size=size)


def _within(node: Node) -> Node | None:
    return next((child for child in node.named_children if child.type.endswith(("declarator", "identifier"))), None)


def _plain(node: Node | None, depth: int) -> TypePattern:
    """A type without what is around its name."""
    if node is None:
        return TypePattern(builtin="auto")
    if node.type == "dependent_type" and node.named_children:
        node = node.named_children[0]
    if node.type.endswith("_specifier"):  # `struct A`, and `unsigned int`, `auto`
        name = node.child_by_field_name("name")
        node = name if name is not None else node
    if node.type not in _NAMED or depth > _NESTED:
        return TypePattern(builtin=dense(node))
    parts = spelled(node)
    if any(part.arguments is not None for part in parts.scope):
        return TypePattern(builtin=dense(node))
    names = (*(part.name for part in parts.scope), parts.last.name)
    return TypePattern(names, arguments(parts.last.arguments, depth + 1))


def arguments(node: Node | None, depth: int = 0) -> tuple[TypePattern, ...]:
    """The arguments of a template."""
    return () if node is None else tuple(_arguments(node, depth))


_PLAIN: Final = frozenset({"type_identifier", "identifier", "number_literal", "true", "false", "primitive_type"})


def tested(node: Node | None) -> list[Node | None]:
    """The arguments of a template that may have to be evaluated to know what they are; None for those that are names or numbers."""
    found: list[Node | None] = []
    for child in node.named_children if node is not None else ():
        inside = child.child_by_field_name("type") if child.type == "type_descriptor" else child
        is_plain = inside is None or inside.type in _PLAIN or child.child_by_field_name("declarator") is not None
        found.append(None if is_plain or child.type == "parameter_pack_expansion" else child)
    return found


def _arguments(node: Node, depth: int) -> Iterator[TypePattern]:
    for child in node.named_children:
        pack = child.type == "parameter_pack_expansion"
        each = child.child_by_field_name("pattern") if pack else child
        if each is None:
            continue
        found = written(each, depth) if each.type == "type_descriptor" else _plain(each, depth)
        yield found._replace(pack=True) if pack else found
