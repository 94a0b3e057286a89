# SPDX-License-Identifier: Apache-2.0
"""Random small nodes through which information flows in the ways of `flow_ways.py`: `write(Seeded(7))` gives the text of one.

Nothing raises, and every loop ends: what comes out of the holes is of the right type, lists may be empty where they are read.
"""

from __future__ import annotations

import ast
import re
import textwrap
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from .draft import Chooser
from .flow_skeleton import HEAD, HELPER, NODE
from .flow_ways import BLOCKS, CONDITIONS, NUMBERS, PLAIN, SENDING, TEXTS

_MESSAGES: Final[dict[str, dict[str, list[str]]]] = {
    "Float64": {"n": ["msg.data"]},
    "Int32": {"n": ["float(msg.data)"]},
    "Bool": {"c": ["msg.data"]},
    "String": {"t": ["msg.data"]},
    "Twist": {"n": ["msg.linear.x", "msg.angular.z"], "m": ["msg"]},
    "PointStamped": {"n": ["msg.point.x", "float(msg.header.stamp.sec)"], "t": ["msg.header.frame_id"]},
    "Float64MultiArray": {"n": ["msg.data[0]"], "l": ["data"]},
}
_PLACES: Final = {
    "l": ["self.l0", "self.l1", "self.rows[0]", "self.o0.items"],
    "d": ["self.d0", "self.d1", "self.o1.by_key"],
    "o": ["self.o0", "self.o1", "self.helpers['c']"],
    "m": ["self.m0", "self.recent[-1]"],
}
_HOLE: Final = re.compile(r"\{\{|\}\}|\{(w[ldom]?|[a-z])(\d?)\}")


@dataclass
class _Scope:
    """Where something stands. `own`: in a method of the node; `known`: what holds a number, list …; `names`: local variables."""

    own: bool = True
    known: dict[str, list[str]] = field(default_factory=dict)
    names: list[str] = field(default_factory=list)
    result: bool = False
    helpers: int = 0  # which helper methods may be called: those of higher numbers
    inner: bool = False

    def inside(self) -> _Scope:
        """A block in it."""
        return replace(self, known={k: list(v) for k, v in self.known.items()}, names=list(self.names))


class _Writer:
    def __init__(self, chooser: Chooser) -> None:
        self.chooser = chooser
        self.number = 0
        self.helpers = chooser.number(1, 2)

    def fresh(self, kind: str) -> str:
        self.number += 1
        return f"{kind or 'v'}{self.number}"

    # Expressions

    def expression(self, kind: str, scope: _Scope, depth: int) -> str:
        known = scope.known.get(kind, [])
        if known and self.chooser.chance(50 if depth > 0 else 75):
            return self.chooser.pick(known)
        ways = {"n": NUMBERS, "c": CONDITIONS, "t": TEXTS}[kind]
        if depth <= 0:
            ways = (
                tuple(w for w in ways if not re.search(r"\{[nct]\}", w)) if kind != "c" else ("{n} > 1.0", "self.flag")
            )
        return self.filled(self.chooser.pick(self.usable(ways, scope)), scope, depth)

    def usable(self, ways: tuple[str, ...], scope: _Scope) -> list[str]:
        found = []
        for way in ways:
            if "{h}" in way and scope.helpers >= self.helpers:
                continue
            if ("{x}" in way or "{y}" in way) and not scope.names:
                continue
            if "hook()" in way and (scope.inner or scope.helpers):
                continue
            if scope.inner and any(word in way for word in ("{y}", "{l} +=", "{d} |=", "{d}, {d2} =")):
                continue
            if not scope.own and ("self." in way or "{a}" in way or any("{" + k in way for k in "ldom")):
                continue
            found.append(way)
        return found

    def filled(self, way: str, scope: _Scope, depth: int) -> str:
        held: dict[str, str] = {}
        new: list[tuple[int, str, str]] = []
        inner = scope.inside()
        bound = way.startswith(("{w", "def inner", "steps", "value"))

        def hole(match: re.Match[str]) -> str:
            if match[0] in ("{{", "}}"):
                return match[0][0]
            kind, key = match[1], match[1] + match[2]
            line = way.count("\n", 0, match.start())
            while new and new[0][0] < line:
                _, what, name = new.pop(0)
                _know(inner, what, name)
                if bound:
                    _know(scope, what, name)
            if kind in "nct":
                return self.expression(kind, inner, depth - 1)
            if kind == "b":
                lines = self.block(inner.inside(), depth - 1)
                return textwrap.indent(lines, "    ") if not match[2] else lines.replace("\n", "\n        ")
            if kind == "f":
                return textwrap.indent(
                    self.block(replace(inner.inside(), names=[], result=False, inner=True), depth - 1), "    "
                )
            if kind == "r":
                return f"return {self.expression('n', inner, 1)}" if scope.result else "return"
            if key not in held:
                held[key] = self.place(kind, scope, held)
                if kind.startswith("w"):
                    new.append((line, kind[1:], held[key]))
            return held[key]

        text = _HOLE.sub(hole, way)
        if bound:
            for _, kind, name in new:
                _know(scope, kind, name)
        return text

    def place(self, kind: str, scope: _Scope, held: dict[str, str]) -> str:
        pick = self.chooser.pick
        if kind.startswith(("w", "z")):
            return self.fresh(kind[1:])
        if kind in "xy":
            return pick(scope.names)
        if kind == "a":
            return pick(["n0", "n1", "n2"])
        if kind == "k":
            return pick(["a", "b", "c"])
        if kind == "h":
            return f"helper{self.chooser.number(scope.helpers, self.helpers - 1)}"
        places = _PLACES[kind] + 2 * scope.known.get(kind, [])
        others = [p for p in places if p not in held.values()]
        return pick(others or places)

    # Statements

    def block(self, scope: _Scope, depth: int, most: int = 3) -> str:
        lines = []
        for _ in range(self.chooser.number(1, most)):
            lines.append(self.statement(scope, depth))
        return "\n".join(lines)

    def statement(self, scope: _Scope, depth: int) -> str:
        kind = self.chooser.number(0, 9)
        ways = BLOCKS if kind < 4 and depth > 0 else SENDING if kind == 9 and scope.own else PLAIN
        usable = self.usable(ways, scope)
        return self.filled(self.chooser.pick(usable), scope, self.chooser.number(1, 2) if ways is not BLOCKS else depth)

    # The program

    def method(self, head: str, scope: _Scope, first: str = "", *, sends: bool = False) -> str:
        body = [first] if first else []
        body.append(self.block(scope, self.chooser.number(0, 2), self.chooser.number(1, 3)))
        if sends:
            body.append(self.filled(self.chooser.pick(self.usable(SENDING, scope)), scope, self.chooser.number(1, 2)))
        if scope.result:
            body.append(f"return {self.expression('n', scope, 2)}")
        return f"\n    def {head}:\n" + textwrap.indent("\n".join(body), " " * 8) + "\n"

    def program(self) -> str:
        pick = self.chooser.pick
        methods, init = [], []
        for name in "abc"[: self.chooser.number(2, 3)]:
            kind = pick(list(_MESSAGES))
            init.append(f"self.create_subscription({kind}, '/{name}', self.on_{name}, 10)")
            known = {k: 2 * v for k, v in _MESSAGES[kind].items()}
            first = "data = list(msg.data)" if "l" in known else ""
            methods.append(
                self.method(f"on_{name}(self, msg)", _Scope(known=known), first, sends=self.chooser.chance(60))
            )
        methods.append(self.method("tick(self)", _Scope(), sends=True))
        if self.chooser.chance(40):
            init.append("self.create_service(SetBool, '/set', self.on_set)")
            body = self.method("on_set(self, request, response)", _Scope(known={"c": ["request.data"]}))
            body = re.sub(r"\breturn$", "return response", body, flags=re.M)
            methods.append(
                f"{body}        response.message = {self.expression('t', _Scope(), 1)}\n        return response\n"
            )
        for number in range(self.helpers):
            scope = _Scope(known={"n": ["p", "other"]}, names=["p"], result=True, helpers=number + 1)
            methods.append(self.method(f"helper{number}(self, p, other={pick(['0.0', '3.0'])})", scope))
        of_generator = self.block(_Scope(known={"n": ["p"]}, names=["p"], helpers=9), 0, 2)
        answer = _Scope(known={"t": ["answer.message"], "c": ["answer.success"]})
        node = NODE.format(
            init=textwrap.indent("\n".join([*init, self.statement(_Scope(helpers=9), 0)]), " " * 8),
            counting=textwrap.indent(of_generator.replace("self.counting", "(lambda v: iter([v, v]))"), " " * 8),
            answer=textwrap.indent(self.block(answer, 1).replace("self.ask", "bool"), " " * 8),
            methods="".join(methods),
        )
        return _pruned(HEAD + self.helper() + node)

    def helper(self) -> str:
        pick = self.chooser.pick
        fields = ["self.value", "self.other", "sum(self.items)", "self.by_key['a']"]
        names = [*fields, "p", "p"]

        def number() -> str:
            return pick(
                [
                    *names,
                    f"({pick(names)} + {pick(names)})",
                    f"({pick(names)} if {pick(names)} > 1.0 else {pick(names)})",
                ]
            )

        def write() -> str:
            place = pick(["self.value", "self.other", "self.by_key['a']", "self.by_key['b']", "self.value"])
            return pick(
                [
                    f"{place} = {number()}",
                    f"{place} += {number()}",
                    f"if {number()} > 1.0:\n    {place} = {number()}",
                    f"if {number()} > {number()}:\n    return {number()}",
                    f"self.items.append({number()})",
                    f"self.items = [{number()}]",
                    f"self.items = self.items[-2:]\n{place} = len(self.items)",
                    f"self.name = str({number()})",
                    f"for v in self.items[:2]:\n    {place} += v",
                ]
            )

        def body() -> str:
            return textwrap.indent("\n".join([write(), write(), f"return {number()}"]), " " * 8)

        keep = textwrap.indent(write(), " " * 8)
        return HELPER.format(step=body(), keep=keep, level=pick(fields), call=body(), further=number())


def _pruned(text: str) -> str:
    """The same without what nothing uses."""
    tree = ast.parse(text)
    while True:
        used = Counter(
            n.attr if isinstance(n, ast.Attribute) else n.id
            for n in ast.walk(tree)
            if isinstance(n, (ast.Attribute, ast.Name))
        )

        found = [(block, s) for block in _blocks(tree) for s in block if not any(used[n] for n in _defined(s, used))]
        if not found:
            return ast.unparse(tree) + "\n"
        for block, statement in found:
            block.remove(statement)
            if not block:
                block.append(ast.Pass())


def _blocks(tree: ast.Module) -> Iterator[list[ast.stmt]]:
    """The definitions of the module, the methods of its classes, and what their constructors write."""
    yield tree.body
    for statement in tree.body:
        if isinstance(statement, ast.ClassDef):
            yield statement.body
            yield from (s.body for s in statement.body if isinstance(s, ast.FunctionDef) and s.name == "__init__")


def _defined(statement: ast.stmt, used: Counter[str]) -> list[str]:
    """The names by which a statement is used; what has to stay in any case is `Node`."""
    if isinstance(statement, (ast.FunctionDef, ast.ClassDef)) and not statement.name.startswith("__"):
        return [statement.name]
    if isinstance(statement, ast.ImportFrom):
        statement.names = [a for a in statement.names if used[a.name]] or statement.names
        return [a.name for a in statement.names]
    if isinstance(statement, ast.Import):
        return [a.name for a in statement.names]
    if isinstance(statement, ast.Assign) and isinstance(target := statement.targets[0], (ast.Attribute, ast.Name)):
        name = target.attr if isinstance(target, ast.Attribute) else target.id
        return ["Node"] if used[name] > (1 if name != "timer" else 0) else []
    return ["Node"]


def _know(scope: _Scope, kind: str, name: str) -> None:
    if kind:
        scope.known.setdefault(kind, []).append(name)
    else:
        scope.known.setdefault("n", []).append(name)
        scope.names.append(name)


def write(chooser: Chooser) -> str:
    """A program."""
    return _Writer(chooser).program()
