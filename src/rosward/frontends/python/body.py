# SPDX-License-Identifier: Apache-2.0
"""The code body being lowered: its registers, its current block, its variables.

The modules beside this one lower one kind of syntax each; what they share is here. `Unit` carries the tables from node
type to lowering function, which `module.py` puts together, so that expressions, statements and definitions need not
import each other.

Registers: parameters, then locals, then temporaries. Temporaries are a stack: those of a statement are free after it.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, Protocol, final

from rosward.frontends.front_end import FrontendError
from rosward.frontends.python.scopes import PlaceKind, Scope, ScopeKind, VariablePlace
from rosward.frontends.python.symbols import Symbols
from rosward.ir.ops import (
    NO_REGISTER,
    Await,
    Binary,
    Block,
    Build,
    Call,
    Compare,
    Const,
    Constant,
    Format,
    Import,
    ImportFrom,
    Intrinsic,
    LoadAttr,
    LoadCell,
    LoadGlobal,
    LoadItem,
    LoadName,
    MakeClass,
    MakeFunction,
    Move,
    StoreCell,
    StoreGlobal,
    StoreName,
    Unary,
    Yield,
)

_HAS_DST: Final = (
    *(Const, LoadGlobal, LoadName, LoadCell, LoadAttr, LoadItem, Unary, Binary, Compare, Call, Build, Format),
    *(MakeFunction, MakeClass, Import, ImportFrom, Intrinsic, Yield, Await),
)


class Located(Protocol):
    """A node with a place in the source."""

    lineno: int
    col_offset: int


def misplaced(node: Located, message: str) -> FrontendError:
    """What the compiler of Python, unlike its parser, rejects."""
    return FrontendError("syntax", message, node.lineno, node.col_offset + 1)


@final
class Unit:
    """What the bodies of one file share."""

    __slots__ = ("bodies", "expressions", "file", "first", "has_main", "imports", "name", "statements", "symbols")

    def __init__(
        self,
        file: str,
        name: str,
        symbols: Symbols,
        expressions: Mapping[type, Callable[[Body, Any], int]],
        statements: Mapping[type, Callable[[Body, Any], None]],
    ) -> None:
        self.file = file
        self.name = name  # what the keys of its bodies begin with
        self.symbols = symbols
        self.expressions = expressions
        self.statements = statements
        self.imports: set[str] = set()
        self.first: set[str] = set()  # those of them that no function has to be called for
        self.has_main = False
        self.bodies = 0  # how many code bodies there are so far


@final
class Body:
    """One code body on its way into the IR."""

    __slots__ = (
        "effects",
        "free_register",
        "is_coroutine",
        "loops",
        "marks",
        "ops",
        "owner",
        "qualname",
        "registers",
        "scope",
        "unit",
        "unset",
    )

    def __init__(self, unit: Unit, scope: Scope, qualname: str, *, is_coroutine: bool = False) -> None:
        self.unit = unit
        self.scope = scope  # the innermost scope, an INLINE one within a comprehension
        self.owner = scope
        self.qualname = qualname
        self.is_coroutine = is_coroutine
        self.ops: Block = []
        self.free_register = 0
        self.registers = 0
        self.loops = 0
        self.unset: set[ast.Name] = set()  # the reads of local variables that may find no value
        self.marks: dict[int, int] = {}  # for the register of each of them one that says whether it has a value
        self.effects = 0  # counts what may run code elsewhere: calls, awaits, yields

    def imports(self, module: str) -> None:
        """This code imports a module."""
        self.unit.imports.add(module)
        if not self.owner.in_function:
            self.unit.first.add(module)

    # Registers and blocks

    def register(self) -> int:
        """A new temporary."""
        number = self.free_register
        self.free_register = number + 1
        if number >= self.registers:
            self.registers = number + 1
        return number

    def block(self, lower: Callable[[], None]) -> Block:
        """The operations that `lower` emits."""
        outer = self.ops
        inner: Block = []
        self.ops = inner
        lower()
        self.ops = outer
        return inner

    def suite(self, nodes: Sequence[ast.stmt]) -> Block:
        """The operations of some statements."""
        outer = self.ops
        inner: Block = []
        self.ops = inner
        self.statements(nodes)
        self.ops = outer
        return inner

    def loop_suite(self, nodes: Sequence[ast.stmt]) -> None:
        """Lower the statements of a loop's body here."""
        self.loops += 1
        self.statements(nodes)
        self.loops -= 1

    # Nodes

    def statements(self, nodes: Sequence[ast.stmt]) -> None:
        """Lower statements into the current block."""
        table = self.unit.statements
        mark = self.free_register
        for node in nodes:
            handler = table.get(type(node))
            if handler is None:
                self.unsupported(node)
            else:
                handler(self, node)
            self.free_register = mark

    def expression(self, node: ast.expr) -> int:
        """Lower an expression; its value is in the register returned, which is not to be written."""
        handler = self.unit.expressions.get(type(node))
        if handler is None:
            return self.unsupported(node)
        return handler(self, node)

    def unsupported(self, node: Located) -> int:
        """A construct that this frontend doesn't know."""
        return self.intrinsic(node, "unsupported", ())

    def constant(self, node: Located, value: Constant) -> int:
        """A register with a constant."""
        dst = self.register()
        self.ops.append(Const(node.lineno, node.col_offset + 1, dst, value))
        return dst

    def intrinsic(self, node: Located, name: str, arguments: tuple[int, ...]) -> int:
        """A register with the result of an intrinsic."""
        dst = self.register()
        self.ops.append(Intrinsic(node.lineno, node.col_offset + 1, dst, name, arguments))
        return dst

    def move(self, node: Located, dst: int, src: int) -> None:
        """dst = src."""
        if dst != src:
            self.ops.append(Move(node.lineno, node.col_offset + 1, dst, src))

    def settle(self, node: Located, dst: int, src: int) -> None:
        """dst = src, where a temporary src is not used any more: let the operation that computed it write to dst."""
        last = self.ops[-1] if self.ops else None
        if isinstance(last, _HAS_DST) and last.dst == src and src >= len(self.owner.registers):
            last.dst = dst
        else:
            self.move(node, dst, src)

    # Variables

    def place(self, name: str) -> VariablePlace:
        """Where the variable lives."""
        if name.startswith("__"):
            name = self.scope.mangle(name)
        return self.scope.place(name)

    def local(self, node: ast.expr | None) -> int:
        """The register of a local variable to which an operation may write its result, or NO_REGISTER."""
        if type(node) is not ast.Name:
            return NO_REGISTER
        kind, number = self.place(node.id)
        return number if kind is PlaceKind.REGISTER and number not in self.marks else NO_REGISTER

    def load(self, node: Located, name: str) -> int:
        """A register with the value of a variable: its own register where it has one."""
        if name.startswith("__"):
            name = self.scope.mangle(name)
        kind, number = self.scope.place(name)
        self.check(node, number)
        if kind is PlaceKind.REGISTER and name not in self.owner.walrus:
            return number
        dst = self.register()
        line, column = node.lineno, node.col_offset + 1
        if kind is PlaceKind.GLOBAL:
            self.ops.append(LoadGlobal(line, column, dst, name))
        elif kind is PlaceKind.CELL:
            self.ops.append(LoadCell(line, column, dst, number))
        elif kind is PlaceKind.NAME:
            self.ops.append(LoadName(line, column, dst, name, number))
        else:
            self.ops.append(Move(line, column, dst, number))
        return dst

    def watch(self, reads: set[ast.Name]) -> None:
        """Follow whether the variables have a value that are read here."""
        self.unset = reads
        line = min((read.lineno for read in reads), default=0)
        for name in sorted({read.id for read in reads}):
            number = self.place(name).number
            self.marks[number] = self.register()
            self.ops.append(Const(line, 1, self.marks[number], False))

    def check(self, node: Located, number: int) -> None:
        """The local variable in a register is read here, or deleted: it may have no value."""
        if node in self.unset:
            self.intrinsic(node, "bound", (self.marks[number],))

    def mark(self, node: Located, number: int, has_value: bool) -> None:
        """The local variable in a register has a value from here on, or has none."""
        if number in self.marks:
            self.ops.append(Const(node.lineno, node.col_offset + 1, self.marks[number], has_value))

    def store(self, node: Located, name: str, src: int) -> None:
        """Assign to a variable. src may be a temporary that ends here."""
        if name.startswith("__"):
            name = self.scope.mangle(name)
        kind, number = self.scope.place(name)
        line, column = node.lineno, node.col_offset + 1
        if kind is PlaceKind.REGISTER:
            self.settle(node, number, src)
            self.mark(node, number, True)
        elif kind is PlaceKind.GLOBAL:
            self.ops.append(StoreGlobal(line, column, name, src))
        elif kind is PlaceKind.CELL:
            self.ops.append(StoreCell(line, column, number, src))
        else:
            self.ops.append(StoreName(line, column, name, src))

    @property
    def in_function(self) -> bool:
        """Whether this is the body of a function."""
        return self.owner.kind is ScopeKind.FUNCTION
