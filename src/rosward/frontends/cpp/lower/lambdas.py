# SPDX-License-Identifier: Apache-2.0
"""What does a lambda capture, and what is its body?

    [this, n, &m](int x) { … }     MakeLambda with copies (this, a copy of n) and the cell of m

Registers of its code: `this`, what it captures by copy, its template parameters, its parameters. What is a type, a constant of a template or a
pack around it comes along by copy without being written. What a `mutable` lambda has by copy is in cells of its own.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower import coroutines
from rosward.frontends.cpp.lower.body import Body, Want, free_cell
from rosward.frontends.cpp.lower.functions import Function, finish, prologue, template_of
from rosward.frontends.cpp.lower.seen import own
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import REFERENCES, declared_type, has, within
from rosward.frontends.cpp.lower.variables import Returns, Variable
from rosward.frontends.cpp.patterns import parameter_nodes, parameters
from rosward.frontends.cpp.written import DefaultArgument
from rosward.ir.core import NO_REGISTER, StoreCell
from rosward.ir.cpp import Copy, MakeLambda, Placed
from rosward.ir.python import NewCell
from rosward.ir.symbols import Signature
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

_INDEX: Final = 1


class _Copied(NamedTuple):
    """What a lambda has by copy: its variable inside is like `variable`, its value is in a register outside."""

    name: str
    register: int
    reference: bool = False
    builtin: str = ""
    constant: bool = False
    raw: bool = False
    pack: bool = False
    type: bool = False
    written: tuple[Node, Node | None] | None = None


class _Captures(NamedTuple):
    this: int
    copied: list[_Copied]
    cells: list[tuple[str, int, Variable | None]]
    named: list[Variable]


def _lambda(body: Body, node: Node, _want: Want) -> int:
    shared = body.shared
    declarator = node.child_by_field_name("declarator")
    inner = Body(shared, f"{body.qualname}.<lambda>", body.depth)
    inner.function = "operator()"
    mutable = declarator is not None and any(
        child.type == "type_qualifier" and child.text == b"mutable" for child in declarator.children
    )
    captures = _captures(body, node, mutable)
    names: list[str] = []
    if captures.this != NO_REGISTER:
        inner.has_this = True
        inner.constant_this = body.constant_this
        names.append("this")
    names += [copied.name for copied in captures.copied]
    leading = len(names)
    returns = _returns(declarator)
    template = template_of(node.child_by_field_name("template_parameters"))
    owned = tuple(number for number, (_, _, like) in enumerate(captures.cells) if like is None)
    signature = Signature(parameters(declarator), leading, template, returns.reference, owned=owned)
    function = Function(node, declarator, signature, _INDEX, _defaults(body, declarator))
    inner.returns = returns
    inner.variables = list(names)
    for _ in range(leading):
        inner.register()
    inner.floor = leading
    for name, _cell, like in captures.cells:
        number = len(inner.free)
        inner.free.append(name)
        variable = Variable(name, NO_REGISTER, free_cell(number))
        if like is not None:
            variable.reference, variable.builtin = like.reference, like.builtin
            variable.constant, variable.leads_to_constant = like.constant, like.leads_to_constant
            variable.written = like.written
            if like.counts:
                variable.over, variable.counts = like.over, True
        inner.scopes[-1].names[name] = variable
    for each in captures.named:
        inner.scopes[-1].names[each.name] = each

    first = leading - len(captures.copied)
    prologue(inner, function, lambda: _take(inner, node, captures.copied, first))
    code_body = node.child_by_field_name("body")
    if code_body is not None:
        coroutines.content(inner, code_body)
    code = finish(inner, function, "<lambda>")
    dst = body.register()
    copies = tuple(copied.register for copied in captures.copied)
    this = () if captures.this == NO_REGISTER else (captures.this,)
    op = MakeLambda(*body.place(node), dst, code, this + copies, tuple(cell for _, cell, _ in captures.cells))
    if any(cell < 0 for cell in op.captures):
        body.late.append(op)
    body.emit(op)
    return dst


def _take(inner: Body, node: Node, copied: list[_Copied], first: int) -> None:
    """What came by copy are variables of the lambda."""
    for number, each in enumerate(copied):
        register = first + number
        survey = inner.shared.survey
        placed = each.name in (survey.addressed if each.constant else survey.placed) and not each.raw
        if not placed:
            variable = Variable(
                each.name,
                register,
                NO_REGISTER,
                reference=each.reference,
                builtin=each.builtin,
                raw=each.raw,
                pack=each.pack,
                type_=each.type,
            )
            variable.constant, variable.written = each.constant, each.written
            inner.scopes[-1].names[each.name] = variable
        else:
            variable = inner.declare(each.name, reference=each.reference, builtin=each.builtin)
            variable.written = each.written
            inner.write(node, variable, register)


def _defaults(body: Body, declarator: Node | None) -> tuple[DefaultArgument | None, ...]:
    values = [None if n is None else n.child_by_field_name("default_value") for n in parameter_nodes(declarator)]
    return tuple(None if value is None else DefaultArgument(body.shared.parsed, value) for value in values)


def _returns(declarator: Node | None) -> Returns:
    trailing = next(
        (child for child in (declarator.children if declarator is not None else ()) if child.type == "trailing_return_type"),
        None,
    )  # fmt: skip
    return Returns() if trailing is None else Returns.of_descriptor(trailing.named_children[0])


def _captures(body: Body, node: Node, mutable: bool) -> _Captures:
    """What is written in `[…]`, then what the body needs beside."""
    found = _Captures(NO_REGISTER, [], [], [])
    listed = node.child_by_field_name("captures")
    default = ""
    this = NO_REGISTER
    before = ""
    done: set[str] = set()
    for child in listed.children if listed is not None else ():
        kind = child.type
        if kind == "lambda_default_capture":
            default = word(child)
        elif kind == "this":
            this = 0
            if before == "*" and body.has_this:
                this = body.register()
                body.emit(Copy(*body.place(child), this, 0))
        elif kind in ("identifier", "parameter_pack_expansion"):
            name = word(child if kind == "identifier" else child.named_children[0])
            done.add(name)
            variable = body.variable(name)
            leads = variable is None or (variable.reference and not (variable.raw or variable.path or variable.pack))
            if before == "&" and kind == "identifier" and leads:
                found.copied.append(_referring(body, name, child))
            else:
                _capture(body, child, found, name, "&" if before == "&" else "=", mutable)
        elif kind == "lambda_capture_initializer":
            done.add(_initialised(body, child, found, mutable))
        before = kind
    if default and this == NO_REGISTER:
        this = 0
    for name in body.shared.survey.used.get(node.id, ()):
        if name not in done:
            _capture(body, node, found, name, default, mutable)
    return found._replace(this=this if body.has_this else NO_REGISTER)


def _capture(body: Body, node: Node, found: _Captures, name: str, how: str, mutable: bool) -> None:
    """A variable of the body: by reference, by copy, or (not written at all) only what never changes."""
    variable = body.variable(name)
    if variable is None:
        return
    if variable.path:
        found.named.append(variable)
    elif variable.raw or not how or (how == "&" and variable.cell == NO_REGISTER):
        held = body.held(node, variable)
        if how == "=" and variable.pack and not variable.type:
            dst = body.register()
            body.emit(Placed(*body.place(node), dst, held, "kept" if mutable else "taken", pack=True))
            held = dst
        found.copied.append(
            _Copied(
                name,
                held,
                variable.reference,
                variable.builtin,
                variable.constant,
                variable.raw,
                variable.pack,
                variable.type,
                variable.written,
            )
        )
    elif how == "&":
        found.cells.append((name, variable.cell, variable))
    else:
        _copied(body, node, found, name, _own(body, node, variable), variable.builtin, mutable, variable.written)


def _own(body: Body, node: Node, variable: Variable) -> int:
    """A copy of a variable; of a reference, of what it is declared as."""
    if variable.written is None or not has(variable.written[1], REFERENCES):
        return body.of_variable(node, variable, "own")
    dst, kind = body.register(), declared_type(body, *variable.written)
    body.emit(Copy(*body.place(node), dst, body.of_variable(node, variable, "slot"), kind))
    return dst


def _copied(
    body: Body,
    node: Node,
    found: _Captures,
    name: str,
    value: int,
    builtin: str,
    mutable: bool,
    written: tuple[Node, Node | None] | None = None,
) -> None:
    if not mutable:
        found.copied.append(_Copied(name, value, builtin=builtin, written=written))
        return
    cell = body.new_cell(name)
    body.emit(NewCell(*body.place(node), cell))
    body.emit(StoreCell(*body.place(node), cell, value))
    found.cells.append((name, cell, None))


def _initialised(body: Body, node: Node, found: _Captures, mutable: bool) -> str:
    """`x = std::move(y)`, `&x = y`."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    name = word(within(left) if left is not None and left.child_count else left)
    if node.children[0].type == "&":
        found.copied.append(_referring(body, name, right))
    else:
        _copied(body, node, found, name, body.own(right) if right is None else own(body, right), "", mutable)
    return name


def _referring(body: Body, name: str, value: Node | None) -> _Copied:
    """A reference to what stands there: to what a reference refers to, or to a field or global variable (`[&text = text]`, see suited.py)."""
    like = body.variable(word(value)) if value is not None and value.type == "identifier" else None
    slot = body.slot(value)
    if like is None:
        return _Copied(name, slot, reference=True)
    return _Copied(name, slot, reference=True, builtin=like.builtin, constant=like.constant, written=like.written)


EXPRESSIONS: Final = {"lambda_expression": _lambda}
