# SPDX-License-Identifier: Apache-2.0
"""What is known of the object before a dot, as far as that is written: whether it is constant, and the type that it is declared with.

const Table & table;  table.at("x")      the `at` of constant objects
void start(Base & b) { b.name(); }       the `name` of Base, where that is not virtual, whatever `b` is
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.casts import CASTS
from rosward.frontends.cpp.lower.names import Written, of_parts, parts_of
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import POINTERS, REFERENCES, declared_type, has, type_of
from rosward.frontends.cpp.lower.variables import Over, Variable
from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp import Convert, Copy, Declared, TypeOfValue
from rosward.ir.cpp_names import ARROW, CALLED, DOT, LED, NUMBERED, UNDER
from rosward.ir.op import Block

if TYPE_CHECKING:
    from tree_sitter import Node

_DEPTH: Final = 20
_LEADS: Final = POINTERS | REFERENCES
_LEADING: Final = frozenset({"field_expression", "pointer_expression"})
_OF_PAIRS: Final = frozenset({"first", "second"})
_SAME: Final = frozenset({"as_const", "move"})
_PARTS_OF: Final = frozenset({"field_expression", "identifier", "pointer_expression", "subscript_expression"})
_PLACES: Final = frozenset(
    {
        "begin", "cbegin", "rbegin", "crbegin", "end", "cend", "rend", "find", "lower_bound", "upper_bound", "insert", "emplace",
        "erase", "data", "c_str", "str",
    }
)  # fmt: skip
"""Functions that give iterators, pointers and texts."""
_NOTHING: Final[tuple[Block, int]] = [], NO_REGISTER
_PLAIN: Final = re.compile(
    r"(?:const\s+)?std::\w+<\s*(?:const\s+)?(?:std::(?:string|\w+_t)|rclcpp\w*::[\w:]*|bool|char|double|float|int|long)\b[^,]*\Z"
)
"""Containers of which the elements hide nothing."""
_NUMBERS: Final = re.compile(r"(?:const\s+)?std::\w+<\s*(?:const\s+)?u?int\d+_t\b[^,]*\Z")
"""Those of which the elements are numbers that begin again."""
_LIBRARIES: Final = (b"rclcpp::", b"rclcpp_")
"""How types begin in which nothing is hidden."""
_CONTAINERS: Final = (b"std::string", b"std::vector", b"std::map")
"""Those in which only what is referred to hides something: an object of a class that derives from one."""


def declared(body: Body, node: Node | None, place: tuple[int, int]) -> tuple[Block, int]:
    """Operations that give the type with which the object, or the pointer to it, is declared; none where that is not written."""
    plain = _plain(node)
    if plain is None:
        return _NOTHING
    if plain.type == "identifier":
        variable = body.variable(word(plain))
        written = variable.written if variable is not None and variable.over is None else None
        if written is not None and _hides_nothing(*written):
            return _NOTHING
    if plain.type == "field_expression" and word(plain.child_by_field_name("field")) not in _OF_PAIRS:
        around = plain.parent
        leads = around is not None and around.type in _LEADING and word(around.children[1]) != "."
        found = _of_field(body, plain) if leads else _NOTHING
        if found[1] != NO_REGISTER:
            return found
    return _typed(body, node, place)


def _hides_nothing(type_: Node, declarator: Node | None) -> bool:
    return (type_.text or b"").startswith(_LIBRARIES if _leads(declarator) else (*_LIBRARIES, *_CONTAINERS))


def _leads(declarator: Node | None) -> bool:
    """Whether a variable is a pointer or reference: what it leads to may be of a class that derives from what is written."""
    return declarator is not None and declarator.type in _LEADS


def part_counts(node: Node) -> bool:
    """Whether `auto` of an expression may be a short or unsigned number: of a part of something, or what a function returns, which is no iterator."""
    while node.type == "parenthesized_expression" and node.named_children:
        node = node.named_children[0]
    if node.type == "call_expression":
        function = node.child_by_field_name("function")
        if function is None:
            return False
        if function.type == "field_expression":
            return word(function.child_by_field_name("field")) not in _PLACES
        return function.type == "identifier" or not word(function).startswith("std::") or word(function)[5:9] == "get<"
    return node.type in _PARTS_OF


def again(body: Body, node: Node, variable: Variable | None, name: Node | None, slot: int) -> None:
    """What has been written to an `auto` variable begins again where its type ends."""
    if variable is None or not variable.counts or variable.reference or variable.builtin:
        return
    block, kind = declared(body, name, body.place(node))
    if kind != NO_REGISTER:
        body.ops.extend(block)
        body.emit(Convert(*body.place(node), body.register(), slot, kind, "again"))


def _of_own(body: Body, node: Node, place: tuple[int, int]) -> tuple[Block, int]:
    """The type of a field of `this`."""
    if not body.has_this:
        return [], NO_REGISTER
    dst = body.register()
    return [Declared(*place, dst, word(node))], dst


def over(body: Body, node: Node, *which: str) -> Over:
    """What a variable is a part of, to be asked before that variable is declared: `for (auto & v : v)`."""
    first = _first(node)
    return Over(node, which, None if first is None else body.variable(word(first)))


def _first(node: Node) -> Node | None:
    """The name with which an expression begins that `_typed` looks at: `v` of `(*v[0]).x->f()`."""
    here: Node | None = node
    for _ in range(_DEPTH):
        if here is None or here.type == "identifier":
            return here
        if here.type == "parenthesized_expression":
            here = here.named_children[0] if here.named_children else None
        elif here.type == "call_expression":
            function = here.child_by_field_name("function")
            listed = here.child_by_field_name("arguments")
            is_std = function is not None and function.type == "qualified_identifier"
            here = function if not is_std else listed.named_children[0] if listed and listed.named_children else None
        else:
            here = here.child_by_field_name("argument")
    return None


def _typed(
    body: Body, node: Node | None, place: tuple[int, int], depth: int = 0, part_of: Over | None = None
) -> tuple[Block, int]:
    """The type of an expression as it is declared, without doing what it says; none where that is not written.

    `part_of`: the expression stands where a variable was declared, and its first name is what that meant there.
    """
    if node is None or depth > _DEPTH:
        return _NOTHING
    kind = node.type
    if kind == "parenthesized_expression":
        return _typed(body, node.named_children[0] if node.named_children else None, place, depth + 1, part_of)
    if kind == "identifier":
        return _of_variable(body, node, place, depth, part_of)
    if kind == "pointer_expression" and node.children[0].type == "*":
        return _parts(body, _typed(body, node.child_by_field_name("argument"), place, depth + 1, part_of), place, LED)
    if kind == "subscript_expression":
        return _parts(body, _typed(body, node.child_by_field_name("argument"), place, depth + 1, part_of), place, UNDER)
    if kind == "field_expression":
        return _of_member(body, node, place, depth, part_of)
    cast = _cast(node)
    if cast is not None:
        return _lowered(body, lambda: type_of(body, cast))
    function = node.child_by_field_name("function") if kind == "call_expression" else None
    if function is None:
        return _NOTHING
    if function.type == "field_expression":
        return _of_member(body, function, place, depth, part_of, CALLED)
    return _of_call(body, node, function, place, depth, part_of)


def _of_variable(body: Body, node: Node, place: tuple[int, int], depth: int, part_of: Over | None) -> tuple[Block, int]:
    variable = _named(body, node, part_of)
    if variable is None:
        return _of_own(body, node, place)
    if variable.over is not None:
        whole = variable.over
        return _parts(body, _typed(body, whole.node, place, depth + 1, whole), place, *whole.which)
    if variable.written is None or variable.raw:
        return _NOTHING
    text = (variable.written[0].text or b"").decode()
    is_plain = _PLAIN.match(text) or (part_of is None and _NUMBERS.match(text))
    if is_plain and (part_of is not None or not _leads(variable.written[1])):
        return _NOTHING
    return _written(body, variable.written)


def _named(body: Body, node: Node, part_of: Over | None) -> Variable | None:
    return body.variable(word(node)) if part_of is None else part_of.first


def _of_member(
    body: Body, node: Node, place: tuple[int, int], depth: int, part_of: Over | None, called: str = ""
) -> tuple[Block, int]:
    """The type of `o.x` and `p->x`, or of what these return."""
    owner, field = node.child_by_field_name("argument"), node.child_by_field_name("field")
    if owner is None or field is None or field.type != "field_identifier":
        return _NOTHING
    if owner.type == "this":
        if not body.has_this:
            return _NOTHING
        dst = body.register()
        return [Declared(*place, dst, word(field) + called)], dst
    before = DOT if word(node.child_by_field_name("operator")) == "." else ARROW
    return _parts(body, _typed(body, owner, place, depth + 1, part_of), place, f"{before}{word(field)}{called}")


def _of_call(
    body: Body, node: Node, function: Node, place: tuple[int, int], depth: int, part_of: Over | None
) -> tuple[Block, int]:
    """The type of what `f(…)`, `Lamp::f(…)`, `std::get<0>(…)` return."""
    if function.type == "identifier":
        if _named(body, function, part_of) is not None:
            return _NOTHING
        dst = body.register()
        return [Declared(*place, dst, word(function) + CALLED)], dst
    written = parts_of(function) if function.type == "qualified_identifier" else None
    if written is None or len(written.parts) < 2:
        return _NOTHING
    listed = node.child_by_field_name("arguments")
    name, types = written.parts[-1]
    if written.parts[0][0] == "std":
        argument = listed.named_children[0] if listed is not None and len(listed.named_children) == 1 else None
        number = word(types).strip("<> ") if types is not None else ""
        if name not in _SAME and (name != "get" or not number.isdigit()):
            return _NOTHING
        whole = _typed(body, argument, place, depth + 1, part_of)
        return whole if name in _SAME else _parts(body, whole, place, f"{NUMBERED}{number}")
    if types is not None or written.base is not None:
        return _NOTHING
    return _parts(body, _around(body, function, written), place, f"{DOT}{name}{CALLED}")


def _parts(body: Body, whole: tuple[Block, int], place: tuple[int, int], *which: str) -> tuple[Block, int]:
    """The type of a part of what has a type."""
    block, register = whole
    for each in which if register != NO_REGISTER else ():
        dst = body.register()
        block = [*block, TypeOfValue(*place, dst, register, each)]
        register = dst
    return block, register


def _around(body: Body, node: Node, written: Written) -> tuple[Block, int]:
    """The class or namespace that is written in front of a name."""
    return _lowered(body, lambda: of_parts(body, node, written._replace(parts=written.parts[:-1]), "value"))


def _lowered(body: Body, lower: Callable[[], int]) -> tuple[Block, int]:
    """The operations that are emitted, and where their result stands."""
    found = NO_REGISTER

    def inner() -> None:
        nonlocal found
        found = lower()

    return body.block(inner), found


def _written(body: Body, written: tuple[Node, Node | None]) -> tuple[Block, int]:
    return _lowered(body, lambda: declared_type(body, *written))


def _plain(node: Node | None) -> Node | None:
    """Without brackets, and `*` before a pointer."""
    while node is not None and node.type == "parenthesized_expression" and node.named_children:
        node = node.named_children[0]
    if node is not None and node.type == "pointer_expression" and node.children[0].type == "*":
        node = node.child_by_field_name("argument")
    return node


def _cast(node: Node | None) -> Node | None:
    """The type of `static_cast<T>(x)`, `(T)x`."""
    if node is not None and node.type == "cast_expression":
        return node.child_by_field_name("type")
    function = node.child_by_field_name("function") if node is not None and node.type == "call_expression" else None
    if (
        function is None
        or function.type != "template_function"
        or word(function.child_by_field_name("name")) not in CASTS
    ):
        return None
    types = function.child_by_field_name("arguments")
    return types.named_children[0] if types is not None and len(types.named_children) == 1 else None


def written_cast(node: Node) -> tuple[Node, Node | None] | None:
    """The type that a cast writes, and what its declarator adds: for `auto & part = static_cast<Part &>(lamp);`."""
    found = _cast(_plain(node)) if node.type != "pointer_expression" else None
    type_ = found.child_by_field_name("type") if found is not None else None
    return None if found is None or type_ is None else (type_, found.child_by_field_name("declarator"))


def seen_scope(body: Body, field: Node, node: Node | None, written: Written | None) -> tuple[Block, int]:
    """The same for a field: `o.Base::x` says it, a cast, a reference or pointer to a class of the program."""
    if written is not None and len(written.parts) > 1:
        return _around(body, field, written)
    plain = _plain(node)
    is_name = plain is not None and plain.type == "identifier"
    variable = body.variable(word(plain)) if is_name else None
    if _cast(plain) is not None or (is_name and variable is None):
        return declared(body, node, body.place(field))
    if variable is None or variable.written is None or variable.raw:
        return [], NO_REGISTER
    type_node, shape = variable.written
    leads = has(shape, REFERENCES | POINTERS) and type_node.type == "type_identifier"
    return _written(body, variable.written) if leads else ([], NO_REGISTER)


def led_to(body: Body, node: Node | None) -> tuple[Block, int]:
    """The same for what is assigned to: `r = b`, `*p = b`, `o.x = b`."""
    plain = _plain(node)
    if plain is not None and plain.type == "field_expression":
        return _of_field(body, plain)
    if plain is None or node is None or plain.type != "identifier":
        return [], NO_REGISTER
    variable = body.variable(word(plain))
    if variable is not None and (variable.builtin or variable.written is None or variable.raw):
        return [], NO_REGISTER
    return declared(body, node, body.place(plain))


def _of_field(body: Body, node: Node) -> tuple[Block, int]:
    """The type of `this->x`, and of `o.x`, where reading `o` does nothing else."""
    owner, field = node.child_by_field_name("argument"), node.child_by_field_name("field")
    if owner is None or field is None or field.type != "field_identifier" or not _is_plain(owner):
        return [], NO_REGISTER
    dst, place = body.register(), body.place(node)
    if owner.type == "this":
        return ([Declared(*place, dst, word(field))], dst) if body.has_this else ([], NO_REGISTER)

    def lower() -> None:
        body.emit(Declared(*place, dst, word(field), body.slot(owner)))

    return body.block(lower), dst


def _is_plain(node: Node) -> bool:
    while node.type == "field_expression":
        node = node.child_by_field_name("argument") or node.children[0]
    return node.type in ("identifier", "this")


def is_constant(body: Body, node: Node | None, *, through: bool = False) -> bool:
    """Whether an expression stands for something constant; `through`: what it points to."""
    here = node
    for _ in range(_DEPTH):
        if here is None:
            return False
        kind = here.type
        if kind == "identifier":
            variable = body.variable(word(here))
            if variable is None:  # a field
                return body.constant_this and not through
            return variable.leads_to_constant if through else variable.constant
        if kind == "this":
            return body.constant_this and through
        if kind == "parenthesized_expression":
            here = here.named_children[0] if here.named_children else None
        elif kind == "pointer_expression" and here.children[0].type == "*":
            here, through = here.child_by_field_name("argument"), True
        elif kind == "field_expression" and not through:
            through = word(here.child_by_field_name("operator")) == "->"
            here = here.child_by_field_name("argument")
        elif kind == "subscript_expression" and not through:
            here = here.child_by_field_name("argument")
        elif kind == "call_expression" and word(here.child_by_field_name("function")) == "std::move" and not through:
            listed = here.child_by_field_name("arguments")
            here = listed.named_children[0] if listed is not None and listed.named_children else None
        else:
            return kind == "call_expression" and word(here.child_by_field_name("function")) == "std::as_const"
    return False


def own(body: Body, value: Node) -> int:
    """A value for a variable of its own; of a reference, or what a pointer leads to, as one of the type that this is declared with."""
    if value.type == "pointer_expression" and value.children[0].type == "*":
        block, static = declared(body, value, body.place(value))
        if static != NO_REGISTER:
            src = body.slot(value)
            body.ops.extend(block)
            dst = body.register()
            body.emit(Copy(*body.place(value), dst, src, static))
            return dst
    variable = body.variable(word(value)) if value.type == "identifier" else None
    if variable is None or variable.written is None or not has(variable.written[1], REFERENCES):
        return body.own(value)
    dst = body.register()
    kind = declared_type(body, *variable.written)
    body.emit(Copy(*body.place(value), dst, body.slot(value), kind))
    return dst
