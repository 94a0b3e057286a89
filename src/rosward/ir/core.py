# SPDX-License-Identifier: Apache-2.0
"""The operations that any imperative language needs and that run straight on: values, locals, cells, fields, elements, operators, calls.

Law: every concrete class is final and pure data; a variant is a field; so `type(op)` decides everything.
An operation reads registers (small integers, local to one `Code`) and writes at most one, `dst`. Control flow is structured:
the control operations (`control.py`) hold blocks, and a block is a list of operations that run in order.

    x = y.b + 1          LoadAttr r2 r1 'b'; Const r3 1; Binary r0 + r2 r3      (x is register 0, y register 1)

Names are resolved when lowering: a local variable is a register, a variable shared with an inner function is a cell (numbered per `Code`).
What an operation means is up to the language of the code (`Code.language`, `engine/machine.py`). What only one language has stands in a
module of its own (`python.py`).

The door for C++: references to places (a local, a field, an element) are values that an operation of its own makes, reads and writes; copies by
value, conversions to the type of a variable and the end of a scope (destructors) are operations of its own, and template arguments are
arguments of a call of a kind of their own (`Argument.kind`). Each is a class beside those of `python.py`, with its handler
in the table of the language.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal, final

from rosward.ir.op import Op

if TYPE_CHECKING:
    from rosward.ir.program import Code

Constant = None | bool | int | float | complex | str | bytes
"""What a `Const` can hold; `...` is the global name `Ellipsis`."""


@final
class CharText(str):
    """The text of a literal, which is a pointer to characters and no string object until one is made of it; what is computed from it is none.

    It is a text like any other wherever that is not asked: two constants are one whether their texts know it or not.
    """

    __slots__ = ()

    @property  # type: ignore[misc]
    def __class__(self) -> type[str]:  # type: ignore[override]  # only `type()` tells
        return str

    def __reduce__(self) -> tuple[type, tuple[str]]:
        return CharText, (str.__str__(self),)


NO_REGISTER: Final = -1


@final
class Const(Op):
    """dst = value."""

    __slots__ = ("dst", "value")

    def __init__(self, line: int, column: int, dst: int, value: Constant) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.value = value


@final
class Move(Op):
    """dst = src."""

    __slots__ = ("dst", "src")

    def __init__(self, line: int, column: int, dst: int, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src


@final
class LoadCell(Op):
    """dst = cell number `cell` of this `Code` (own cells first, then free ones)."""

    __slots__ = ("cell", "dst")

    def __init__(self, line: int, column: int, dst: int, cell: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.cell = cell


@final
class StoreCell(Op):
    """Cell number `cell` = src. `narrowing`: what it holds already, narrowed by an `Assume`; no assignment of the program."""

    __slots__ = ("cell", "narrowing", "src")

    def __init__(self, line: int, column: int, cell: int, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.cell = cell
        self.src = src
        self.narrowing = narrowing


@final
class LoadAttr(Op):
    """dst = obj.name."""

    __slots__ = ("dst", "name", "obj")

    def __init__(self, line: int, column: int, dst: int, obj: int, name: str) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.obj = obj
        self.name = name


@final
class StoreAttr(Op):
    """obj.name = src.

    `narrowing`: what the instance holds already, narrowed by an `Assume`; no assignment of the program, so that no property or
    `__setattr__` runs. Of a property that only returns an attribute of the instance, that is narrowed; nothing happens where the instance
    itself has no such attribute (a method, a class attribute).
    """

    __slots__ = ("name", "narrowing", "obj", "src")

    def __init__(self, line: int, column: int, obj: int, name: str, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.obj = obj
        self.name = name
        self.src = src
        self.narrowing = narrowing


@final
class LoadItem(Op):
    """dst = obj[index]; a slice is made by the `slice` intrinsic first."""

    __slots__ = ("dst", "index", "obj")

    def __init__(self, line: int, column: int, dst: int, obj: int, index: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.obj = obj
        self.index = index


@final
class StoreItem(Op):
    """obj[index] = src. `narrowing`: what a list or dict holds already, narrowed by an `Assume`; no assignment of the program."""

    __slots__ = ("index", "narrowing", "obj", "src")

    def __init__(self, line: int, column: int, obj: int, index: int, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.obj = obj
        self.index = index
        self.src = src
        self.narrowing = narrowing


@final
class Unary(Op):
    """dst = operator src; operator is one of `not - + ~`."""

    __slots__ = ("dst", "operator", "src")

    def __init__(self, line: int, column: int, dst: int, operator: str, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.src = src


@final
class Binary(Op):
    """dst = left operator right; `inplace` for the augmented assignment."""

    __slots__ = ("dst", "inplace", "left", "operator", "right")

    def __init__(
        self, line: int, column: int, dst: int, operator: str, left: int, right: int, inplace: bool = False
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.left = left
        self.right = right
        self.inplace = inplace


@final
class Compare(Op):
    """dst = left operator right; operator is one of `== != < <= > >= is is-not in not-in`. Chains are lowered to several."""

    __slots__ = ("dst", "left", "operator", "right")

    def __init__(self, line: int, column: int, dst: int, operator: str, left: int, right: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.left = left
        self.right = right


ArgumentKind = Literal["positional", "star", "keyword", "doublestar"]


@final
class Argument:
    """One argument as written: kind is 'positional', 'star', 'keyword' (with its name) or 'doublestar'."""

    __slots__ = ("kind", "name", "register")

    def __init__(self, kind: ArgumentKind, register: int, name: str = "") -> None:
        self.kind = kind
        self.register = register
        self.name = name

    @property
    def is_spread(self) -> bool:
        """Whether it gives any number of arguments."""
        return self.kind in ("star", "doublestar")


@final
class Call(Op):
    """dst = func(arguments…). `simple` holds the registers where all arguments are positional, else None; `spreads`: `*` or `**` gives some."""

    __slots__ = ("arguments", "dst", "func", "simple", "spreads")

    def __init__(self, line: int, column: int, dst: int, func: int, arguments: tuple[Argument, ...]) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.func = func
        self.arguments = arguments
        simple = all(a.kind == "positional" for a in arguments)
        self.simple: tuple[int, ...] | None = tuple(a.register for a in arguments) if simple else None
        self.spreads = not simple and any(a.is_spread for a in arguments)


@final
class MakeFunction(Op):
    """dst = a function object; defaults are registers for the last positional parameters, kwdefaults pairs (name, register).

    `captures` gives, for each free cell of `code`, the number of the cell in the enclosing code.
    """

    __slots__ = ("captures", "code", "defaults", "dst", "kwdefaults")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        code: Code,
        defaults: tuple[int, ...],
        kwdefaults: tuple[tuple[str, int], ...],
        captures: tuple[int, ...],
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.code = code
        self.defaults = defaults
        self.kwdefaults = kwdefaults
        self.captures = captures


@final
class Assume(Op):
    """Narrow register src to the values for which `test` holds (where `sense`) or does not; nothing left: the path is dead.

    test is 'true' (truthiness), 'empty' (of a text or container), 'is', '==', '<', '>' or 'in' against register `other`, or 'isinstance' with
    the class in `other`. Where it is 'decided', src is an operand that decides a `||` or `&&` of C++, and `sense` is its outcome.
    The result is written to dst.
    """

    __slots__ = ("dst", "other", "sense", "src", "test")

    def __init__(self, line: int, column: int, dst: int, src: int, test: str, other: int, sense: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.test = test
        self.other = other
        self.sense = sense
