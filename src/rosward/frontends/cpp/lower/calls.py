# SPDX-License-Identifier: Apache-2.0
"""Calls: `f(a)`, `o.f(a)`, `p->f<T>(a)`, `T(a)`, and the casts that look like one.

p->create<T>("x", n)       Name p; Deref; Name T; InvokeMember 'create' <T> ("x", slot of n)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.arithmetic import type_written
from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.casts import CASTS, Cast, by_value
from rosward.frontends.cpp.lower.compared import compared
from rosward.frontends.cpp.lower.initialisers import arguments, construct, given
from rosward.frontends.cpp.lower.names import Written, last_part, name, of_parts, parts_of, template_arguments
from rosward.frontends.cpp.lower.operators import binary, choose, target
from rosward.frontends.cpp.lower.seen import declared, is_constant
from rosward.frontends.cpp.lower.survey import through_member, through_number, word
from rosward.frontends.cpp.lower.through import through_pointer
from rosward.frontends.cpp.lower.types import TYPES, type_of
from rosward.frontends.cpp.macros import EITHER
from rosward.frontends.cpp.suited import TYPE, type_meant
from rosward.ir.arithmetic import same_type
from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp import Argued, Assign, Convert, Invoke, InvokeMember, MakeType, Read, TypeOfValue
from rosward.ir.op import Block

if TYPE_CHECKING:
    from tree_sitter import Node


def _call(body: Body, node: Node, want: Want) -> int:
    function, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
    if function is None:
        return body.unknown(node, "syntax")
    inner = _bare(function)
    pair = through_member(inner)
    if pair is not None:
        return body.given(node, through_pointer(body, node, pair, arguments(body, listed)), want)
    if inner.type == "field_expression" and not _broken(inner):
        return _method(body, node, inner, listed, want)
    if function.type in TYPES:
        return construct(body, node, type_of(body, function), given(body, listed))
    special = _SPECIAL.get(word(function)) if function.type == "identifier" else None
    if special is not None:
        return special(body, node, listed, want)
    if function.type == "template_function":
        cast = CASTS.get(word(function.child_by_field_name("name")))
        if cast is not None:
            return _cast(body, node, function, listed, cast)
        comparison = compared(body, node, function, listed)
        if comparison is not None:
            return comparison
    if function.type in ("identifier", "qualified_identifier", "template_function"):
        own = last_part(function)[0] if body.has_this and function.type == "identifier" else ""
        if own == "operator=" or own in _ASSIGNING:
            return _assigned_by_name(body, node, 0, NO_REGISTER, own[len("operator") :], listed, want)
        written = parts_of(function) if body.has_this and function.type == "qualified_identifier" else None
        if written is not None and written.parts[-1][0] == "operator=":  # `Base::operator=(o)`
            return _assigned_by_name(body, node, 0, _scope(body, function, written), "=", listed, want)
        func = name(body, function, "value")
    else:
        func = body.value(function)
    return _invoke(body, node, func, arguments(body, listed), want)


def _invoke(body: Body, node: Node, func: int, those: tuple[Argued, ...], want: Want) -> int:
    place = body.place(node)
    return _result(body, node, lambda dst, copied: body.emit(Invoke(*place, dst, func, those, copied=copied)), want)


def _result(body: Body, node: Node, emit: Callable[[int, bool], None], want: Want) -> int:
    """What is wanted of what a call gives, which may be a slot."""
    dst = body.register()
    emit(dst, want == "own")
    if want != "value":
        return dst
    read = body.register()
    body.emit(Read(*body.place(node), read, dst))
    return read


def _bare(node: Node) -> Node:
    """`(o.*m)(a)`: what is in the parentheses, where that is a member."""
    inner = node.named_children[0] if node.type == "parenthesized_expression" and node.named_children else node
    return inner if inner.type in ("field_expression", "binary_expression") else node


def _broken(node: Node) -> bool:
    return node.has_error and any(child.is_error for child in node.children)


def _binary(body: Body, node: Node, want: Want) -> int:
    """`o.f<1>(a)` and `f<A<B>>(a)` may read like comparisons."""
    found = through_number(node)
    if found is None:
        return binary(body, node, want)
    function, argument, listed = found
    if function.type == "field_expression":
        return _method(body, node, function, listed, want, argument)
    written = parts_of(function)
    func = NO_REGISTER if written is None else of_parts(body, function, written, "value", chosen=argument)
    return binary(body, node, want) if written is None else _invoke(body, node, func, arguments(body, listed), want)


def _method(body: Body, node: Node, function: Node, listed: Node | None, want: Want, number: Node | None = None) -> int:
    field = function.child_by_field_name("field")
    if field is None:
        return body.unknown(node, "syntax")
    obj = target(body, function)
    written = parts_of(field)
    text, types = written.parts[-1] if written is not None else last_part(field)
    scope = NO_REGISTER
    if written is not None and len(written.parts) > 1:  # `o.Base::f()`
        scope = _scope(body, field, written)
    if text == "operator=" or (text in _ASSIGNING and scope == NO_REGISTER):
        return _assigned_by_name(body, node, obj, scope, text[len("operator") :], listed, want, function)
    chosen = None if types is None else template_arguments(body, types)
    if number is not None:
        chosen = (body.value(number),)
    those = arguments(body, listed)
    place = body.place(field)
    through = word(function.child_by_field_name("operator")) == "->"
    argument = function.child_by_field_name("argument")
    constant = is_constant(body, argument, through=through)
    seen, static = declared(body, argument, place)
    return _result(
        body,
        node,
        lambda dst, copied: body.emit(
            InvokeMember(
                *place,
                dst,
                obj,
                text,
                those,
                types=chosen,
                scope=scope,
                copied=copied,
                constant=constant,
                seen=seen,
                static=static,
                given="slot" if through else _given(argument),
            )
        ),
        want,
    )


def _given(argument: Node | None) -> str:
    """As what an object is given to a function of it: a place, what a call gives, or what is new or moved."""
    while argument is not None and argument.type == "parenthesized_expression" and argument.named_children:
        argument = argument.named_children[0]
    if argument is None or argument.type not in ("call_expression", "compound_literal_expression", "cast_expression"):
        return "slot"
    function = argument.child_by_field_name("function")
    moved = function is None or word(function) == "std::move" or "&&" in word(function)
    return "value" if moved else "result"


_ASSIGNING: Final = frozenset(f"operator{sign}=" for sign in ("+", "-", "*", "/", "%", "&", "|", "^", "<<", ">>"))


def _scope(body: Body, node: Node, written: Written) -> int:
    """The class before the last name of several."""
    return of_parts(body, node, written._replace(parts=written.parts[:-1]), "value")


def _assigned_by_name(
    body: Body,
    node: Node,
    obj: int,
    scope: int,
    operator: str,
    listed: Node | None,
    want: Want,
    member: Node | None = None,
) -> int:
    """`o.operator=(a)` is `o = a`, and `Base::operator=(a)` is that of the part which is of the base."""
    given_ = [child for child in listed.named_children if child.type != "comment"] if listed is not None else []
    if len(given_) != 1:
        return body.unknown(node, "syntax")
    place, slot = body.place(node), obj
    seen: Block = []
    static = NO_REGISTER
    if scope != NO_REGISTER:
        slot = body.register()
        body.emit(Convert(*place, slot, obj, scope, "static"))
    elif member is not None and operator == "=":
        seen, static = declared(body, member.child_by_field_name("argument"), place)
    body.assignments += 1
    src = body.value(given_[0])
    dst = NO_REGISTER if want == "effect" else body.register()
    body.emit(Assign(*place, dst, operator, slot, src, seen=seen, static=static))
    return dst if want == "effect" else body.given(node, dst, want)


def _cast(body: Body, node: Node, function: Node, listed: Node | None, kind: Cast) -> int:
    """`static_cast<T>(x)`."""
    types = function.child_by_field_name("arguments")
    inner = [child for child in (listed.named_children if listed is not None else ()) if child.type != "comment"]
    if types is None or len(types.named_children) != 1 or len(inner) != 1:
        return body.unknown(node, "syntax")
    if types.has_error and inner[0].type == "pointer_expression":
        return body.value(
            inner[0]
        )  # `static_cast<void (C::*)(int)>(&C::f)`, which the grammar lacks: one of the overloads
    return converted(
        body,
        node,
        inner[0],
        type_of(body, types.named_children[0], keep=True),
        by_value(types.named_children[0], kind),
    )


def converted(body: Body, node: Node, src: Node, type_: int, kind: Cast) -> int:
    """What a cast makes of an expression."""
    variable = body.variable(word(src)) if src.type == "identifier" else None
    slot = body.value(src) if variable is not None and variable.buffer else body.slot(src)
    dst = body.register()
    body.emit(Convert(*body.place(node), dst, slot, type_, kind))
    return dst


def _c_cast(body: Body, node: Node, want: Want) -> int:
    """`(T)x`."""
    value, type_ = node.child_by_field_name("value"), node.child_by_field_name("type")
    if value is None or type_ is None:
        return body.unknown(node, "syntax")
    if word(type_) == "void":
        return body.expression(value, "effect")
    kind = by_value(type_, "static")
    if value.type == "assignment_expression":  # `(Base &)*this += x`: what is cast is on its left
        return _assigned(body, node, value, type_, kind)
    found = converted(body, node, value, type_of(body, type_, keep=True), kind)
    return found if kind == "static" and want in ("value", "slot") else body.given(node, found, want)


def _assigned(body: Body, node: Node, assignment: Node, type_: Node, kind: Cast) -> int:
    left, right = assignment.child_by_field_name("left"), assignment.child_by_field_name("right")
    if left is None or right is None:
        return body.unknown(node, "syntax")
    slot = converted(body, node, left, type_of(body, type_, keep=True), kind)
    dst = body.register()
    operator = word(assignment.child_by_field_name("operator"))
    body.emit(Assign(*body.place(node), dst, operator, slot, body.slot(right)))
    return dst


def _typeid(body: Body, node: Node, listed: Node | None, _want: Want) -> int:
    inner = listed.named_children if listed is not None else []
    if len(inner) != 1:
        return body.unknown(node, "syntax")
    name = word(inner[0])
    if type_ := same_type(type_meant(name)) if name.startswith(TYPE) else type_written(body, inner[0]):
        src = body.register()
        body.emit(MakeType(*body.place(node), src, type_))
    else:
        src = body.slot(inner[0])
    dst = body.register()
    body.emit(TypeOfValue(*body.place(node), dst, src))
    return dst


def _either(body: Body, node: Node, listed: Node | None, want: Want) -> int:
    """A macro that has several definitions: its value is one of theirs."""
    inner = listed.named_children if listed is not None else []
    how: Want = "value" if want == "effect" else want
    if not inner:
        return body.unknown(node, "macro", "a macro of which only the build knows the value")

    def of(position: int) -> int:
        if position + 1 == len(inner):
            return body.expression(inner[position], how)
        test = body.unknown(node, "macro", "a macro with several definitions")
        return choose(body, node, test, lambda: body.expression(inner[position], how), lambda: of(position + 1))

    return of(0)


def _va_start(body: Body, node: Node, listed: Node | None, _want: Want) -> int:
    """`va_start(list, last)`: the list is what `...` got."""
    inner = listed.named_children if listed is not None else []
    if not inner or body.c_pack == NO_REGISTER:
        return body.unknown(node, "language", "va_start")
    body.emit(Assign(*body.place(node), NO_REGISTER, "=", body.slot(inner[0]), body.c_pack))
    return body.c_pack


_SPECIAL: Final[dict[str, Callable[[Body, Node, Node | None, Want], int]]] = {
    "typeid": _typeid,
    EITHER: _either,
    "va_start": _va_start,
}


EXPRESSIONS: Final = {
    "binary_expression": _binary,
    "call_expression": _call,
    "cast_expression": _c_cast,
    "identifier": name,
    "qualified_identifier": name,
    "template_function": name,
    "template_type": name,
    "type_identifier": name,
    "namespace_identifier": name,
    "field_identifier": name,
    "dependent_name": name,
}
