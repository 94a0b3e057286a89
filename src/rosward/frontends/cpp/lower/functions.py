# SPDX-License-Identifier: Apache-2.0
"""How does the body of a function begin, and what `Code` does it end in?

void f(std::string s, const QoS & qos = 10, Args &&... args)
    s: Copy, Convert to std::string       qos: Default 10, Read, Convert to QoS       args: a pack of slots
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final, Literal

from rosward.frontends.cpp.declarators import named
from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import (
    ARRAYS,
    FUNCTIONS,
    POINTERS,
    REFERENCES,
    builtin,
    declared_type,
    has,
    is_buffer,
)
from rosward.frontends.cpp.lower.variables import Variable
from rosward.frontends.cpp.patterns import parameter_nodes
from rosward.frontends.cpp.written import DefaultArgument
from rosward.ir.core import NO_REGISTER, Move, StoreCell
from rosward.ir.cpp import Convert, Copy, Default, Placed, Read
from rosward.ir.program import CPP, Code, CodeKind, Parameters
from rosward.ir.symbols import ParameterSymbol, Signature, TemplateParameter
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

_AROUND: Final = 50
_KEYS: Final = 16
"""How many bodies may stand at one place: the function, thunks of the same declaration."""


class Function(NamedTuple):
    """What has a body: `declarator` is the `function_declarator`; `which` tells the bodies at one place apart."""

    node: Node
    declarator: Node | None
    signature: Signature
    which: int = 0
    defaults: tuple[DefaultArgument | None, ...] = ()


def template_of(node: Node | None) -> tuple[TemplateParameter, ...]:
    """The parameters of the template that a lambda is."""
    found: list[TemplateParameter] = []
    for child in node.named_children if node is not None else ():
        declarator = child.child_by_field_name("declarator") or child.child_by_field_name("name")
        name = None if declarator is None else named(declarator)[0]
        if name is None:
            name = next((inner for inner in child.named_children if inner.type == "type_identifier"), None)
        found.append(TemplateParameter(word(name), child.type.startswith("variadic")))
    return tuple(found)


def packs_around(node: Node) -> frozenset[str]:
    """The packs among the parameters of the templates around a declaration."""
    found: set[str] = set()
    here = node.parent
    for _ in range(_AROUND):
        if here is None:
            break
        if here.type == "template_declaration":
            listed = template_of(here.child_by_field_name("parameters"))
            found.update(parameter.name for parameter in listed if parameter.pack)
        here = here.parent
    return frozenset(found)


def prologue(body: Body, function: Function, captured: Callable[[], None] | None = None) -> None:
    """Give the parameters their registers, behind the leading ones, then emit what becomes of the arguments."""
    signature = function.signature
    scope = body.scopes[-1]
    for number, parameter in enumerate(signature.template):
        register = body.register()
        body.variables.append(parameter.name or f"<{number}>")
        if parameter.name:
            scope.names[parameter.name] = Variable(
                parameter.name, register, NO_REGISTER, pack=parameter.pack, type_=True
            )
    first = body.registers
    for number, symbol in enumerate(signature.parameters):
        body.register()
        body.variables.append(symbol.name or f"<{len(signature.template) + number}>")
    body.floor = body.free_register
    if captured is not None:
        captured()
    types = frozenset(parameter.name for parameter in signature.template)
    nodes = parameter_nodes(function.declarator)
    defaults = function.defaults or (None,) * len(nodes)
    for number, (symbol, node, default) in enumerate(zip(signature.parameters, nodes, defaults, strict=False)):
        if node is not None:
            _parameter(body, node, symbol, first + number, types, default)
        elif symbol.pack:
            body.c_pack = first + number


def _parameter(
    body: Body,
    node: Node,
    symbol: ParameterSymbol,
    register: int,
    types: frozenset[str],
    default: DefaultArgument | None,
) -> None:
    """A parameter: its default, its conversion, its variable."""
    place = body.place(node)
    declarator = node.child_by_field_name("declarator")
    type_node = node.child_by_field_name("type")
    if default is not None:
        body.emit(Default(*place, register, body.block(lambda: _default(body, default, node, register))))
    reference = has(declarator, REFERENCES)
    converts = not symbol.pack and not _free(symbol, types)
    survey = body.shared.survey
    is_changed = survey.changes(symbol.name)
    if symbol.pack and not reference:
        body.emit(Placed(*place, register, register, "copied" if is_changed else "taken", pack=True))
    elif is_changed and symbol.type.reference == "&&" and not converts:
        body.emit(Placed(*place, register, register, "found", pack=symbol.pack))
    if symbol.pack:
        pass
    elif reference:
        if converts and ((symbol.type.const and not symbol.type.pointers) or symbol.type.reference == "&&"):
            body.emit(Read(*place, register, register))
            _convert(body, node, type_node, declarator, register)
            reference = False
    elif is_buffer(type_node, declarator, const=symbol.type.const, array=True):
        _convert(body, node, type_node, declarator, register, "buffer")
    else:
        points = has(declarator, POINTERS | ARRAYS | FUNCTIONS)
        kind = declared_type(body, type_node, declarator) if converts else NO_REGISTER
        body.emit(Read(*place, register, register) if points else Copy(*place, register, register, kind))
        if converts:
            body.emit(Convert(*place, register, register, kind, "init"))
    body.free_register = body.floor
    if not symbol.name:
        return
    variable = Variable(symbol.name, register, NO_REGISTER, reference=reference, pack=symbol.pack)
    variable.builtin = "" if has(declarator, POINTERS | ARRAYS) else builtin(type_node)
    variable.constant = symbol.type.const and not symbol.type.pointers
    variable.alterable = not (variable.constant or symbol.pack or (reference and _free(symbol, types)))
    variable.written = None if type_node is None or not symbol.type.names else (type_node, declarator)
    variable.leads_to_constant = symbol.type.const and bool(symbol.type.pointers)
    changes = (
        symbol.name in survey.assigned and not reference and not variable.builtin and not has(declarator, POINTERS)
    )
    placed = survey.addressed if variable.constant else survey.placed
    if not symbol.pack and (symbol.name in placed or (changes and not variable.constant)):
        variable.register = NO_REGISTER
        variable.cell = body.new_cell(symbol.name)
        body.emit(StoreCell(*place, variable.cell, register))
    body.scopes[-1].names[symbol.name] = variable
    if not has(declarator, REFERENCES) and symbol.type.names[-1:] == ("unique_ptr",):
        body.scopes[-1].objects.append(variable)  # what it has not given away ends with it


def _default(body: Body, default: DefaultArgument, node: Node, register: int) -> None:
    """It may stand in another file: it is said to stand where the parameter does."""
    value = default.node
    if default.parsed is not body.shared.parsed:
        body.pinned = body.place(node)
    if value.type == "compound_literal_expression":  # `= {}`, as the parser has it
        kind, listed = value.child_by_field_name("type"), value.child_by_field_name("value")
        if kind is not None and kind.is_missing and listed is not None:
            value = listed
    src = body.value(value)
    body.emit(Move(*body.place(value), register, src))
    body.pinned = None
    body.free_register = body.floor


def _free(symbol: ParameterSymbol, types: frozenset[str]) -> bool:
    """Whether it takes whatever is given: `auto`, or a template parameter alone."""
    type_ = symbol.type
    if type_.pointers:
        return False
    return type_.builtin in ("auto", "decltype(auto)") or (len(type_.names) == 1 and type_.names[0] in types)


def _convert(
    body: Body,
    node: Node,
    type_node: Node | None,
    declarator: Node | None,
    register: int,
    how: Literal["init", "buffer"] = "init",
) -> None:
    kind = declared_type(body, type_node, declarator)
    body.emit(Convert(*body.place(node), register, register, kind, how))


def finish(body: Body, function: Function, name: str) -> Code:
    """The `Code` of a body that has been lowered."""
    if not body.ends():
        body.end_objects(function.node, body.scopes[:1])
    body.settle_cells()
    line = function.node.start_point[0] + 1
    return Code(
        CodeKind.FUNCTION,
        name,
        body.qualname,
        body.shared.parsed.prepared.file,
        line,
        Parameters(tuple(body.variables), 0, None, (), None),
        body.ops,
        body.registers,
        tuple(body.variables),
        tuple(body.cells),
        tuple(body.free),
        index=function.node.start_byte * _KEYS + function.which,
        language=CPP,
        unit=body.shared.unit,
        signature=function.signature._replace(using=tuple(body.shared.using), called=body.shared.called),
    )
