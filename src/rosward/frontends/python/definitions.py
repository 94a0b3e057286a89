# SPDX-License-Identifier: Apache-2.0
"""Functions, lambdas and classes: each becomes a `Code` of its own, and an operation that makes the object from it.

@traced                      %1 = global traced; %2 = make function talk; %3 = call %1(%2); global talk = %3
def talk(): …
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python.assignments import annotation_text
from rosward.frontends.python.body import Body, Located, Unit, misplaced
from rosward.frontends.python.comprehensions import enter
from rosward.frontends.python.expressions import arguments
from rosward.frontends.python.scopes import Scope, ScopeKind
from rosward.frontends.python.unset import unset_reads
from rosward.ir.ops import Argument, Build, Call, ImportFrom, LoadItem, MakeClass, MakeFunction, Return, StoreCell
from rosward.ir.program import Code, CodeKind, Parameters

NO_PARAMETERS: Final = Parameters((), 0, None, (), None)

_KINDS: Final[Mapping[ScopeKind, CodeKind]] = {
    ScopeKind.MODULE: CodeKind.MODULE,
    ScopeKind.FUNCTION: CodeKind.FUNCTION,
    ScopeKind.CLASS: CodeKind.CLASS,
}


def lower_code(
    unit: Unit,
    scope: Scope,
    lower: Callable[[Body], None],
    *,
    name: str,
    qualname: str,
    line: int,
    parameters: Parameters = NO_PARAMETERS,
    is_coroutine: bool = False,
    is_stub: bool = False,
    annotations: dict[str, str] | None = None,
    returns: str | None = None,
    doc: str | None = None,
    statements: Sequence[ast.stmt] = (),
) -> Code:
    """Lower one body; `statements` are those of a function."""
    index = unit.bodies
    unit.bodies += 1
    body = Body(unit, scope, qualname, is_coroutine=is_coroutine)
    names = parameters.names
    registers = scope.registers
    for parameter in names:
        registers[parameter] = body.register()
    variables = list(names)
    if scope.kind is ScopeKind.FUNCTION:
        outside = scope.global_names | scope.nonlocal_names.keys()
        for variable in scope.bound:
            if variable not in registers and variable not in scope.captured and variable not in outside:
                registers[variable] = body.register()
                variables.append(variable)
    if statements and len(variables) > len(names):
        body.watch(unset_reads(statements, names, variables))
    for number, parameter in enumerate(names):
        if parameter in scope.captured:
            body.ops.append(StoreCell(line, 1, scope.captured[parameter], number))
    lower(body)
    return Code(
        _KINDS[scope.kind],
        name,
        qualname,
        unit.file,
        line,
        parameters,
        body.ops,
        body.registers,
        tuple(variables),
        tuple(scope.cells),
        tuple(scope.free),
        is_generator=scope.is_generator,
        is_coroutine=is_coroutine,
        is_stub=is_stub,
        annotations=annotations,
        returns=returns,
        doc=doc,
        index=index,
        unit=unit.name,
    )


def qualified(body: Body, name: str) -> str:
    """The qualified name of a function or class that is defined here."""
    if body.owner.kind is ScopeKind.MODULE:
        return name
    inner = ".<locals>." if body.in_function else "."
    return f"{body.qualname}{inner}{name}"


def captures_of(body: Body, code: Code) -> tuple[int, ...]:
    """The cells of `body` that the free cells of `code` stand for, seen from the scope that we are in."""
    return tuple(body.scope.capture(name) for name in code.free)


def _function(body: Body, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
    decorators = [body.expression(decorator) for decorator in node.decorator_list]
    defaults, kwdefaults = _defaults(body, node.args)
    outer_scope = body.scope
    _type_parameters(body, node)
    annotations = _annotations(body, node.args)

    code = lower_code(
        body.unit,
        body.unit.symbols.by_node[node],
        lambda inner: inner.statements(node.body),
        name=node.name,
        qualname=qualified(body, node.name),
        line=node.lineno,
        parameters=_parameters(body, node.args),
        is_coroutine=isinstance(node, ast.AsyncFunctionDef),
        is_stub=_is_stub(node.body),
        annotations=annotations,
        returns=None if node.returns is None else annotation_text(node.returns),
        doc=ast.get_docstring(node, clean=False),
        statements=node.body,
    )
    dst = body.register()
    captures = captures_of(body, code)
    body.ops.append(MakeFunction(node.lineno, node.col_offset + 1, dst, code, defaults, kwdefaults, captures))
    body.scope = outer_scope
    _decorate(body, node, decorators, dst)


def _lambda(body: Body, node: ast.Lambda) -> int:
    defaults, kwdefaults = _defaults(body, node.args)

    def lower(inner: Body) -> None:
        src = inner.expression(node.body)
        inner.ops.append(Return(node.body.lineno, node.body.col_offset + 1, src))

    code = lower_code(
        body.unit,
        body.unit.symbols.by_node[node],
        lower,
        name="<lambda>",
        qualname=qualified(body, "<lambda>"),
        line=node.lineno,
        parameters=_parameters(body, node.args),
    )
    dst = body.register()
    captures = captures_of(body, code)
    body.ops.append(MakeFunction(node.lineno, node.col_offset + 1, dst, code, defaults, kwdefaults, captures))
    return dst


def _class(body: Body, node: ast.ClassDef) -> None:
    decorators = [body.expression(decorator) for decorator in node.decorator_list]
    outer_scope = body.scope
    parameters = _type_parameters(body, node)
    given = arguments(body, node.bases, node.keywords)
    if parameters:
        given = _with_generic(body, node, given, parameters)
    code = lower_code(
        body.unit,
        body.unit.symbols.by_node[node],
        lambda inner: inner.statements(node.body),
        name=node.name,
        qualname=qualified(body, node.name),
        line=node.lineno,
        is_stub=_is_stub(node.body),
        doc=ast.get_docstring(node, clean=False),
    )
    dst = body.register()
    body.ops.append(MakeClass(node.lineno, node.col_offset + 1, dst, code, given, captures_of(body, code)))
    body.scope = outer_scope
    _decorate(body, node, decorators, dst)


def _decorate(
    body: Body, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef, decorators: Sequence[int], value: int
) -> None:
    for decorator, register in zip(reversed(node.decorator_list), reversed(decorators), strict=True):
        dst = body.register()
        given = (Argument("positional", value),)
        body.ops.append(Call(decorator.lineno, decorator.col_offset + 1, dst, register, given))
        value = dst
    body.store(node, node.name, value)


def _parameters(body: Body, node: ast.arguments) -> Parameters:
    mangle = body.scope.mangle
    return Parameters(
        tuple(mangle(argument.arg) for argument in (*node.posonlyargs, *node.args)),
        len(node.posonlyargs),
        None if node.vararg is None else mangle(node.vararg.arg),
        tuple(mangle(argument.arg) for argument in node.kwonlyargs),
        None if node.kwarg is None else mangle(node.kwarg.arg),
    )


def _defaults(body: Body, node: ast.arguments) -> tuple[tuple[int, ...], tuple[tuple[str, int], ...]]:
    defaults = tuple(body.expression(default) for default in node.defaults)
    kwdefaults = tuple(
        (body.scope.mangle(argument.arg), body.expression(default))
        for argument, default in zip(node.kwonlyargs, node.kw_defaults, strict=True)
        if default is not None
    )
    return defaults, kwdefaults


def _annotations(body: Body, node: ast.arguments) -> dict[str, str]:
    return {
        body.scope.mangle(argument.arg): annotation_text(argument.annotation)
        for argument in (*node.posonlyargs, *node.args, node.vararg, *node.kwonlyargs, node.kwarg)
        if argument is not None and argument.annotation is not None
    }


def _is_stub(nodes: Sequence[ast.stmt]) -> bool:
    found = False
    for number, node in enumerate(nodes):
        if not isinstance(node, ast.Expr) or not isinstance(node.value, ast.Constant):
            return False
        if node.value.value is ...:
            found = True
        elif number or not isinstance(node.value.value, str):
            return False
    return found


def _type_parameters(body: Body, node: Any) -> Sequence[Any]:
    """`def f[T]`: T is a `typing.TypeVar` in a scope around the function (PEP 695); its bound is evaluated never."""
    parameters: Sequence[Any] = getattr(node, "type_params", ())
    if not parameters:
        return ()
    enter(body, node, body.unit.symbols.by_node[parameters[0]])
    for parameter in parameters:
        kind = body.register()
        line, column = parameter.lineno, parameter.col_offset + 1
        body.ops.append(ImportFrom(line, column, kind, "typing", 0, type(parameter).__name__))
        name = body.constant(parameter, parameter.name)
        dst = body.register()
        body.ops.append(Call(line, column, dst, kind, (Argument("positional", name),)))
        body.store(parameter, parameter.name, dst)
    return parameters


def _with_generic(
    body: Body, node: ast.ClassDef, given: tuple[Argument, ...], parameters: Sequence[Any]
) -> tuple[Argument, ...]:
    """`class C[T](B)` is `class C(B, Generic[T])`."""
    line, column = node.lineno, node.col_offset + 1
    generic = body.register()
    body.ops.append(ImportFrom(line, column, generic, "typing", 0, "Generic"))
    variables = tuple(body.load(parameter, parameter.name) for parameter in parameters)
    index = variables[0] if len(variables) == 1 else _tuple(body, node, variables)
    dst = body.register()
    body.ops.append(LoadItem(line, column, dst, generic, index))
    bases = sum(1 for argument in given if argument.kind in ("positional", "star"))
    return (*given[:bases], Argument("positional", dst), *given[bases:])


def _tuple(body: Body, node: Located, registers: Sequence[int]) -> int:
    dst = body.register()
    items = tuple((False, register) for register in registers)
    body.ops.append(Build(node.lineno, node.col_offset + 1, dst, "tuple", items))
    return dst


def _return(body: Body, node: ast.Return) -> None:
    if not body.in_function:
        raise misplaced(node, "'return' outside function")
    src = body.constant(node, None) if node.value is None else body.expression(node.value)
    body.ops.append(Return(node.lineno, node.col_offset + 1, src))


EXPRESSIONS: Final[Mapping[type, Callable[[Body, Any], int]]] = {ast.Lambda: _lambda}

STATEMENTS: Final[Mapping[type, Callable[[Body, Any], None]]] = {
    ast.FunctionDef: _function,
    ast.AsyncFunctionDef: _function,
    ast.ClassDef: _class,
    ast.Return: _return,
}
