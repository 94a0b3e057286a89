# SPDX-License-Identifier: Apache-2.0
"""What does a name stand for: a local variable, or something that is looked up when it runs?

x           a register or cell, else Name 'x'
a::b<c>::d  Name with three parts
T::value    Name 'value' with the type in the register of T as base
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import type_of
from rosward.frontends.cpp.lower.variables import Variable
from rosward.frontends.cpp.suited import OPERATOR, operator_meant
from rosward.ir.core import NO_REGISTER, CharText
from rosward.ir.cpp import Convert, Name, Part
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

_TEMPLATES: Final = frozenset({"template_type", "template_function", "template_method"})
_PARTS: Final = 50


class Written(NamedTuple):
    """A name as it is written: its parts with the arguments of templates; `base` is a `decltype` in front."""

    parts: tuple[tuple[str, Node | None], ...]
    absolute: bool = False
    base: Node | None = None


def name(body: Body, node: Node, want: Want) -> int:
    """An identifier, a qualified name or a template with its arguments."""
    if node.type in {"identifier", "type_identifier", "namespace_identifier", "field_identifier"}:
        text = word(node)
        variable = body.variable(text)
        if variable is None and text == "__func__" and body.function:
            return body.constant(node, CharText(body.function))
        if variable is None:
            text = operator_meant(text) if text.startswith(OPERATOR) else text
            return _looked_up(body, node, (Part(text),), NO_REGISTER, False, want)
        if not variable.path:
            return _held(body, node, variable, want)
    written = parts_of(node)
    return body.unknown(node, "syntax") if written is None else of_parts(body, node, written, want)


def _held(body: Body, node: Node, variable: Variable, want: Want) -> int:
    """What is wanted of a variable; an array of characters is as a value a pointer to the first."""
    if not variable.buffer or want in ("slot", "effect"):
        return body.of_variable(node, variable, want)
    slot, dst = body.of_variable(node, variable, "slot"), body.register()
    body.emit(Convert(*body.place(node), dst, slot, body.nothing(), "buffer"))
    return dst


def of_parts(
    body: Body, node: Node, written: Written, want: Want, *, designator: bool = False, chosen: Node | None = None
) -> int:
    """What a name of several parts stands for; `designator`: of a field of a class, the field of any object; `chosen`: the argument of
    the template that it names, where that is not among the parts."""
    base = NO_REGISTER
    rest = written.parts
    absolute = written.absolute
    variable = None if absolute or written.base is not None else body.variable(rest[0][0])
    if written.base is not None:
        base = type_of(body, written.base)
    elif variable is not None and variable.path:
        *before, last = variable.path
        rest = (*((text, None) for text in before), (last, rest[0][1]), *rest[1:])
        if not rest[0][0]:
            rest, absolute = rest[1:], True
    elif variable is not None and rest[0][1] is None:
        member = variable.members.get(rest[1][0]) if len(rest) == 2 else None
        if len(rest) == 1 or member is not None:
            return body.of_variable(node, variable if member is None else member, want)
        if variable.type:  # before `::` a variable that is no type does not count
            base = body.of_variable(node, variable, "value")
            rest = rest[1:]
    parts = tuple(
        Part(text, None if arguments is None else template_arguments(body, arguments)) for text, arguments in rest
    )
    if chosen is not None:
        parts = (*parts[:-1], Part(parts[-1].name, (body.value(chosen),)))
    return _looked_up(body, node, parts, base, absolute, want, designator=designator)


def _looked_up(
    body: Body, node: Node, parts: tuple[Part, ...], base: int, absolute: bool, want: Want, *, designator: bool = False
) -> int:
    dst = body.register()
    slot = want in ("slot", "own")
    place = body.place(node)
    body.emit(Name(*place, dst, parts, base=base, absolute=absolute, slot=slot, designator=designator))
    return body.given(node, dst, "own") if want == "own" else dst


def parts_of(node: Node) -> Written | None:
    """The parts of a name."""
    found: list[tuple[str, Node | None]] = []
    absolute = False
    base: Node | None = None
    here = node
    for number in range(_PARTS):
        if here.type in {"dependent_name", "dependent_type"}:  # `template f<T>`, `typename T::X`
            here = here.named_children[-1] if here.named_children else here
        if here.type != "qualified_identifier":
            found.append(last_part(here))
            return Written(tuple(found), absolute, base) if found[-1][0] else None
        scope = here.child_by_field_name("scope")
        if scope is None:
            absolute = absolute or number == 0
        elif scope.type == "decltype":
            base = scope
        else:
            found.append(last_part(scope.named_children[-1] if scope.type == "dependent_name" else scope))
        after = here.child_by_field_name("name")
        if after is None:
            return None
        here = after
    return None


def last_part(node: Node) -> tuple[str, Node | None]:
    """A part of a name and the arguments of its template. An operator is `operator==`, a conversion `operator bool`."""
    if node.type in _TEMPLATES:
        inner = node.child_by_field_name("name")
        return ("" if inner is None else last_part(inner)[0]), node.child_by_field_name("arguments")
    if node.type in {"operator_name", "destructor_name"}:
        words = word(node).split()
        return (" ".join(words) if words[0] == "operator" and words[-1].isalpha() else "".join(words)), None
    text = word(node)
    return (operator_meant(text) if text.startswith(OPERATOR) else text), None


def template_arguments(body: Body, node: Node) -> tuple[int, ...]:
    """The registers of the arguments of a template: types, constants, packs."""
    return tuple(body.value(child) for child in node.named_children if child.type != "comment")
