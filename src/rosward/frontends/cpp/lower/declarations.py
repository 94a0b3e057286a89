# SPDX-License-Identifier: Apache-2.0
"""Declarations in a body: variables of all forms, structured bindings, `static` ones, classes, aliases.

T x(a);   T x = a;   auto x = a;   T & x = a;   auto [a, b] = p;   static T x;   Guard guard(mutex);
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.arithmetic import type_written
from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.initialisers import Given, construct, given, is_place
from rosward.frontends.cpp.lower.literals import is_of
from rosward.frontends.cpp.lower.lvalues import is_lvalue
from rosward.frontends.cpp.lower.names import parts_of
from rosward.frontends.cpp.lower.seen import over, own, part_counts, written_cast
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import (
    ARRAYS,
    FUNCTIONS,
    POINTERS,
    REFERENCES,
    builtin,
    declared_type,
    has,
    is_as_written,
    is_buffer,
    is_text_array,
    type_of,
    within,
)
from rosward.frontends.cpp.lower.variables import Variable
from rosward.frontends.cpp.lower.vexing import arguments_in, combined, meant, referent
from rosward.frontends.cpp.patterns import has_const
from rosward.ir.arithmetic import WRAPPING
from rosward.ir.core import NO_REGISTER, Binary
from rosward.ir.cpp import Convert, Copy, Destructure, Placed, StaticLocal
from rosward.ir.cpp_names import NUMBERED

if TYPE_CHECKING:
    from tree_sitter import Node

_AUTO: Final = frozenset({"placeholder_type_specifier", "auto"})
_CLASSES: Final = frozenset({"class_specifier", "struct_specifier", "union_specifier", "enum_specifier"})
_LASTING: Final = frozenset({"static", "thread_local"})


def _declaration(body: Body, node: Node) -> None:
    """`T a = 1, * b, c(2);`. What is only declared (`extern`, a function) is found by its name."""
    type_node = node.child_by_field_name("type")
    if type_node is not None and type_node.type in _CLASSES and type_node.child_by_field_name("body") is not None:
        local_class(body, type_node)
    words = {word(child) for child in node.children if child.type == "storage_class_specifier"}
    declarators = node.children_by_field_name("declarator")
    if not declarators and (type_node is None or type_node.type not in _CLASSES):
        body.unknown(node, "syntax")
    for declarator in declarators:
        if "extern" in words:
            continue
        if node.has_error and any(child.is_error for child in node.children):
            body.unknown(node, "syntax")
        value = node.child_by_field_name("value") if declarator.type != "init_declarator" else None
        variable(body, node, type_node, declarator, value, static=not words.isdisjoint(_LASTING))
        body.free_register = body.floor


def variable(
    body: Body,
    node: Node,
    type_node: Node | None,
    declarator: Node,
    value: Node | None = None,
    *,
    static: bool = False,
) -> Variable | None:
    """One variable. `value` is what it begins with, where the declarator does not say that itself."""
    shape = declarator
    equals = value is not None
    if declarator.type == "init_declarator":
        value = declarator.child_by_field_name("value")
        equals = any(child.type == "=" for child in declarator.children)
        inner = declarator.child_by_field_name("declarator")
        shape = inner if inner is not None else declarator
        if declarator.has_error and any(child.is_error for child in declarator.children):
            body.unknown(declarator, "syntax")
    what: Node | Given | None = value
    if value is None and shape.type in FUNCTIONS:
        listed = arguments_in(shape)
        if listed is None:
            return None  # a function, found by its name
        inner = within(shape)
        shape = inner if inner is not None else shape
        what = Given(tuple(meant(body, each) for each in listed), "paren")
    if value is None and shape.type == "reference_declarator":
        what = value = referent(shape)
        if value is None and type_node is not None:
            if not has(shape, FUNCTIONS):
                combined(body, type_node, shape)
            return None
    name = _name(shape)
    if name is None:
        body.unknown(declarator, "syntax")
        return None
    if name.type == "structured_binding_declarator":
        parts = (
            [over(body, value, f"{NUMBERED}{i}") for i in range(len(name.named_children))] if value is not None else []
        )
        whole = None if value is None else _single(value)
        bind(body, node, shape, name, body.slot(whole) if has(shape, REFERENCES) else body.own(whole))
        for child, each in zip(name.named_children, parts, strict=False):
            bound = body.variable(word(child))
            if bound is not None:
                bound.over, bound.counts = each, True
        return None
    return _one(body, node, type_node, shape, word(name), what, static=static, equals=equals)


def _name(declarator: Node) -> Node | None:
    here: Node | None = declarator
    for _ in range(50):
        if here is None or here.type in ("identifier", "structured_binding_declarator", "type_identifier"):
            return here
        here = within(here)
    return None


def _one(
    body: Body,
    node: Node,
    type_node: Node | None,
    shape: Node,
    name: str,
    what: Node | Given | None,
    *,
    static: bool,
    equals: bool,
) -> Variable:
    written = None if isinstance(what, Given) else what
    reference = has(shape, REFERENCES) or (is_as_written(type_node) and written is not None and is_place(body, written))
    points = has(shape, POINTERS | ARRAYS | FUNCTIONS)
    number = "" if points or static else builtin(type_node)
    itself = isinstance(what, Given) or what is None or what.type != "lambda_expression"  # a lambda may call itself
    constant = has_const(node) and itself and not has(shape, POINTERS | ARRAYS)
    characters = not reference and is_text_array(type_node, shape, const=has_const(node))
    is_auto = type_node is None or type_node.type in _AUTO
    whole = over(body, _single(what)) if is_auto and what is not None and not isinstance(what, Given) else None
    if (
        is_auto
        and not (reference or points or static or isinstance(what, Given))
        and (wraps := type_written(body, what)) in WRAPPING
    ):
        number = wraps
    found = body.declare(
        name,
        reference=reference or static,
        builtin=number,
        pointer=has(shape, POINTERS),
        constant=constant,
        cell=characters and not static,
    )
    found.alterable = not (constant or static or (reference and (is_auto or has_const(node))))
    found.buffer = characters
    found.leads_to_constant = has_const(node) and has(shape, POINTERS)
    is_first = found.written is None and found.over is None  # not so in another branch of an `#if`
    found.written = (type_node, shape) if type_node is not None and not is_auto else None
    if is_auto and what is not None and not isinstance(what, Given) and (reference or has(shape, POINTERS)):
        found.written = written_cast(what)
    found.over = whole if is_first and found.written is None else None
    found.counts = whole is not None and not points and part_counts(whole.node)
    if static:
        result = NO_REGISTER

        def first() -> None:
            nonlocal result
            result = initial(body, node, type_node, shape, what, equals=equals)

        block = body.block(first)
        dst = body.register()
        body.emit(StaticLocal(*body.place(node), dst, block, result))
        body.write(node, found, dst)
    elif reference and not isinstance(what, Given):
        referred = _referred(body, node, type_node, shape, what)
        if shape.children[:1] and shape.children[0].type == "&&" and body.shared.survey.changes(name):
            body.emit(Placed(*body.place(node), referred, referred, "found"))
        body.write(node, found, referred)
    else:
        body.write(node, found, initial(body, node, type_node, shape, what, equals=equals, local=True))
        holds = not number and not has(shape, POINTERS | FUNCTIONS) and not builtin(type_node)
        if holds and found not in body.scopes[-1].objects:
            body.scopes[-1].objects.append(found)
    return found


def _single(value: Node) -> Node:
    """What is in the brackets of `auto x{a}` and `auto x(a)`."""
    is_list = value.type in ("argument_list", "initializer_list") and len(value.named_children) == 1
    return value.named_children[0] if is_list else value


def initial(
    body: Body,
    node: Node,
    type_node: Node | None,
    shape: Node | None,
    what: Node | Given | None,
    *,
    equals: bool,
    local: bool = False,
) -> int:
    """The first value of a variable by value; `local`: of one that ends with a block."""
    auto = type_node is None or type_node.type in _AUTO
    if auto and isinstance(what, Given):  # `auto b(a);`
        if len(what.arguments) != 1:
            return body.unknown(node, "syntax")
        dst = body.register()
        body.emit(Copy(*body.place(node), dst, what.arguments[0].register, NO_REGISTER))
        return dst
    if auto and what is not None and not isinstance(what, Given):
        return _deduced(body, what, equals)
    if (
        not isinstance(what, Given)
        and is_of(builtin(type_node), what)
        and not has(shape, POINTERS | ARRAYS | FUNCTIONS)
    ):
        return body.value(what)
    kind = declared_type(body, type_node, shape)
    if (
        not isinstance(what, Given)
        and what is not None
        and is_lvalue(what)
        and is_buffer(type_node, shape, const=has_const(node), array=False)
    ):
        slot, dst = body.slot(what), body.register()
        body.emit(Convert(*body.place(node), dst, slot, kind, "buffer"))
        return dst
    made = what if isinstance(what, Given) else given(body, what, copy=equals)
    return construct(body, node, kind, made, local=local)


def _deduced(body: Body, value: Node, equals: bool) -> int:
    """`auto x = a`, `auto x{a}`, `auto x(a)`."""
    inner = [child for child in value.named_children if child.type != "comment"]
    if value.type == "argument_list" or (value.type == "initializer_list" and not equals):
        return own(body, inner[0]) if len(inner) == 1 else body.unknown(value, "syntax")
    return own(body, value)


def _referred(body: Body, node: Node, type_node: Node | None, shape: Node, value: Node | None) -> int:
    """What a reference refers to: a place, or a new value that lives as long."""
    if value is not None and value.type in ("argument_list", "initializer_list") and len(value.named_children) == 1:
        value = value.named_children[0]
    if value is None:
        return body.unknown(node, "syntax")
    auto = type_node is None or type_node.type in _AUTO
    if auto or is_lvalue(value) or value.type in ("call_expression", "conditional_expression", "type_identifier"):
        return body.slot(value)
    return construct(body, node, declared_type(body, type_node, shape), given(body, value, copy=True))


def bind(body: Body, node: Node, shape: Node, names: Node, src: int) -> None:
    """`auto [a, b] = p`, `auto & [a, b] = p`."""
    reference = has(shape, REFERENCES)
    listed = [child for child in names.named_children if child.type == "identifier"]
    variables = [body.declare(word(child), reference=reference, constant=has_const(node)) for child in listed]
    dsts = tuple(body.register() if v.register == NO_REGISTER else v.register for v in variables)
    body.emit(Destructure(*body.place(node), dsts, src, slot=reference))
    for each, dst in zip(variables, dsts, strict=True):
        if each.register == NO_REGISTER:
            body.write(node, each, dst)


def condition(body: Body, node: Node) -> Variable | None:
    """`if (auto p = f())`, `while (T x{…})`: the variable."""
    declarator = node.child_by_field_name("declarator")
    if declarator is None:
        return None
    value = node.child_by_field_name("value")
    return variable(body, node, node.child_by_field_name("type"), declarator, value)


def local_class(body: Body, node: Node) -> None:
    """A class or enum in a body: its name is a variable with the type; so are its enumerators."""
    name = node.child_by_field_name("name")
    found: Variable | None = None
    if name is not None:
        src = type_of(body, node)
        found = body.declare(word(name), type_=True)
        body.write(node, found, src)
    inner = node.child_by_field_name("body")
    scoped = any(child.type in ("class", "struct") for child in node.children)
    before, steps = NO_REGISTER, 0
    for child in inner.named_children if inner is not None and node.type == "enum_specifier" else ():
        if child.type == "enumerator":
            text = word(child.child_by_field_name("name"))
            written = child.child_by_field_name("value")
            value = body.value(written) if written is not None else _more(body, child, before, steps)
            enumerator = body.declare(text, type_=True)
            body.write(child, enumerator, value)
            before, steps = (
                (enumerator.register, 1) if written is not None or before == NO_REGISTER else (before, steps + 1)
            )
            if found is not None:
                found.members[text] = enumerator
            if scoped:
                del body.scopes[-1].names[text]
            body.free_register = body.floor
    body.free_register = body.floor


def _more(body: Body, node: Node, before: int, steps: int) -> int:
    """So many more than a value; 0 where nothing is before."""
    if before == NO_REGISTER:
        return body.constant(node, 0)
    more = body.constant(node, steps)
    dst = body.register()
    body.emit(Binary(*body.place(node), dst, "+", before, more))
    return dst


def enumerated(body: Body, node: Node) -> int:
    """The value of an enumerator: one more than that before it, where none is written."""
    before: Node | None = None
    steps = 0
    for sibling in node.parent.named_children if node.parent is not None else ():
        value = sibling.child_by_field_name("value") if sibling.type == "enumerator" else None
        if value is not None:
            before, steps = value, 0
        elif sibling.type == "enumerator":
            steps += 1
        if sibling == node:
            break
    if before is None:
        return body.constant(node, steps - 1)
    found = body.value(before)
    return _more(body, node, found, steps) if steps else found


def _alias(body: Body, node: Node) -> None:
    """`using A = T;`."""
    found = body.declare(word(node.child_by_field_name("name")), type_=True)
    body.write(node, found, type_of(body, node.child_by_field_name("type")))


def _typedef(body: Body, node: Node) -> None:
    type_node = node.child_by_field_name("type")
    for declarator in node.children_by_field_name("declarator"):
        name = _name(declarator)
        if name is None:
            body.unknown(node, "syntax")
            continue
        found = body.declare(word(name), type_=True)
        body.write(node, found, declared_type(body, type_node, declarator))


def _namespace_alias(body: Body, node: Node) -> None:
    """`namespace fs = std::filesystem;`: another name."""
    name = node.child_by_field_name("name")
    behind = node.named_children[-1]
    words = tuple("".join(text.split()) for text in word(behind).split("::"))
    if name is None or behind == name or not all(words[1:]):
        body.unknown(node, "syntax")
        return
    rename(body, word(name), words)


def rename(body: Body, name: str, path: tuple[str, ...]) -> None:
    """A name that stands for another one."""
    body.scopes[-1].names[name] = Variable(name, NO_REGISTER, NO_REGISTER, path=path)


def _using(body: Body, node: Node) -> None:
    """`using std::string;` is another name; `using namespace a;` is told to whoever looks names up."""
    target = next((child for child in node.named_children), None)
    written = None if target is None else parts_of(target)
    if target is None or written is None or written.base is not None:
        body.unknown(node, "syntax")
        return
    path = tuple(text for text, _ in written.parts)
    path = ("", *path) if written.absolute else path
    if any(child.type == "namespace" for child in node.children):
        body.shared.using.append(path)
    else:
        rename(body, path[-1], path)


def _enum_or_class(body: Body, node: Node) -> None:
    if node.child_by_field_name("body") is not None:
        local_class(body, node)


STATEMENTS: Final = {
    "declaration": _declaration,
    "type_definition": _typedef,
    "alias_declaration": _alias,
    "namespace_alias_definition": _namespace_alias,
    "using_declaration": _using,
    **dict.fromkeys(_CLASSES, _enum_or_class),
}
