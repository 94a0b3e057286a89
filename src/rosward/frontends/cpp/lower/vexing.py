# SPDX-License-Identifier: Apache-2.0
"""What is a declaration that reads like that of a function, or of a reference: `Guard guard(mutex);`, `Lamp & other(lamp);`, `archive & field;`?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.casts import CASTS, Cast, by_value
from rosward.frontends.cpp.lower.lvalues import kind_of_call, kind_of_variable
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import FUNCTIONS, type_of, within
from rosward.ir.core import Binary
from rosward.ir.cpp import Argued, Convert, Invoke, Item

if TYPE_CHECKING:
    from tree_sitter import Node

__all__ = ["arguments_in", "combined", "meant", "referent"]


def referent(shape: Node) -> Node | None:
    """`lamp` in `Lamp & other(lamp);`, which reads like the declaration of a function."""
    inner = within(shape)
    listed = arguments_in(inner) if inner is not None and inner.type in FUNCTIONS else None
    if listed is None or len(listed) > 1 or listed[0].child_by_field_name("declarator") is not None:
        return None
    return listed[0].child_by_field_name("type")


def combined(body: Body, type_node: Node, shape: Node) -> None:
    """`archive & field;` reads like a reference that refers to nothing."""
    inner = within(shape)
    if inner is None:
        body.unknown(shape, "syntax")
        return
    left, right, dst = body.slot(type_node), body.slot(inner), body.register()
    body.emit(Binary(*body.place(shape), dst, "&", left, right))


def arguments_in(declarator: Node) -> list[Node] | None:
    """The arguments in `Guard guard(mutex);`, which reads like the declaration of a function; None where it is one."""
    listed = declarator.child_by_field_name("parameters")
    found = listed.named_children if listed is not None else []
    for each in found:
        if each.type != "parameter_declaration" or any(child.type == "type_qualifier" for child in each.children):
            return None
        type_node, inner = each.child_by_field_name("type"), each.child_by_field_name("declarator")
        named = type_node is not None and type_node.type in ("type_identifier", "qualified_identifier", "template_type")
        if not named or (inner is not None and inner.type not in _MEANT):
            return None
    return found or None


_MEANT: Final = frozenset({"abstract_function_declarator", "abstract_array_declarator"})


def meant(body: Body, node: Node) -> Argued:
    """What such a parameter is as an argument: `a`, `a::b`, `A()`, `std::move(a)`, `static_cast<A &>(a)`, `a[1]`."""
    type_node, inner = node.child_by_field_name("type"), node.child_by_field_name("declarator")
    if type_node is None:
        return Argued(body.unknown(node, "syntax"))
    if inner is None:
        variable = body.variable(word(type_node))
        if variable is not None and (kind := kind_of_variable(variable)) != "slot":
            return Argued(body.value(type_node), kind)
        return Argued(body.slot(type_node), "slot", alterable=variable is not None and variable.alterable)
    if inner.type == "abstract_array_declarator":
        return Argued(_element(body, body.slot(type_node), inner), "slot")
    listed, given_ = inner.child_by_field_name("parameters"), arguments_in(inner)
    if given_ is None and listed is not None and listed.named_children:
        return Argued(body.unknown(node, "syntax"))
    cast = CASTS.get(word(type_node.child_by_field_name("name"))) if type_node.type == "template_type" else None
    types = type_node.child_by_field_name("arguments")
    if cast is not None and types is not None and len(types.named_children) == 1 and len(given_ or ()) == 1:
        return _converted(body, node, (given_ or [])[0], types.named_children[0], cast)
    function = body.slot(type_node)
    arguments = tuple(meant(body, each) for each in given_ or ())
    dst = body.register()
    body.emit(Invoke(*body.place(node), dst, function, arguments))
    return Argued(dst, kind_of_call(word(type_node)))


def _converted(body: Body, node: Node, value: Node, type_: Node, kind: Cast) -> Argued:
    """`static_cast<Lamp &>(part)`."""
    src, wanted = meant(body, value).register, type_of(body, type_, keep=True)
    dst = body.register()
    body.emit(Convert(*body.place(node), dst, src, wanted, by_value(type_, kind)))
    return Argued(dst, "result")


def _element(body: Body, src: int, node: Node) -> int:
    """The slot of `a[1][2]`, of which the brackets read like those of an array."""
    indices: list[Node] = []
    here: Node | None = node
    while here is not None and here.type == "abstract_array_declarator":
        size = here.child_by_field_name("size")
        if size is None:
            return body.unknown(node, "syntax")
        indices.append(size)
        here = here.child_by_field_name("declarator")
    for index in reversed(indices):
        dst = body.register()
        body.emit(Item(*body.place(node), dst, src, body.value(index), slot=True))
        src = dst
    return src
