# SPDX-License-Identifier: Apache-2.0
"""What a declared library function does: the effects that its decorators name, and a value of its return annotation."""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Text, Unknown, Value
from rosward.engine.unknown.havoc import change
from rosward.models.ros.marks import perform

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_PURE: Final = Tuple((Const("pure"),))
_CALLS: Final = Const("calls")
_RAISES_NOTHING: Final = Tuple((Const("raises_nothing"),))


def is_model(function: Function) -> bool:
    """Whether a function belongs to a library model."""
    return function.code.is_model


_HARMLESS: Final = (Const("sends"), Const("pure"), Const("suspends"), Const("waits"))


def may_raise(machine: Engine, function: Function, registers: list[Value]) -> bool:
    """Whether a function of a model, which shows nothing of what it does, may raise an exception."""
    if not is_model(function):
        return False
    declares = any(isinstance(e, Tuple) and e.items[0] not in _HARMLESS for e in function.effects)
    if not (function.code.is_stub or declares):
        return False
    facts = machine.library.facts
    if function.code.name in facts.creating:
        return not all(_fits(v) for v in registers)
    return function.module.name not in facts.raising_nothing and _RAISES_NOTHING not in function.effects


_TOKEN: Final = "[A-Za-z_{}][A-Za-z0-9_{}]*"
_NAME: Final = re.compile(rf"~|/|~?/?{_TOKEN}(?:/{_TOKEN})*")


def _fits(value: Value) -> bool:
    """Whether an argument of a method that creates an entity is one that it surely takes."""
    if value.__class__ is Const:
        return not isinstance(value.value, str) or bool(_NAME.fullmatch(value.value))
    return value.__class__ not in (Unknown, Text, Choice)


def apply(machine: Engine, function: Function, registers: list[Value]) -> Value | None:
    """Perform the declared effects; a value where one of them is the whole call (`@native`)."""
    named = dict(zip(function.code.parameters.names, registers, strict=True))
    for spec in reversed(function.effects):
        assert isinstance(spec, Tuple)
        kind = spec.items[0]
        if kind == Const("native"):
            return machine.call_native(f"{function.module.name}.{function.code.qualname}", tuple(registers))
        if kind == Const("changes"):
            assert isinstance(spec.items[1], Tuple)
            for name in spec.items[1].items:
                change(machine, named[text_of(name)], f"{function.module.name}.{function.code.qualname}")
        perform(machine, spec, named)
    return None


def result(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """A value of the return annotation. What the library was given and can call, it may call, unless the model says `@pure`, or what it calls."""
    code = function.code
    if _PURE not in function.effects:
        called = {e.items[1] for e in function.effects if isinstance(e, Tuple) and e.items[0] == _CALLS}
        names = code.parameters.names
        machine.may_call(
            [r for n, r in zip(names, registers, strict=True) if Const(n) not in called] if called else registers
        )
    dotted = f"{function.module.name}.{code.qualname}"
    if code.returns is None:
        return machine.unknown(Cause.CALL, dotted)
    tree = _parsed(machine, code.returns)
    if tree is None:
        return machine.unknown(Cause.CALL, dotted)
    return _of_annotation(machine, function, tree, registers, dotted)


def _parsed(machine: Engine, text: str) -> ast.expr | None:
    """An annotation, parsed once for each process; None where it is none."""
    known, key = machine.log.remembered, ("annotation", text)
    if key not in known:
        try:
            known[key] = ast.parse(text, mode="eval").body
        except SyntaxError:
            known[key] = None
    found = known[key]
    return found if isinstance(found, ast.expr) else None


def _of_annotation(machine: Engine, function: Function, tree: ast.expr, registers: list[Value], dotted: str) -> Value:
    if isinstance(tree, ast.Constant):
        if tree.value is None:
            return NONE
        if isinstance(tree.value, str):
            return _of_annotation(machine, function, ast.parse(tree.value, mode="eval").body, registers, dotted)
    if isinstance(tree, ast.BinOp):
        return join_all(_of_annotation(machine, function, side, registers, dotted) for side in (tree.left, tree.right))
    if isinstance(tree, ast.Subscript):
        head = ast.unparse(tree.value).rpartition(".")[2]
        inner = tree.slice.elts if isinstance(tree.slice, ast.Tuple) else [tree.slice]
        if head in ("Optional", "Union"):
            values = [_of_annotation(machine, function, e, registers, dotted) for e in inner]
            return join_all([*values, NONE] if head == "Optional" else values)
        if head in ("tuple", "Tuple") and not any(isinstance(e, ast.Constant) and e.value is ... for e in inner):
            return Tuple(tuple(_of_annotation(machine, function, e, registers, dotted) for e in inner))
        return _of_annotation(machine, function, tree.value, registers, dotted)
    if isinstance(tree, ast.Name) and tree.id == "Self":
        return registers[0] if registers else machine.unknown(Cause.CALL, dotted)
    if isinstance(tree, (ast.Name, ast.Attribute)):
        return _instance(machine, _evaluate(machine, function, tree), dotted)
    return machine.unknown(Cause.CALL, dotted)


def _evaluate(machine: Engine, function: Function, tree: ast.expr) -> Value:
    if isinstance(tree, ast.Name):
        found = machine.at(function.module.address).attrs.get(tree.id)
        return (
            found
            if found is not None and found is not UNBOUND
            else machine.languages[function.code.language].load_global(machine, function.module, tree.id)
        )
    if isinstance(tree, ast.Attribute):
        return machine.load_attr(_evaluate(machine, function, tree.value), tree.attr)
    return NONE


def _instance(machine: Engine, cls: Value, dotted: str) -> Value:
    """An opaque value of a class."""
    if cls.__class__ is Class:
        if any(b.__class__ is Class and b.module == "enum" for b in cls.mro[1:]):  # one of its members: not known which
            return machine.unknown(Cause.CALL, dotted)
        return opaque(machine, cls)
    if cls.__class__ is Native:
        short = cls.name.removeprefix("builtins.")
        return NONE if short == "None" else Unknown(machine.unknown(Cause.CALL, dotted).reasons, short)
    return machine.unknown(Cause.CALL, dotted)


def opaque(machine: Engine, cls: Value) -> Value:
    """A new instance of a class on which `__init__` was not run."""
    return join_all(machine.allocate(Obj("instance", c), "opaque") for c in options(cls))
