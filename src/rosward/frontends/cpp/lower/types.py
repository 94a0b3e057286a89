# SPDX-License-Identifier: Apache-2.0
"""How is a type, as it is written, made a value?

std::vector<T> *      Name std.vector<T>; MakeType pointer
unsigned int          MakeType 'unsigned int'
decltype(x)           TypeOfValue of the slot of x
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.survey import word
from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp import LocalSymbol, MakeType, Name, Part, TypeOfValue

if TYPE_CHECKING:
    from tree_sitter import Node

_BUILTIN: Final = frozenset({"primitive_type", "sized_type_specifier"})
_CLASSES: Final = frozenset({"class_specifier", "struct_specifier", "union_specifier", "enum_specifier"})
_NAMES: Final = frozenset(
    {"type_identifier", "identifier", "qualified_identifier", "template_type", "namespace_identifier", "template_function"}
)  # fmt: skip
_RUNS: Final = frozenset({"call_expression", "assignment_expression", "update_expression", "new_expression"})
_LOOKED_AT: Final = 300

TYPES: Final = (
    _BUILTIN
    | _CLASSES
    | {"template_type", "decltype", "dependent_type", "type_descriptor", "placeholder_type_specifier"}
)
"""What is a type wherever it stands."""
POINTERS: Final = frozenset({"pointer_declarator", "abstract_pointer_declarator", "pointer_type_declarator"})
REFERENCES: Final = frozenset({"reference_declarator", "abstract_reference_declarator"})
ARRAYS: Final = frozenset({"array_declarator", "abstract_array_declarator"})
FUNCTIONS: Final = frozenset({"function_declarator", "abstract_function_declarator"})
DECLARATORS: Final = 50
"""How many pointers, references, brackets may stand in one declarator."""


def type_of(body: Body, node: Node | None, *, keep: bool = False) -> int:
    """The type that a node writes; of a `type_descriptor` with its pointers, and with references where they are to be kept."""
    if node is None:
        return body.nothing()
    kind = node.type
    if kind == "type_descriptor":
        return declared_type(body, node.child_by_field_name("type"), node.child_by_field_name("declarator"), keep=keep)
    if kind in _BUILTIN:
        return _made(body, node, builtin(node))
    if kind == "placeholder_type_specifier":
        inner = node.child_by_field_name("constraint")
        return _made(body, node if inner is None else inner, "auto")
    if kind in ("auto", "decltype"):
        return _decltype(body, node)
    if kind in _NAMES:
        return body.value(node)
    if kind in ("dependent_type", "parameter_pack_expansion") and node.named_children:
        return type_of(body, node.named_children[0], keep=keep)
    if kind in _CLASSES:
        return _class(body, node)
    return body.unknown(node, "syntax")


def builtin(node: Node | None) -> str:
    """`unsigned   int` as `unsigned int`, '' for what is no such type. `size_t` and `uint8_t` are such types for the parser."""
    return " ".join(word(node).split()) if node is not None and node.type in _BUILTIN else ""


def declared_type(
    body: Body, node: Node | None, declarator: Node | None, *, keep: bool = False, result: bool = False
) -> int:
    """The type of a variable, from what stands before the declarators and what its own adds; with `result`, of what a function returns."""
    found = _made(body, declarator, "auto") if node is None and declarator is not None else type_of(body, node)
    here = declarator
    for _ in range(DECLARATORS):
        if here is None:
            break
        if here.type in POINTERS:
            found = _made(body, here, "pointer", (found,))
        elif here.type in ARRAYS:
            size = here.child_by_field_name("size")
            found = _made(body, here, "array", (found,) if size is None else (found, body.value(size)))
        elif here.type in FUNCTIONS and result:
            break
        elif here.type in FUNCTIONS:
            found = _made(body, here, "function", (found, *_takes(body, here)))
        elif here.type in REFERENCES and keep:
            found = _made(body, here, "reference", (found,))
        here = within(here)
    return found


def _takes(body: Body, declarator: Node) -> list[int]:
    listed = declarator.child_by_field_name("parameters")
    return [
        declared_type(body, each.child_by_field_name("type"), each.child_by_field_name("declarator"), keep=True)
        for each in (listed.named_children if listed is not None else ())
        if each.child_by_field_name("type") is not None
    ]


def within(declarator: Node) -> Node | None:
    """What a declarator is about: of `& x`, `* x`, `x[3]`, `x = 1` the `x`."""
    if declarator.type == "qualified_identifier":  # `int A::* member`
        name = declarator.child_by_field_name("name")
        return name if name is not None and name.type in POINTERS | {"qualified_identifier"} else None
    inner = declarator.child_by_field_name("declarator")
    if inner is not None:
        return inner
    ends = ("declarator", "identifier")
    return next((child for child in declarator.named_children if child.type.endswith(ends)), None)


def is_buffer(node: Node | None, declarator: Node | None, *, const: bool, array: bool) -> bool:
    """Whether something is declared as `char *`, through which characters may be written; as a parameter (`array`) also `char x[]`."""
    if const or builtin(node) != "char" or has(declarator, FUNCTIONS | REFERENCES):
        return False
    return has(declarator, POINTERS | (ARRAYS if array else frozenset())) and not (
        has(declarator, ARRAYS) and not array
    )


def is_text_array(node: Node | None, declarator: Node | None, *, const: bool) -> bool:
    """Whether something is declared as `char x[n]`, which is kept as a text that may change."""
    if const or builtin(node) != "char":
        return False
    here, arrays = declarator, 0
    for _ in range(DECLARATORS):
        if here is None or here.type in POINTERS | FUNCTIONS | REFERENCES:
            break
        arrays += here.type in ARRAYS
        here = within(here)
    return here is None and arrays == 1


def has(declarator: Node | None, kinds: frozenset[str]) -> bool:
    """Whether a declarator adds one of these to the type."""
    here = declarator
    for _ in range(DECLARATORS):
        if here is None:
            return False
        if here.type in kinds:
            return True
        here = within(here)
    return False


def is_as_written(type_node: Node | None) -> bool:
    """Whether a type is `decltype(auto)`: that of an expression, also where it is a reference."""
    if type_node is None or type_node.type != "placeholder_type_specifier":
        return False
    return any(child.type == "decltype" for child in type_node.children)


def _type(body: Body, node: Node, _want: Want) -> int:
    """A type where a value may stand as well: `typeid(int)`, an argument or default of a template."""
    return type_of(body, node, keep=True)


def _made(body: Body, node: Node, kind: str, inner: tuple[int, ...] = ()) -> int:
    dst = body.register()
    body.emit(MakeType(*body.place(node), dst, kind, inner))
    return dst


def _decltype(body: Body, node: Node) -> int:
    """`decltype(x)`; what would run something if it were evaluated is not looked into."""
    inner = next((child for child in node.named_children if child.type != "auto"), None)
    if inner is None:
        return _made(body, node, "auto")
    detected = _detected(body, inner) if inner.type != "binary_expression" else _asked_first(body, inner)
    if detected != NO_REGISTER:
        return detected
    waiting = [inner]
    for _ in range(_LOOKED_AT):
        if not waiting:
            break
        here = waiting.pop()
        if here.type in _RUNS:
            return body.unknown(node, "language", "decltype")
        waiting += here.named_children
    src = body.slot(inner)
    dst = body.register()
    body.emit(TypeOfValue(*body.place(node), dst, src))
    return dst


def _detected(body: Body, node: Node) -> int:
    """The type of `std::declval<T>().x`, `std::declval<T>().f(…)`, `&T::x`; NO_REGISTER for anything else."""
    owner = member = None
    if node.type == "pointer_expression" and node.children[0].type == "&":
        name = node.child_by_field_name("argument")
        if name is not None and name.type == "qualified_identifier":
            scope, last = name.child_by_field_name("scope"), name.child_by_field_name("name")
            if scope is not None and last is not None and last.type == "identifier":
                variable = body.variable(word(scope))
                owner = body.value(scope) if variable is not None and variable.raw else None
                member = word(last)
    else:
        called = node.child_by_field_name("function") if node.type == "call_expression" else node
        if called is not None and called.type == "field_expression":
            field, inside = called.child_by_field_name("field"), called.child_by_field_name("argument")
            if (
                field is not None
                and inside is not None
                and field.type == "field_identifier"
                and word(called.child_by_field_name("operator")) == "."
            ):
                owner, member = _made_up(body, inside), word(field)
    if owner is None or owner == NO_REGISTER or not member:
        return NO_REGISTER
    dst = body.register()
    body.emit(TypeOfValue(*body.place(node), dst, owner, member))
    return dst


def _asked_first(body: Body, node: Node) -> int:
    """`decltype(std::declval<T>().f(), void())`, of which `suited` has made one expression; NO_REGISTER for anything else."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    if left is None or right is None or not any(child.type == "%" for child in node.children):
        return NO_REGISTER
    while left is not None and left.type in ("parenthesized_expression", "cast_expression"):
        left = left.child_by_field_name("value") if left.type == "cast_expression" else left.named_children[0]
    detected = NO_REGISTER if left is None else _detected(body, left)
    if detected == NO_REGISTER:
        return NO_REGISTER
    if word(right).replace(" ", "") != "void()":
        return body.unknown(node, "language", "decltype")
    dst = body.register()
    body.emit(Name(*body.place(node), dst, (Part("std"), Part("void_t", (detected,)))))
    return dst


def _made_up(body: Body, node: Node) -> int:
    """The type of `std::declval<T>()`, or of a member of it."""
    while node.type == "parenthesized_expression" and node.named_children:
        node = node.named_children[0]
    function = node.child_by_field_name("function") if node.type == "call_expression" else None
    text = word(function)
    if function is not None and text.startswith(("std::declval<", "declval<")):
        while function is not None and function.type == "qualified_identifier":
            function = function.child_by_field_name("name")
        types = function.child_by_field_name("arguments") if function is not None else None
        return (
            type_of(body, types.named_children[0])
            if types is not None and len(types.named_children) == 1
            else NO_REGISTER
        )
    return _detected(body, node)


def _class(body: Body, node: Node) -> int:
    """A class that is declared here, or `struct A` for a name."""
    name = node.child_by_field_name("name")
    known = name is not None and word(name) in body.scopes[-1].names
    if name is not None and (known or node.child_by_field_name("body") is None):
        return body.value(name)
    symbol = body.shared.local(node)
    if symbol is None:
        return body.unknown(node, "syntax")
    types: dict[str, int] = {}
    variables: dict[str, int] = {}
    for mentioned in _mentioned(node):
        variable = body.variable(mentioned)
        if variable is None or variable.path:
            continue
        if variable.raw:
            types[mentioned] = body.held(node, variable)
        elif variable.reference or variable.constant:
            variables[mentioned] = body.of_variable(node, variable, "slot")
    dst = body.register()
    names, registers = (*types, *variables), (*types.values(), *variables.values())
    body.emit(LocalSymbol(*body.place(node), dst, symbol, names, registers, len(types)))
    return dst


def _mentioned(node: Node) -> Iterable[str]:
    """The names in a class, each once."""
    found: dict[str, None] = {}
    waiting = list(reversed(node.named_children))
    while waiting:
        here = waiting.pop()
        if here.type in ("identifier", "type_identifier", "namespace_identifier"):
            found[word(here)] = None
        waiting += reversed(here.named_children)
    return found


EXPRESSIONS: Final = dict.fromkeys(_BUILTIN | _CLASSES | {"decltype", "dependent_type", "type_descriptor"}, _type)
