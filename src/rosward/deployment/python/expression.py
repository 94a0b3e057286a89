# SPDX-License-Identifier: Apache-2.0
"""What is the text of a Python expression that launch evaluates?

    PythonExpression(["'", LaunchConfiguration('mode'), "' == 'sim'"])   with mode:=sim: "'sim' == 'sim'"  ->  'True'

The expression is lowered and interpreted like any other program; what it may name are the modules that are given, and what is in math.
"""

from __future__ import annotations

import ast
import math
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import lift, reasons_of
from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.text import make, origins_of, parts_of
from rosward.domain.unknown import Cause, Origins
from rosward.domain.values import UNBOUND, Const, ModuleValue, Text, Unknown, Value
from rosward.engine.frame import Frame
from rosward.frontends.front_end import FrontendError
from rosward.frontends.registry import PYTHON

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter
    from rosward.ir.program import Code

_RESULT: Final = "result"
_LONGEST: Final = 20_000
_STR: Final = Native("builtins.str")


@final
class Expressions:
    """Evaluates expressions in an interpreter."""

    def __init__(self, machine: Interpreter) -> None:
        self._machine = machine

    def evaluate(self, expression: Value, modules: tuple[str, ...], turn: int) -> Value:
        """The str() of the value; unknown where the text is not completely known, or is no expression."""
        return lift(lambda text: self._one(text, modules, turn), expression)

    def _one(self, text: Value, modules: tuple[str, ...], turn: int) -> Value:
        machine = self._machine
        if not isinstance(text, Const) or not isinstance(text.value, str):
            reasons = reasons_of(text) or machine.unknown(Cause.OPERATION, "expression").reasons
            return Unknown(reasons, "str")
        source = text.value.lstrip(" \t")
        names = _names(source) if len(source) <= _LONGEST else None
        if names is None:
            return machine.unknown(Cause.ERROR, f"{text.value[:80]!r} is not a Python expression", "str")
        program = [f"import {m}" for m in modules if all(p.isidentifier() for p in m.split("."))]
        if "math" in modules:  # what is in math can be named as it is
            program += [f"from math import {n}" for n in sorted(names & vars(math).keys())]
        try:
            lines = "\n".join([*program, f"{_RESULT} = (\n{source}\n)"])
            lowered = PYTHON.lower(lines, "", name=f"expression {lines}")
        except FrontendError as error:
            return machine.unknown(Cause.ERROR, f"{text.value[:80]!r}: {error.message}", "str")
        address = machine.place_key(("expression", turn, text.value))
        module = ModuleValue(address, "expression", "")
        value = self._run(lowered.code, module, turn)
        if value is UNBOUND:
            return machine.unknown(Cause.ERROR, f"{text.value[:80]!r} fails", "str")
        return _marked(machine.call(_STR, (value,)), text.origins)

    def _run(self, code: Code, module: ModuleValue, turn: int) -> Value:
        machine = self._machine
        machine.put(module.address, Obj("module", Native("builtins.module"), attrs={}))
        context = machine.context("expression", turn, module.address)
        frame = Frame(code, [UNBOUND] * code.registers, (), module, context, stub=True)
        frame.cells = tuple(machine.new_cells(code, context))
        frames = machine.frames
        machine.frames = [*frames, frame]
        try:
            alive = machine.run(code.ops, frame)
        finally:
            machine.frames = frames
        return machine.at(module.address).attrs.get(_RESULT, UNBOUND) if alive else UNBOUND


def _names(source: str) -> set[str] | None:
    """The names that an expression uses; None where it is none."""
    try:
        tree = ast.parse(source, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


def _marked(value: Value, origins: Origins) -> Value:
    """A text that was computed from others."""

    def one(option: Value) -> Value:
        if isinstance(option, (Const, Text)):
            return make(parts_of(option), origins_of(option) | origins)
        return option

    return lift(one, value)
