# SPDX-License-Identifier: Apache-2.0
"""Is a piece of IR well formed?

`check(code)` lists what is wrong with a body and the bodies inside it; an empty list is the promise that every frontend
keeps: registers and cells in range, temporaries written before they are read, captures that fit, `break` in a loop,
`return` in a function.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, final

from rosward.ir import cpp, ops
from rosward.ir.ops import NO_REGISTER, Block, Op
from rosward.ir.program import Code, CodeKind
from rosward.ir.registers import reads, writes

_BINARY: Final = frozenset({"+", "-", "*", "@", "/", "%", "**", "<<", ">>", "|", "^", "&", "//", ","})
_COMPARE: Final = frozenset({"==", "!=", "<", "<=", ">", ">=", "is", "is-not", "in", "not-in"})
_WORDS: Final[Mapping[type, tuple[str, frozenset[str]]]] = {
    ops.Unary: ("operator", frozenset({"not", "-", "+", "~"})),
    ops.Binary: ("operator", _BINARY),
    ops.Compare: ("operator", _COMPARE),
    ops.Assume: ("test", frozenset({"true", "decided", "empty", "is", "==", "<", ">", "in", "isinstance"})),
    ops.Build: ("kind", frozenset({"list", "tuple", "set", "dict"})),
    ops.Delete: ("kind", frozenset({"local", "cell", "global", "name", "attr", "item"})),
}


def check(code: Code) -> list[str]:
    """What is wrong with the body, one line a fault."""
    return list(_Checker(code).faults())


@final
class _Checker:
    __slots__ = ("cells", "code", "found", "locals", "written")

    def __init__(self, code: Code) -> None:
        self.code = code
        self.cells = len(code.cells) + len(code.free)
        self.locals = len(code.variables)
        self.written = set(range(self.locals))
        self.found: list[str] = []

    def faults(self) -> list[str]:
        code = self.code
        if not len(code.parameters.names) <= self.locals <= code.registers:
            self._fault(None, "parameters, variables and registers don't fit")
        if code.variables[: len(code.parameters.names)] != code.parameters.names:
            self._fault(None, "the first variables aren't the parameters")
        if len(set(code.cells)) != len(code.cells):
            self._fault(None, "two cells have one name")
        self._block(code.ops, False)
        return self.found

    def _fault(self, op: Op | None, text: str) -> None:
        place = f"{self.code.file}:{op.line if op else self.code.line}: {self.code.qualname}"
        kind = f" {type(op).__name__}" if op else ""
        self.found.append(f"{place}:{kind} {text}")

    def _block(self, block: Block, in_loop: bool) -> None:
        for op in block:
            self._op(op, in_loop)

    def _op(self, op: Op, in_loop: bool) -> None:
        if op.line < 1 or op.column < 1:
            self._fault(op, "has no place in the source")
        self._registers(op, list(reads(op)), writes(op))
        kind = type(op)
        word = _WORDS.get(kind)
        if word is not None and getattr(op, word[0]) not in word[1]:
            self._fault(op, f"unknown {word[0]} {getattr(op, word[0])!r}")
        if kind in (ops.LoadCell, ops.StoreCell, ops.NewCell, ops.LoadName, cpp.CellSlot):
            self._cell(op, getattr(op, "cell"), optional=kind is ops.LoadName)  # noqa: B009
        if kind in (ops.LoadName, ops.StoreName) and self.code.kind is not CodeKind.CLASS:
            self._fault(op, "outside of a class body")
        if isinstance(op, (ops.MakeFunction, ops.MakeClass, cpp.MakeLambda)):
            self._made(op)
        if isinstance(op, ops.Delete) and op.kind == "cell":
            self._cell(op, op.obj)
        if kind in (ops.Break, ops.Continue) and not in_loop:
            self._fault(op, "outside of a loop")
        if kind in (ops.Return, ops.Yield) and self.code.kind is not CodeKind.FUNCTION:
            self._fault(op, "outside of a function")
        self._blocks(op, in_loop)

    def _registers(self, op: Op, read: list[int], written: tuple[int, ...]) -> None:
        for register in (*read, *written):
            if not 0 <= register < self.code.registers:
                self._fault(op, f"register {register} out of range")
        for register in read:
            if register not in self.written:
                self._fault(op, f"temporary {register} is read before it is written")
        self.written.update(written)

    def _cell(self, op: Op, cell: int, *, optional: bool = False) -> None:
        if not (0 <= cell < self.cells or (optional and cell == NO_REGISTER)):
            self._fault(op, f"cell {cell} out of range")

    def _made(self, op: ops.MakeFunction | ops.MakeClass | cpp.MakeLambda) -> None:
        if len(op.captures) != len(op.code.free):
            self._fault(op, f"{len(op.captures)} captures for {len(op.code.free)} free cells")
        for cell in op.captures:
            self._cell(op, cell)
        if (op.code.kind is CodeKind.CLASS) != isinstance(op, ops.MakeClass):
            self._fault(op, f"of a body of kind {op.code.kind.value}")
        if isinstance(op, ops.MakeFunction) and len(op.defaults) > len(op.code.parameters.positional):
            self._fault(op, "more defaults than parameters")
        self.found.extend(check(op.code))

    def _blocks(self, op: Op, in_loop: bool) -> None:
        if isinstance(op, ops.If):
            self._block(op.then, in_loop)
            self._block(op.orelse, in_loop)
        elif isinstance(op, ops.While):
            self._block(op.condition, False)
            self._registers(op, [op.test], ())
            self._block(op.body, True)
            self._block(op.orelse, in_loop)
        elif isinstance(op, ops.ForEach):
            self._block(op.body, True)
            self._block(op.orelse, in_loop)
        elif isinstance(op, ops.With):
            self._block(op.body, in_loop)
        elif isinstance(op, ops.Try):
            self._try(op, in_loop)
        elif isinstance(op, cpp.Initialise):
            self._initialise(op)
        elif isinstance(op, cpp.Spread):
            self.written.update(op.items)
            self._block(op.body, False)
            self._registers(op, [op.result], ())
        elif isinstance(op, cpp.StaticLocal):
            self._block(op.body, False)
            self._registers(op, [op.result], ())
        elif isinstance(op, cpp.Default):
            self._block(op.body, False)

    def _initialise(self, op: cpp.Initialise) -> None:
        for member in op.members:
            self._block(member.type_body, False)
            self._registers(op, [member.type], ())
            self._block(member.body, False)
            self._registers(op, [argument.register for argument in member.arguments], ())

    def _try(self, op: ops.Try, in_loop: bool) -> None:
        self._block(op.body, in_loop)
        for handler in op.handlers:
            self._block(handler.match, False)
            bind = () if handler.bind == NO_REGISTER else (handler.bind,)
            self._registers(op, [] if handler.type == NO_REGISTER else [handler.type], bind)
            self._block(handler.body, in_loop)
        self._block(op.orelse, in_loop)
        self._block(op.final, in_loop)
