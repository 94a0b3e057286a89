# SPDX-License-Identifier: Apache-2.0
"""What is the text of a Python expression that launch evaluates?

    PythonExpression(["'", LaunchConfiguration('mode'), "' == 'sim'"])   with mode:=sim: "'sim' == 'sim'"  ->  'True'
    PythonExpression(["'$(find-pkg-share demo)/a.yaml' if '", …, "' else ''"])   ->  a path that begins with a hole, where the condition holds

The expression is lowered and interpreted like any other program; what it may name are the modules that are given, and what is in math.
"""

from __future__ import annotations

import ast
import builtins
import math
import re
from collections.abc import Sequence
from itertools import count
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import lift, options, reasons_of
from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.text import is_path, make, origins_of, parts_of
from rosward.domain.unknown import Cause, Origins
from rosward.domain.values import UNBOUND, Const, Hole, ModuleValue, Text, Unknown, Value
from rosward.engine.running.frame import Frame
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
        """The str() of the value; unknown where the text is no expression, or what is not known of it is no part of a string in it."""
        return lift(lambda text: self._one(text, modules, turn), expression)

    def _one(self, text: Value, modules: tuple[str, ...], turn: int) -> Value:
        machine = self._machine
        strings: dict[str, Value] = {}
        whole = _without_holes(text, strings) if isinstance(text, Text) else text
        if not isinstance(whole, Const) or not isinstance(whole.value, str):
            reasons = reasons_of(text)
            if not reasons or is_path(Unknown(reasons, "str")):  # what an expression makes of a folder is another text
                reasons += machine.unknown(Cause.OPERATION, "expression").reasons
            return Unknown(reasons, "str")
        source = whole.value.lstrip(" \t")
        names = _names(source) if len(source) <= _LONGEST else None
        if names is None:
            return machine.unknown(Cause.ERROR, f"{whole.value[:80]!r} is not a Python expression", "str")
        program = [f"import {m}" for m in modules if all(p.isidentifier() for p in m.split("."))]
        if "math" in modules:  # what is in math can be named as it is
            program += [f"from math import {n}" for n in sorted(names & vars(math).keys())]
        try:
            lines = "\n".join([*program, f"{_RESULT} = (\n{source}\n)"])
            lowered = PYTHON.lower(lines, "", name=f"expression {lines}")
        except FrontendError as error:
            return machine.unknown(Cause.ERROR, f"{whole.value[:80]!r}: {error.message}", "str")
        address = machine.place_key(("expression", turn, whole.value, *strings.values()))
        module = ModuleValue(address, "expression", "")
        value = self._run(lowered.code, module, turn, strings)
        if value is UNBOUND:
            return machine.unknown(Cause.ERROR, f"{whole.value[:80]!r} fails", "str")
        missing = _missing(
            names, {*strings, *(m.partition(".")[0] for m in modules), *(vars(math) if "math" in modules else ())}
        )
        if missing and any(isinstance(option, Unknown) for option in options(value)):
            return machine.unknown(Cause.ERROR, f"name {missing} is not defined in {whole.value[:80]!r}", "str")
        return _marked(machine.call(_STR, (value,)), origins_of(text))

    def _run(self, code: Code, module: ModuleValue, turn: int, names: dict[str, Value]) -> Value:
        machine = self._machine
        machine.put(module.address, Obj("module", Native("builtins.module"), attrs=dict(names)))
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


def _without_holes(text: Text, strings: dict[str, Value]) -> Const | None:
    """The expression with a name for each string that is not completely known, which goes to `strings`; None where a hole is elsewhere."""
    known = "".join(part for part in text.parts if isinstance(part, str))
    token = next(f"rosward_{n}_" for n in count() if f"rosward_{n}_" not in known)
    holes = [part for part in text.parts if not isinstance(part, str)]
    numbers = count()
    source = "".join(p if isinstance(p, str) else f"{token}{next(numbers)}_" for p in text.parts).lstrip(" \t")
    if len(source) > _LONGEST:
        return None
    try:
        tree = ast.parse(source, mode="eval")
        named = ast.unparse(_Strings(token, holes, text.origins, strings).visit(tree))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return None if re.search(rf"{token}\d", named) else Const(named, text.origins)


class _Strings(ast.NodeTransformer):
    """Puts a name in the place of each string with a token in it."""

    def __init__(self, token: str, holes: Sequence[Hole], origins: Origins, strings: dict[str, Value]) -> None:
        self._token = token
        self._holes = holes
        self._origins = origins
        self._strings = strings

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.AST:
        """What is within an f-string is no string of its own."""
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        """A string, with its holes again."""
        if not isinstance(node.value, str) or self._token not in node.value:
            return node
        pieces = re.split(rf"{self._token}(\d+)_", node.value)
        parts = [piece if n % 2 == 0 else self._holes[int(piece)] for n, piece in enumerate(pieces)]
        name = f"{self._token}string{len(self._strings)}"
        self._strings[name] = make(tuple(p for p in parts if p != ""), self._origins)
        return ast.copy_location(ast.Name(name, ast.Load()), node)


def _missing(names: set[str], known: set[str]) -> str:
    """The first name of an expression that nothing defines: `true` of a condition, which Python does not know."""
    return next((name for name in sorted(names - known) if not hasattr(builtins, name)), "")


def _names(source: str) -> set[str] | None:
    """The names that an expression reads and does not bind itself; None where it is none."""
    try:
        tree = ast.parse(source, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    found = [node for node in ast.walk(tree) if isinstance(node, ast.Name | ast.arg)]
    bound = {
        n.arg if isinstance(n, ast.arg) else n.id
        for n in found
        if isinstance(n, ast.arg) or isinstance(n.ctx, ast.Store)
    }
    return {node.id for node in found if isinstance(node, ast.Name)} - bound


def _marked(value: Value, origins: Origins) -> Value:
    """A text that was computed from others."""

    def one(option: Value) -> Value:
        if isinstance(option, (Const, Text)):
            return make(parts_of(option), origins_of(option) | origins)
        return option

    return lift(one, value)
