# SPDX-License-Identifier: Apache-2.0
"""What is the code of a declaration? The body of a function, or a thunk: a first value, a type, a base, a default.

Each is lowered when somebody asks for it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower import (
    calls,
    coroutines,
    declarations,
    folds,
    initialisers,
    lambdas,
    literals,
    loops,
    operators,
    statements,
    types,
)
from rosward.frontends.cpp.lower.body import Body, Shared, Want
from rosward.frontends.cpp.lower.constructors import initialise
from rosward.frontends.cpp.lower.functions import Function, finish, packs_around, prologue
from rosward.frontends.cpp.lower.names import of_parts, parts_of
from rosward.frontends.cpp.lower.survey import survey
from rosward.frontends.cpp.lower.types import declared_type, type_of
from rosward.frontends.cpp.lower.undecided import Undecided
from rosward.frontends.cpp.lower.variables import Returns
from rosward.frontends.cpp.lower.vexing import arguments_in, meant
from rosward.frontends.cpp.marks import function_of
from rosward.frontends.cpp.written import Written
from rosward.ir.control import Return
from rosward.ir.program import Code
from rosward.ir.symbols import Signature, TemplateParameter

if TYPE_CHECKING:
    from tree_sitter import Node

Template = tuple[TemplateParameter, ...]

EXPRESSIONS: Final[Mapping[str, Callable[[Body, Node, Want], int]]] = {
    **literals.EXPRESSIONS,
    **operators.EXPRESSIONS,
    **calls.EXPRESSIONS,
    **initialisers.EXPRESSIONS,
    **lambdas.EXPRESSIONS,
    **folds.EXPRESSIONS,
    **statements.EXPRESSIONS,
    **coroutines.EXPRESSIONS,
    **types.EXPRESSIONS,
}
STATEMENTS: Final[Mapping[str, Callable[[Body, Node], None]]] = {
    **statements.STATEMENTS,
    **declarations.STATEMENTS,
    **loops.STATEMENTS,
    **coroutines.STATEMENTS,
}

_VALUE, _TYPE, _BASE, _DEFAULT, _TARGET = 2, 3, 4, 5, 6
"""What tells the bodies of one declaration apart: 0 is a function, 1 a lambda."""


def lower_body(written: Written, signature: Signature) -> Code:
    """The body of a function."""
    node = written.declared.node
    body = _body(written, node, signature.leading)
    body.function = written.declared.name
    declarator = function_of(node.child_by_field_name("declarator"))
    function = Function(node, declarator, signature, 0, written.defaults)
    body.returns = _returns(written, declarator)
    body.constant_this = signature.constant
    prologue(body, function)
    _content(body, written, node)
    return finish(body, function, written.declared.name)


def lower_initial(written: Written, template: Template) -> Code | None:
    """The first value of a variable or enumerator."""
    node, whole = written.declared.node, written.declared.whole
    if node.type == "enumerator":
        return _thunk(written, node, _VALUE, template, lambda body: declarations.enumerated(body, node))
    around = node.parent
    if around is not None and around.type == "function_declarator":  # `Key key(ids::NAV);`, which reads like a function
        return _thunk(written, node, _VALUE, template, lambda body: _of_arguments(body, around, whole), written.leading)
    what, shape, equals = _initialiser(node, whole)
    if what is None:
        return None

    def lower(body: Body) -> int:
        if shape is not None and shape.type == "reference_declarator" and what.type != "initializer_list":
            return body.slot(what)
        type_node = whole.child_by_field_name("type")
        return declarations.initial(body, what, type_node, shape, what, equals=equals)

    return _thunk(written, node, _VALUE, template, lower, written.leading)


def _of_arguments(body: Body, declarator: Node, whole: Node) -> int:
    """What a variable begins with of which the arguments read like parameters."""
    listed = arguments_in(declarator) or []
    made = initialisers.Given(tuple(meant(body, each) for each in listed), "paren")
    shape = declarator.child_by_field_name("declarator")
    return declarations.initial(body, whole, whole.child_by_field_name("type"), shape, made, equals=False)


def lower_type(written: Written, template: Template) -> Code | None:
    """The type of a variable, or of what a function returns; None for `auto` and constructors."""
    node, whole = written.declared.node, written.declared.whole
    is_function = node == whole
    shape = whole.child_by_field_name("declarator") if is_function else node
    if shape is not None and shape.type == "init_declarator":
        shape = shape.child_by_field_name("declarator")
    type_node = whole.child_by_field_name("type")
    if is_function:
        returns = _returns(written, function_of(shape))
        type_node, shape = returns.type, returns.declarator
    if type_node is None or type_node.type in ("placeholder_type_specifier", "auto"):
        return None
    return _thunk(
        written, node, _TYPE, template, lambda body: declared_type(body, type_node, shape, result=is_function)
    )


def lower_target(written: Written, template: Template) -> Code:
    """The type that an alias stands for, the class that a `using` in a class names."""
    node, whole = written.declared.node, written.declared.whole

    def lower(body: Body) -> int:
        if whole.type == "alias_declaration":
            return type_of(body, whole.child_by_field_name("type"), keep=True)
        if whole.type == "type_definition":
            return declared_type(body, whole.child_by_field_name("type"), node, keep=True)
        found = parts_of(node)
        if found is None or len(found.parts) < 2:
            return body.unknown(node, "syntax")
        return of_parts(body, node, found._replace(parts=found.parts[:-1]), "value")

    return _thunk(written, node, _TARGET, template, lower)


def lower_base(written: Written, node: Node, template: Template) -> Code:
    """A base of a class."""
    return _thunk(written, node, _BASE, template, lambda body: folds.expanded(body, node))


def lower_default(written: Written, node: Node, before: Template) -> Code:
    """The default of a parameter of a template."""
    return _thunk(written, node, _DEFAULT, before, lambda body: body.value(node))


def _body(written: Written, root: Node, leading: int) -> Body:
    first, last = root.start_point[0] + 1, root.end_point[0] + 1
    choices = Undecided(c for c in written.parsed.prepared.choices if first < c.first and c.last <= last)
    packs = packs_around(written.declared.node)
    shared = Shared(written.parsed, written.unit, survey(root), choices, packs, written.local, EXPRESSIONS, STATEMENTS)
    declared = written.declared
    shared.called = declared.called
    body = Body(shared, "::".join((*declared.scope, *(part.name for part in declared.before), declared.name)))
    if leading:
        body.has_this = True
        body.variables.append("this")
        body.register()
    return body


def _thunk(
    written: Written, root: Node, index: int, template: Template, lower: Callable[[Body], int], leading: int = 0
) -> Code:
    """Code that returns what `lower` gives, with the parameters of a template."""
    body = _body(written, root, leading)
    function = Function(root, None, Signature(leading=leading, template=template), index)
    prologue(body, function)
    src = lower(body)
    body.emit(Return(*body.place(root), src))
    return finish(body, function, written.declared.name)


def _content(body: Body, written: Written, node: Node) -> None:
    """The statements; those of a constructor after what it initialises. `try` may stand around both."""
    tried = next((child for child in node.named_children if child.type == "try_statement"), None)
    around = node if tried is None else tried
    listed = next((child for child in around.named_children if child.type == "field_initializer_list"), None)

    begin = partial(initialise, body, node, listed) if _is_constructor(written) else None
    if tried is not None:
        statements.try_(body, tried, begin)
        return
    if begin is not None:
        begin()
    content = node.child_by_field_name("body")
    if content is not None:
        coroutines.content(body, content)


def _is_constructor(written: Written) -> bool:
    declared = written.declared
    if not written.leading or declared.node.child_by_field_name("type") is not None:
        return False
    around = declared.before[-1].name if declared.before else declared.scope[-1] if declared.scope else ""
    return around.partition("<")[0] == declared.name


def _returns(written: Written, function: Node | None) -> Returns:
    for child in function.children if function is not None else ():
        if child.type == "trailing_return_type" and child.named_children:
            return Returns.of_descriptor(child.named_children[0])
    whole = written.declared.whole
    declarator = whole.child_by_field_name("declarator")
    here = declarator
    for _ in range(_NESTED):
        if here is None or here.type not in ("operator_cast", "qualified_identifier"):
            break
        if here.type == "operator_cast":
            return Returns.of(here.child_by_field_name("type"), here.child_by_field_name("declarator"))
        here = here.child_by_field_name("name")
    return Returns.of(whole.child_by_field_name("type"), declarator)


_NESTED: Final = 50


def _initialiser(declarator: Node, whole: Node) -> tuple[Node | None, Node | None, bool]:
    """What a variable or field begins with, its declarator, and whether `=` stands between them."""
    if declarator.type == "init_declarator":
        what = declarator.child_by_field_name("value")
        equals = any(child.type == "=" for child in declarator.children)
        return what, declarator.child_by_field_name("declarator"), equals
    found: Node | None = None
    equals = behind = False
    for child in whole.children:
        if child == declarator:
            behind = True
        elif behind and child.type in (",", ";"):
            break
        elif behind and child.type == "=":
            equals = True
        elif behind and child.is_named and child.type not in ("bitfield_clause", "comment", "attribute_declaration"):
            found = child
    return found, declarator, equals
