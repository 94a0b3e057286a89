# SPDX-License-Identifier: Apache-2.0
"""The code body being lowered: its registers, its current block, its variables.

The modules beside this one lower one kind of syntax each; what they share is here. `Shared` carries the tables from node type to
lowering function, which `entry.py` puts together, so that expressions, statements and lambdas need not import each other.

Registers are a stack: `this`, captures, template parameters, parameters, then the variables of each block while it lasts, then
temporaries, which are free after their statement.

An expression is lowered for what is wanted: its 'value'; its 'slot', where it stands; an 'own' one for a new variable; its 'effect' alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final, Literal, final

from rosward.frontends.cpp.lower.kept import Kept
from rosward.frontends.cpp.lower.lvalues import kind_of
from rosward.frontends.cpp.lower.survey import Survey, word
from rosward.frontends.cpp.lower.undecided import Undecided
from rosward.frontends.cpp.lower.variables import Jumps, Loop, Returns, Scope, Variable
from rosward.ir.control import Break, Continue, Raise, Return
from rosward.ir.core import NO_REGISTER, Const, Constant, LoadCell, Move, StoreCell
from rosward.ir.cpp import (
    Argued,
    Assign,
    CellSlot,
    Construct,
    Convert,
    Copy,
    EndScope,
    Invoke,
    InvokeMember,
    MakeLambda,
    Read,
    Step,
    UnknownValue,
)
from rosward.ir.op import Block, Op

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.parse import Parsed
    from rosward.ir.symbols import Scope as Path
    from rosward.ir.symbols import Symbol

Want = Literal["value", "slot", "own", "effect"]

DEPTH: Final = 100
"""How deep statements and expressions may nest; what is deeper is unknown."""
_SHOWN: Final = 60
_ENDING: Final = 100
"""How many objects may end at one place: each way out of a block ends all that are around it."""
_CHANGING: Final = (Assign, Construct, Invoke, InvokeMember, Step)
_ASKING: Final = frozenset(
    {
        "empty", "size", "length", "has_value", "front", "back", "c_str", "data", "str", "compare", "find", "rfind", "count", "contains",
        "at", "value", "value_or", "begin", "end", "cbegin", "cend", "substr", "starts_with", "ends_with",
    }
)  # fmt: skip
"""Methods that only look, whatever has them."""


@final
class Shared:
    """What the bodies of one declaration share."""

    __slots__ = ("called", "choices", "expressions", "local", "packs", "parsed", "statements", "survey", "unit", "using")  # fmt: skip

    def __init__(
        self,
        parsed: Parsed,
        unit: str,
        found: Survey,
        choices: Undecided,
        packs: frozenset[str],
        local: Callable[[Node], Symbol | None],
        expressions: Mapping[str, Callable[[Body, Node, Want], int]],
        statements: Mapping[str, Callable[[Body, Node], None]],
    ) -> None:
        self.parsed = parsed
        self.unit = unit
        self.survey = found
        self.choices = choices
        self.packs = packs  # of the templates around
        self.local = local
        self.expressions = expressions
        self.statements = statements
        self.using: list[Path] = []
        self.called: Path = ()


@final
class Body:
    """One code body on its way into the IR."""

    __slots__ = (
        "assignments",
        "c_pack",
        "cell_names",
        "cells",
        "constant_this",
        "depth",
        "effects",
        "floor",
        "free",
        "free_register",
        "function",
        "has_this",
        "jumps",
        "kept",
        "late",
        "loops",
        "ops",
        "pinned",
        "qualname",
        "registers",
        "returns",
        "scopes",
        "shared",
        "variables",
    )

    def __init__(self, shared: Shared, qualname: str, depth: int = 0) -> None:
        self.shared = shared
        self.qualname = qualname
        self.function = ""  # what `__func__` is
        self.depth = depth
        self.ops: Block = []
        self.pinned: tuple[int, int] | None = None  # where everything is said to stand, for a default of another file
        self.registers = 0
        self.free_register = 0
        self.floor = 0  # registers below it hold variables
        self.kept = Kept()  # registers of casts
        self.scopes: list[Scope] = [Scope(0)]
        self.variables: list[str] = []  # the names of the first registers
        self.cells: list[str] = []
        self.cell_names: set[str] = set()
        self.free: list[str] = []
        self.late: list[LoadCell | StoreCell | CellSlot | MakeLambda] = []  # operations that name free cells
        self.jumps: list[Jumps] = []
        self.loops: list[Loop] = []
        self.returns = Returns()
        self.has_this = False
        self.constant_this = False
        self.effects = 0  # how many operations so far may change what stands somewhere
        self.assignments = 0
        self.c_pack = NO_REGISTER  # the register of `...`

    # Registers, operations and blocks

    def place(self, node: Node) -> tuple[int, int]:
        """Where a node stands."""
        if self.pinned is not None:
            return self.pinned
        line, column = node.start_point
        return line + 1, 1 if line + 1 in self.shared.parsed.prepared.expanded else column + 1

    def register(self) -> int:
        """A new temporary."""
        number = self.kept.free_from(self.free_register)
        self.free_register = number + 1
        self.registers = max(self.registers, number + 1)
        return number

    def emit(self, op: Op) -> None:
        """Put an operation into the current block."""
        if isinstance(op, (Convert, Assign)):
            self.kept.keep(op.dst if isinstance(op, Convert) else op.slot)
        if isinstance(op, _CHANGING) and getattr(op, "name", "") not in _ASKING:
            self.effects += 1
        self.ops.append(op)

    def block(self, lower: Callable[[], object]) -> Block:
        """The operations that `lower` emits."""
        outer = self.ops
        inner: Block = []
        self.ops = inner
        lower()
        self.ops = outer
        return inner

    def constant(self, node: Node, value: Constant) -> int:
        """A register with a constant."""
        dst = self.register()
        self.emit(Const(*self.place(node), dst, value))
        return dst

    def move(self, node: Node, dst: int, src: int) -> None:
        """dst = src."""
        if dst != src:
            self.emit(Move(*self.place(node), dst, src))

    def unknown(self, node: Node, cause: Literal["macro", "syntax", "language"], subject: str = "") -> int:
        """A register with something that nobody knows."""
        dst = self.register()
        shown = " ".join((node.text or b"")[:_SHOWN].decode("utf-8", "replace").split())
        self.emit(UnknownValue(*self.place(node), dst, cause, subject or shown))
        return dst

    # Expressions and statements

    def expression(self, node: Node | None, want: Want) -> int:
        """Lower an expression; the register returned is not to be written."""
        if node is None:
            return self.nothing()
        handler = self.shared.expressions.get(node.type)
        if handler is None or self.depth >= DEPTH or (node.has_error and _broken(node)):
            return self.unknown(node, "syntax")
        self.depth += 1
        found = handler(self, node, want)
        self.depth -= 1
        return found

    def nothing(self) -> int:
        """A register with nothing in it, where the source has nothing either."""
        dst = self.register()
        self.emit(Const(self.ops[-1].line if self.ops else 1, 1, dst, None))
        return dst

    def value(self, node: Node | None) -> int:
        """The value of an expression."""
        return self.expression(node, "value")

    def slot(self, node: Node | None) -> int:
        """Where it stands; its value where that is nowhere."""
        return self.expression(node, "slot")

    def own(self, node: Node | None) -> int:
        """Its value for a variable of its own."""
        return self.expression(node, "own")

    def given(self, node: Node, slot: int, want: Want) -> int:
        """What is wanted of what stands at a slot."""
        if want in ("slot", "effect"):
            return slot
        dst = self.register()
        self.emit((Read if want == "value" else Copy)(*self.place(node), dst, slot))
        return dst

    def argued(self, node: Node) -> Argued:
        """An argument of a call."""
        if node.type == "parameter_pack_expansion":
            pattern = node.child_by_field_name("pattern")
            items = "pack" if pattern is None else kind_of(pattern, None)
            return Argued(self.expression(node, "slot"), "pack", items=items)
        variable = self.variable(word(node)) if node.type == "identifier" else None
        kind = kind_of(node, variable)
        if variable is not None and kind != "slot":
            return Argued(self.value(node), kind)
        return Argued(self.slot(node), kind, alterable=variable is not None and variable.alterable)

    def statement(self, node: Node) -> None:
        """Lower a statement into the current block."""
        handler = self.shared.statements.get(node.type)
        if handler is None or self.depth >= DEPTH:
            self.unknown(node, "syntax")
        else:
            self.depth += 1
            handler(self, node)
            self.depth -= 1
        self.free_register = self.floor

    # Variables

    def variable(self, name: str) -> Variable | None:
        """The local variable of that name that is seen here."""
        for scope in reversed(self.scopes):
            found = scope.names.get(name)
            if found is not None:
                return found
        return None

    def declare(
        self,
        name: str,
        *,
        reference: bool = False,
        builtin: str = "",
        pointer: bool = False,
        type_: bool = False,
        constant: bool = False,
        cell: bool = False,
    ) -> Variable:
        """A new variable in the innermost block. `type_`: a type or enumerator, which is never a place. `cell`: it always is one."""
        survey = self.shared.survey
        known = self.scopes[-1].names.get(name)  # in another branch of an `#if`
        if known is not None and (known.reference, known.type, known.path) == (reference, type_, ()):
            return known
        changes = name in survey.assigned and not reference and not builtin and not pointer
        number = register = NO_REGISTER
        placed = survey.addressed if constant else survey.placed
        if cell or (not type_ and (name in placed or (changes and not constant))):
            number = self.new_cell(name)
        else:
            self.free_register = max(self.floor, self.free_register)
            register = self.register()
            self.floor = register + 1
        found = Variable(name, register, number, reference=reference, builtin=builtin, type_=type_)
        found.constant = constant
        self.scopes[-1].names[name] = found
        return found

    def new_cell(self, name: str) -> int:
        """The number of a new cell. Its name is its own: where there are several `x`, they are `x`, `x#1`, …."""
        number = len(self.cells)
        self.cells.append(f"{name}#{number}" if name in self.cell_names else name)
        self.cell_names.add(name)
        return number

    def write(self, node: Node, variable: Variable, src: int) -> None:
        """Give a variable a value, or what it refers to."""
        if variable.register != NO_REGISTER:
            self.move(node, variable.register, src)
        else:
            self.with_cell(StoreCell(*self.place(node), variable.cell, src))

    def held(self, node: Node, variable: Variable) -> int:
        """What a variable holds: its value, or the slot that it refers to."""
        if variable.register != NO_REGISTER:
            return variable.register
        dst = self.register()
        self.with_cell(LoadCell(*self.place(node), dst, variable.cell))
        return dst

    def of_variable(self, node: Node, variable: Variable, want: Want) -> int:
        """What is wanted of a variable."""
        if variable.raw:
            return self.held(node, variable)
        if variable.reference:
            return self.given(node, self.held(node, variable), want)
        if variable.register == NO_REGISTER and want == "slot":
            dst = self.register()
            self.with_cell(CellSlot(*self.place(node), dst, variable.cell))
            return dst
        if want == "effect":
            return variable.register
        held = self.held(node, variable)
        return self.given(node, held, want) if want == "own" else held

    def with_cell(self, op: LoadCell | StoreCell | CellSlot) -> None:
        """Emit an operation on a cell; the numbers of free cells are known when all own ones are."""
        if op.cell < 0:
            self.late.append(op)
        self.emit(op)

    def settle_cells(self) -> None:
        """Number the free cells, which come after all own ones."""
        own = len(self.cells)
        for op in self.late:
            if isinstance(op, MakeLambda):
                op.captures = tuple(own + free_cell(cell) if cell < 0 else cell for cell in op.captures)
            else:
                op.cell = own + free_cell(op.cell)

    # Blocks of the source

    def open(self) -> None:
        """A block of the source begins."""
        self.free_register = max(self.free_register, self.floor)
        self.scopes.append(Scope(self.floor))

    def close(self, node: Node) -> None:
        """It ends: its objects do."""
        scope = self.scopes[-1]
        if not self.ends():
            self.end_objects(node, [scope])
        self.scopes.pop()
        self.floor = scope.floor
        self.free_register = self.floor

    def ends(self) -> bool:
        """Whether the block has just been left."""
        return bool(self.ops) and isinstance(self.ops[-1], (Return, Raise, Break, Continue))

    def end_objects(self, node: Node, scopes: Sequence[Scope], but: Variable | None = None) -> None:
        """The variables of these blocks end, but the one that is returned."""
        ending = [variable for scope in scopes for variable in scope.objects if variable is not but]
        if len(ending) > _ENDING:
            self.unknown(node, "language", "the end of many objects")
            return
        if registers := [self.of_variable(node, variable, "slot") for variable in ending]:
            self.emit(EndScope(*self.place(node), tuple(registers)))


def free_cell(number: int) -> int:
    """What stands for free cell `number` while the own ones are not counted."""
    return -number - 2


def _broken(node: Node) -> bool:
    """Whether the parser did not understand something right below a node."""
    return any(child.is_error or (child.is_missing and child.type != ";") for child in node.children)
