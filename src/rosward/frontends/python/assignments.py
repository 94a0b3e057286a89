# SPDX-License-Identifier: Apache-2.0
"""Assignments: to names, attributes, items and patterns of these; `del`; imports, which assign too.

a, self.b = value      unpack %1, %2 = value; a = %1; self.b = %2
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from rosward.frontends.python.body import Body, Located, misplaced
from rosward.frontends.python.expressions import BINARY
from rosward.frontends.python.scopes import PlaceKind, ScopeKind
from rosward.ir.ops import (
    NO_REGISTER,
    Binary,
    Delete,
    Import,
    ImportFrom,
    ImportStar,
    LoadAttr,
    LoadItem,
    StoreAttr,
    StoreItem,
    Unpack,
)


def assign(body: Body, target: ast.expr, src: int) -> None:
    """target = src; a temporary src ends here."""
    line, column = target.lineno, target.col_offset + 1
    if isinstance(target, ast.Name):
        body.store(target, target.id, src)
    elif isinstance(target, ast.Attribute):
        obj = body.expression(target.value)
        body.ops.append(StoreAttr(line, column, obj, body.scope.mangle(target.attr), src))
    elif isinstance(target, ast.Subscript):
        obj = body.expression(target.value)
        index = body.expression(target.slice)
        body.ops.append(StoreItem(line, column, obj, index, src))
    elif isinstance(target, (ast.Tuple, ast.List)):
        _unpack(body, target, target.elts, src)
    elif isinstance(target, ast.Starred):
        raise misplaced(target, "starred assignment target must be in a list or tuple")
    else:
        body.unsupported(target)


def _unpack(body: Body, node: ast.expr, targets: Sequence[ast.expr], src: int) -> None:
    star = NO_REGISTER
    inner: list[ast.expr] = []
    for number, target in enumerate(targets):
        if isinstance(target, ast.Starred):
            if star != NO_REGISTER:
                raise misplaced(target, "multiple starred expressions in assignment")
            star = number
            inner.append(target.value)
        else:
            inner.append(target)
    registers = [body.local(target) for target in inner]
    direct = NO_REGISTER not in registers
    if not direct:
        registers = [body.register() for _ in inner]
    body.ops.append(Unpack(node.lineno, node.col_offset + 1, tuple(registers), star, src))
    if not direct:
        for target, register in zip(inner, registers, strict=True):
            assign(body, target, register)


def target_register(body: Body, target: ast.expr | None) -> int:
    """Where to put what `target` is to get: its own register, or a temporary for `finish_target` to assign."""
    if target is None:
        return NO_REGISTER
    register = body.local(target)
    return body.register() if register == NO_REGISTER else register


def finish_target(body: Body, target: ast.expr | None, register: int) -> None:
    """Assign what arrived in the register that `target_register` chose."""
    if target is not None and body.local(target) == NO_REGISTER:
        assign(body, target, register)


def _assign(body: Body, node: ast.Assign) -> None:
    src = body.expression(node.value)
    if len(node.targets) == 1:
        assign(body, node.targets[0], src)
        return
    shared = body.register()  # not to be written by the first target
    body.move(node, shared, src)
    for target in node.targets:
        assign(body, target, shared)


def _augmented(body: Body, node: ast.AugAssign) -> None:
    target = node.target
    line, column = node.lineno, node.col_offset + 1
    operator = BINARY[type(node.op)]

    def combine(current: int) -> int:
        value = body.expression(node.value)
        dst = body.register()
        body.ops.append(Binary(line, column, dst, operator, current, value, True))
        return dst

    if isinstance(target, ast.Name):
        body.store(target, target.id, combine(body.load(target, target.id)))
        return
    obj = body.expression(target.value)
    current = body.register()
    if isinstance(target, ast.Attribute):
        name = body.scope.mangle(target.attr)
        body.ops.append(LoadAttr(line, column, current, obj, name))
        body.ops.append(StoreAttr(line, column, obj, name, combine(current)))
    else:
        index = body.expression(target.slice)
        body.ops.append(LoadItem(line, column, current, obj, index))
        body.ops.append(StoreItem(line, column, obj, index, combine(current)))


def _annotated(body: Body, node: ast.AnnAssign) -> None:
    target = node.target
    if node.value is not None:
        assign(body, target, body.expression(node.value))
    if body.scope.kind is ScopeKind.CLASS and isinstance(target, ast.Name) and node.simple:
        name = body.constant(node, body.scope.mangle(target.id))
        text = body.constant(node.annotation, annotation_text(node.annotation))
        body.intrinsic(node, "annotate", (name, text))


def annotation_text(node: ast.expr) -> str:
    """An annotation as `ast.unparse` writes it; the common ones without its help, which is slow."""
    names: list[str] = []
    at = node
    while isinstance(at, ast.Attribute):
        names.append(at.attr)
        at = at.value
    if isinstance(at, ast.Name):
        names.append(at.id)
        return ".".join(reversed(names))
    if node is at and isinstance(at, ast.Constant) and at.value is None:
        return "None"
    return ast.unparse(node)


def _delete(body: Body, node: ast.Delete) -> None:
    for target in node.targets:
        _delete_one(body, target)


def delete_name(body: Body, node: Located, name: str) -> None:
    """`del name`."""
    name = body.scope.mangle(name)
    line, column = node.lineno, node.col_offset + 1
    kind, number = body.place(name)
    if kind is PlaceKind.REGISTER:
        body.check(node, number)
        body.ops.append(Delete(line, column, "local", number, name))
        body.mark(node, number, False)
    elif kind is PlaceKind.CELL:
        body.ops.append(Delete(line, column, "cell", number, name))
    else:
        body.ops.append(Delete(line, column, "global" if kind is PlaceKind.GLOBAL else "name", NO_REGISTER, name))


def _delete_one(body: Body, target: ast.expr) -> None:
    line, column = target.lineno, target.col_offset + 1
    if isinstance(target, ast.Name):
        delete_name(body, target, target.id)
    elif isinstance(target, ast.Attribute):
        obj = body.expression(target.value)
        body.ops.append(Delete(line, column, "attr", obj, body.scope.mangle(target.attr)))
    elif isinstance(target, ast.Subscript):
        obj = body.expression(target.value)
        index = body.expression(target.slice)
        body.ops.append(Delete(line, column, "item", obj, "", index))
    elif isinstance(target, (ast.Tuple, ast.List)):
        for inner in target.elts:
            _delete_one(body, inner)
    else:
        body.unsupported(target)


def _import(body: Body, node: ast.Import) -> None:
    for alias in node.names:
        body.imports(alias.name)
        dst = body.register()
        leaf = alias.asname is not None
        body.ops.append(Import(node.lineno, alias.col_offset + 1, dst, alias.name, leaf))
        body.store(node, alias.asname or alias.name.partition(".")[0], dst)


def _import_from(body: Body, node: ast.ImportFrom) -> None:
    module, level = node.module or "", node.level or 0
    prefix = "." * level + module
    body.imports(prefix)
    for alias in node.names:
        line, column = alias.lineno, alias.col_offset + 1
        if alias.name == "*":
            body.ops.append(ImportStar(line, column, module, level))
            continue
        body.imports(f"{prefix}.{alias.name}" if module else prefix + alias.name)
        dst = body.register()
        body.ops.append(ImportFrom(line, column, dst, module, level, body.scope.mangle(alias.name)))
        body.store(alias, alias.asname or alias.name, dst)


STATEMENTS: Final[Mapping[type, Callable[[Body, Any], None]]] = {
    ast.Assign: _assign,
    ast.AugAssign: _augmented,
    ast.AnnAssign: _annotated,
    ast.Delete: _delete,
    ast.Import: _import,
    ast.ImportFrom: _import_from,
}
