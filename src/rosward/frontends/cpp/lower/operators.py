# SPDX-License-Identifier: Apache-2.0
"""Operators: `a + b`, `!a`, `a && b`, `a ? b : c`, `x = a`, `x += a`, `++x`, `*p`, `&x`, `o.x`, `v[i]`, `(a, b)`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.arithmetic import bounded, difference, receiver_of_size, type_written
from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.literals import is_of
from rosward.frontends.cpp.lower.lvalues import is_lvalue, kind_of
from rosward.frontends.cpp.lower.names import last_part, of_parts, parts_of, template_arguments
from rosward.frontends.cpp.lower.narrowing import COMPARE, condition, conjunction, split
from rosward.frontends.cpp.lower.seen import again, is_constant, led_to, seen_scope
from rosward.frontends.cpp.lower.survey import is_apart, is_through, operator_of, word
from rosward.frontends.cpp.lower.through import factors, through, value_through
from rosward.frontends.cpp.lower.variables import Variable
from rosward.frontends.cpp.suited import THROW
from rosward.ir.arithmetic import common
from rosward.ir.control import If, Raise
from rosward.ir.core import NO_REGISTER, Binary, Compare, Move, Unary
from rosward.ir.cpp import (
    AddressOf,
    Argued,
    Assign,
    Convert,
    Deref,
    Invoke,
    Item,
    MakeType,
    Member,
    Name,
    Part,
    Read,
    Step,
)

if TYPE_CHECKING:
    from tree_sitter import Node

_BINARY: Final = frozenset({"+", "-", "*", "/", "%", "<<", ">>", "|", "^", "&"})


_CONVERTED: Final = frozenset(
    {
        *("float", "double", "bool", "unsigned", "unsigned int", "short", "unsigned short"),
        *(
            "char",
            "signed char",
            "unsigned char",
            *(f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32)),
        ),
    }
)
"""Types of variables that what is added to them may leave."""
_FLOATS: Final = frozenset({"float", "double"})
_UNSIGNED: Final = frozenset({"size_t", "uint64_t", "unsigned long", "unsigned long long"})
"""Those that may be left but by what is taken away."""


def binary(body: Body, node: Node, want: Want) -> int:
    """Chains that lean to the left (`a + b + c`) are walked in a loop: generated code has thousands of links."""
    if operator_of(node) in ("&&", "||"):
        return conjunction(body, node, operator_of(node)).register
    if is_through(node):
        return through(body, node, want)
    chain = [node]
    left = node.child_by_field_name("left")
    while left is not None and left.type == "binary_expression" and not left.has_error and not is_apart(left):
        chain.append(left)
        left = left.child_by_field_name("left")
    counted = _counted(chain[-1])
    of = body.variable(word(counted)) if counted is not None and counted.type == "identifier" else None
    if of is not None and of.buffer:  # of characters, each of which has the size 1
        value = body.value(chain.pop().child_by_field_name("left"))
    elif counted is None:
        value = _operand(body, left, operator_of(chain[-1]), "<<", ">>")
    else:
        value = _size(body, chain.pop(), counted)
    type_, sizes = ("", ()) if counted is not None else (type_written(body, left), receiver_of_size(body, left))
    for link, right, pair in factors(chain):
        operator = operator_of(link)
        other = _operand(body, right, operator, ">>") if pair is None else value_through(body, link, pair)
        compares = operator in COMPARE or operator == "<=>"
        if not compares and operator not in _BINARY:
            value = body.unknown(link, "language", operator)
            continue
        dst = body.register()
        kind = Compare if compares else Binary
        if operator == "-":
            type_, sizes = common(type_, type_written(body, right)), sizes or receiver_of_size(body, right)
            body.emit(kind(*body.place(link), dst, operator, value, other))
            value = difference(body, link, type_, dst, sizes)
            continue
        body.emit(kind(*body.place(link), dst, operator, value, other))
        type_, sizes = (common(type_, type_written(body, right)), sizes) if operator in "+*/%" else ("", ())
        value = bounded(body, link, type_, dst) if operator in "+*" else dst
    return value


def _counted(node: Node) -> Node | None:
    """The array of which `sizeof(a) / sizeof(a[0])` counts the elements."""
    sides = [node.child_by_field_name(name) for name in ("left", "right")]
    if operator_of(node) != "/" or not all(side is not None and side.type == "sizeof_expression" for side in sides):
        return None
    whole, part = [_bare(side.child_by_field_name("value")) for side in sides if side is not None]
    if whole is None or part is None or part.type not in ("subscript_expression", "pointer_expression"):
        return None
    of = part.child_by_field_name("argument")
    return whole if of is not None and of.text == whole.text else None


def _bare(node: Node | None) -> Node | None:
    while node is not None and node.type == "parenthesized_expression" and node.named_children:
        node = node.named_children[0]
    return node


def _size(body: Body, node: Node, array: Node) -> int:
    func, dst = body.register(), body.register()
    body.emit(Name(*body.place(node), func, (Part("std"), Part("size"))))
    body.emit(Invoke(*body.place(node), dst, func, (Argued(body.slot(array), "slot"),)))
    return dst


def _operand(body: Body, node: Node | None, operator: str, *changing: str) -> int:
    """`stream >> x` changes both, `stream << x` the stream: those are handed over as places."""
    return body.slot(node) if operator in changing and node is not None and is_lvalue(node) else body.value(node)


def _unary(body: Body, node: Node, _want: Want) -> int:
    thrown = _thrown(node)
    if thrown is not None:
        body.emit(Raise(*body.place(node), body.own(thrown)))
        return body.nothing()
    operator = operator_of(node)
    argument = node.child_by_field_name("argument")
    if operator not in ("!", "-", "+", "~"):
        return body.unknown(node, "syntax")
    src = body.value(argument)
    dst = body.register()
    body.emit(Unary(*body.place(node), dst, "not" if operator == "!" else operator, src))
    return dst


def _thrown(node: Node) -> Node | None:
    """The operand of a `throw` within an expression, which the parser gets as `THROW`."""
    here: Node | None = node
    for _ in THROW:
        if here is None or here.type != "unary_expression" or word(here.child_by_field_name("operator")) != THROW[0]:
            return None
        here = here.child_by_field_name("argument")
    return here


def choose(body: Body, node: Node, test: int, then: Callable[[], int], orelse: Callable[[], int]) -> int:
    """One of two values."""
    dst = body.register()

    def put(lower: Callable[[], int]) -> Callable[[], None]:
        return lambda: body.emit(Move(*body.place(node), dst, lower()))

    body.emit(If(*body.place(node), test, body.block(put(then)), body.block(put(orelse))))
    return dst


def _conditional(body: Body, node: Node, want: Want) -> int:
    found = condition(body, node.child_by_field_name("condition"))
    then, orelse = node.child_by_field_name("consequence"), node.child_by_field_name("alternative")
    how: Want = "value" if want == "effect" else want
    dst = body.register()

    def put(inner: Node | None) -> Callable[[], None]:
        return lambda: body.emit(Move(*body.place(node), dst, body.expression(inner, how)))

    split(body, node, found, put(then), put(orelse))
    return dst


def _comma(body: Body, node: Node, want: Want) -> int:
    """`a = 1, f()`; in `matrix << 1, 2, 3` it is an operator of the matrix, where that is one."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    if left is None or not _may_have_comma(body, left):
        body.expression(left, "effect")
        return body.expression(right, want)
    value = body.value(left)
    while right is not None:
        is_last = right.type != "comma_expression"
        dst, item = body.register(), body.value(right if is_last else right.child_by_field_name("left"))
        body.emit(Binary(*body.place(node), dst, ",", value, item))
        value, right = dst, None if is_last else right.child_by_field_name("right")
    return value


def _may_have_comma(body: Body, left: Node) -> bool:
    """Whether what stands before a comma may be an object that has an operator of that name."""
    if left.type == "identifier":
        variable = body.variable(word(left))
        return variable is not None and not variable.builtin and variable.written is not None
    return left.type == "binary_expression" and operator_of(left) == "<<"


def _parenthesized(body: Body, node: Node, want: Want) -> int:
    inner = [child for child in node.named_children if child.type != "comment"]
    return body.expression(inner[0], want) if len(inner) == 1 else body.unknown(node, "syntax")


def _variable(body: Body, node: Node | None) -> Variable | None:
    return body.variable(word(node)) if node is not None and node.type == "identifier" else None


def _local(body: Body, node: Node | None) -> Variable | None:
    """The variable in a register that an expression names."""
    variable = _variable(body, node)
    if variable is None or variable.reference or variable.raw or variable.register == NO_REGISTER:
        return None
    return variable


def _converted(body: Body, node: Node, variable: Variable | None, value: Node | None, src: int) -> int:
    """A value for a variable of an arithmetic type."""
    if variable is None or not variable.builtin or is_of(variable.builtin, value):
        return src
    kind = body.register()
    body.emit(MakeType(*body.place(node), kind, variable.builtin))
    dst = body.register()
    body.emit(Convert(*body.place(node), dst, src, kind, "init"))
    return dst


def _assignment(body: Body, node: Node, want: Want) -> int:
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = operator_of(node)
    src = written = body.value(right)
    body.assignments += 1
    variable = _local(body, left)
    if variable is not None:
        if operator != "=":
            found = body.register()
            body.emit(Binary(*body.place(node), found, operator[:-1], variable.register, src, inplace=True))
            src = found
        literal = right if operator == "=" or not _leaves(variable, operator) else None
        body.move(node, variable.register, _converted(body, node, variable, literal, src))
        return variable.register
    target = _variable(body, left)
    if target is not None and target.raw:
        target = None
    slot = body.slot(left)
    if (
        target is not None
        and operator != "="
        and target.builtin
        and (_leaves(target, operator) or not is_of(target.builtin, right))
    ):
        before, found = body.register(), body.register()
        body.emit(Read(*body.place(node), before, slot))
        body.emit(Binary(*body.place(node), found, operator[:-1], before, src, inplace=True))
        src, operator = _converted(body, node, target, None, found), "="
    elif operator == "=":
        src = _converted(body, node, target, right, src)
    dst = NO_REGISTER if want == "effect" else body.register()
    seen, static = led_to(body, left) if operator == "=" else ([], NO_REGISTER)
    kind = "value" if right is None or src != written else kind_of(right, _variable(body, right))
    body.emit(Assign(*body.place(node), dst, operator, slot, src, kind=kind, seen=seen, static=static))
    again(body, node, target, left, slot)
    return dst if want == "effect" else body.given(node, dst, want)


def _update(body: Body, node: Node, want: Want) -> int:
    operator = operator_of(node)
    argument = node.child_by_field_name("argument")
    prefix = node.children[0].type in ("++", "--")
    body.assignments += 1
    variable = _local(body, argument)
    if variable is not None:
        before = variable.register
        if not prefix and want != "effect":
            before = body.register()
            body.move(node, before, variable.register)
        one = body.constant(node, 1)
        body.emit(Binary(*body.place(node), variable.register, operator[0], variable.register, one, inplace=True))
        if _leaves(variable, operator):
            body.move(node, variable.register, _converted(body, node, variable, None, variable.register))
        return variable.register if prefix else before
    slot = body.slot(argument)
    target = body.variable(word(argument)) if argument is not None and argument.type == "identifier" else None
    if target is not None and not target.reference and not target.raw and _leaves(target, operator):
        before, found = body.register(), body.register()
        body.emit(Read(*body.place(node), before, slot))
        one = body.constant(node, 1)
        body.emit(Binary(*body.place(node), found, operator[0], before, one, inplace=True))
        src = _converted(body, node, target, None, found)
        body.emit(Assign(*body.place(node), NO_REGISTER, "=", slot, src))
        return body.given(node, slot, want) if prefix and want != "effect" else before
    dst = NO_REGISTER if want == "effect" else body.register()
    body.emit(Step(*body.place(node), dst, operator, slot, prefix=prefix))
    again(body, node, target, argument, slot)
    return body.given(node, dst, want) if prefix and want != "effect" else dst


def _leaves(variable: Variable, operator: str) -> bool:
    """Whether `++`, `-=` and the like may lead out of what the type of a variable holds."""
    if variable.builtin in _FLOATS:
        return len(operator) == 2 and operator[1] == "="
    return variable.builtin in _CONVERTED or (operator[0] == "-" and variable.builtin in _UNSIGNED)


def _pointer(body: Body, node: Node, want: Want) -> int:
    """`*p` and `&x`; `&C::m` is the member itself."""
    argument = node.child_by_field_name("argument")
    if argument is None:
        return body.unknown(node, "syntax")
    dst: int
    if node.children[0].type == "&":
        written = parts_of(argument) if argument.type == "qualified_identifier" else None
        slot = body.slot(argument) if written is None else of_parts(body, argument, written, "slot", designator=True)
        dst = body.register()
        body.emit(AddressOf(*body.place(node), dst, slot))
        return dst
    if argument.type == "this":
        return body.given(node, 0, want) if body.has_this else body.unknown(node, "syntax")
    src = body.value(argument)
    dst = body.register()
    body.emit(Deref(*body.place(node), dst, src, slot=want != "value"))
    return body.given(node, dst, "own") if want == "own" else dst


def target(body: Body, node: Node) -> int:
    """The object of `o.x` and `p->x`, as a slot."""
    argument = node.child_by_field_name("argument")
    arrow = word(node.child_by_field_name("operator")) == "->"
    if arrow and argument is not None and argument.type == "this" and body.has_this:
        return 0
    if not arrow:
        return body.slot(argument)
    src = body.value(argument)
    dst = body.register()
    body.emit(Deref(*body.place(node), dst, src, slot=True))
    return dst


def _field(body: Body, node: Node, want: Want) -> int:
    field = node.child_by_field_name("field")
    if field is None:
        return body.unknown(node, "syntax")
    written = parts_of(field)
    obj = target(body, node)
    text, arguments = written.parts[-1] if written is not None else last_part(field)
    given = None if arguments is None else template_arguments(body, arguments)
    argument = node.child_by_field_name("argument")
    seen, static = seen_scope(body, field, argument, written)
    dst = body.register()
    slot = want in ("slot", "own")
    body.emit(Member(*body.place(field), dst, obj, text, arguments=given, slot=slot, seen=seen, static=static))
    return body.given(node, dst, "own") if want == "own" else dst


def _subscript(body: Body, node: Node, want: Want) -> int:
    argument, indices = node.child_by_field_name("argument"), node.child_by_field_name("indices")
    inner = [child for child in indices.named_children if child.type != "comment"] if indices is not None else []
    if argument is None or len(inner) != 1:
        return body.unknown(node, "syntax")
    obj = body.slot(argument)
    index = body.value(inner[0])
    dst = body.register()
    constant = is_constant(body, argument)
    body.emit(Item(*body.place(node), dst, obj, index, slot=want != "value", constant=constant))
    return body.given(node, dst, "own") if want == "own" else dst


def _this(body: Body, node: Node, _want: Want) -> int:
    if not body.has_this:
        return body.unknown(node, "syntax")
    dst = body.register()
    body.emit(AddressOf(*body.place(node), dst, 0))
    return dst


def _operator_name(body: Body, node: Node, want: Want) -> int:
    dst = body.register()
    body.emit(Name(*body.place(node), dst, (Part(last_part(node)[0]),), slot=want == "slot"))
    return dst


EXPRESSIONS: Final = {
    "unary_expression": _unary,
    "conditional_expression": _conditional,
    "comma_expression": _comma,
    "parenthesized_expression": _parenthesized,
    "assignment_expression": _assignment,
    "update_expression": _update,
    "pointer_expression": _pointer,
    "field_expression": _field,
    "subscript_expression": _subscript,
    "this": _this,
    "operator_name": _operator_name,
}
