# SPDX-License-Identifier: Apache-2.0
"""The operations of C++ that make values and change what stands somewhere: assignment, copies, construction, the parts of a value."""

from __future__ import annotations

from typing import Literal, final

from rosward.ir.core import NO_REGISTER
from rosward.ir.cpp_calls import Argued, Kind
from rosward.ir.op import Block, Op
from rosward.records import NamedTuple

__all__ = [
    "Assign",
    "Braces",
    "Construct",
    "Convert",
    "Copy",
    "Destructure",
    "EndScope",
    "Form",
    "Initialise",
    "MemberInit",
    "Narrow",
    "StaticLocal",
    "Step",
]


Form = Literal["default", "paren", "brace", "copy", "brace-copy"]
"""How something is initialised: `T x;`, `T x(a)`, `T x{a}`, `T x = a`, `T x = {a}`."""


@final
class Assign(Op):
    """slot operator src, for `=`, `+=`, …; dst = the slot (NO_REGISTER: not asked for). An object stays where it is and changes.

    `kind`: what src is as an argument (`Argued`). `seen` leaves in register `static` the type that the reference, or the pointer, to the object
    is declared with.
    """

    __slots__ = ("dst", "kind", "operator", "seen", "slot", "src", "static")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        operator: str,
        slot: int,
        src: int,
        *,
        kind: Kind = "value",
        seen: Block | None = None,
        static: int = NO_REGISTER,
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.kind = kind
        self.operator = operator
        self.slot = slot
        self.src = src
        self.seen: Block = seen if seen is not None else []
        self.static = static

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.seen,) if self.seen else ()


@final
class Step(Op):
    """`++` and `--` of a slot; dst = the slot where `prefix`, else the value before."""

    __slots__ = ("dst", "operator", "prefix", "slot")

    def __init__(self, line: int, column: int, dst: int, operator: str, slot: int, *, prefix: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.slot = slot
        self.prefix = prefix


@final
class Copy(Op):
    """dst = a copy of the value at the slot `src`, for a variable of its own: objects by value are copied, pointers are not followed.

    `type`: of an object of a class that derives from this one, what belongs to this one.
    """

    __slots__ = ("dst", "src", "type")

    def __init__(self, line: int, column: int, dst: int, src: int, type_: int = NO_REGISTER) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.type = type_


@final
class Convert(Op):
    """dst = src as a value of a type. `kind`: 'init' of a variable or parameter of that type, 'value' of one by value, 'static', 'dynamic' or
    'const' for a cast; 'buffer': `char * p = s`, which leads to the first character of the array at the slot `src`. 'wrapped': a number
    below zero as one of an unsigned type; 'size': the same where what stands in `type`, which was asked for its size, is of a library;
    'again': what is at the slot `src` begins again where the type ends; 'placed': what `new (p) T` makes, in the slot `type`.
    """

    __slots__ = ("dst", "kind", "src", "type")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        src: int,
        type_: int,
        kind: Literal["init", "value", "static", "dynamic", "const", "buffer", "wrapped", "size", "again", "placed"],
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.type = type_
        self.kind = kind


@final
class Construct(Op):
    """dst = a new value of a type: `T x(a, b)`, `T{a}`, `T x;`, what `new T(a)` makes before its address is taken.

    `local`: it is that of a variable of a block, which has ended where the same call comes to its declaration again.
    """

    __slots__ = ("arguments", "dst", "form", "local", "type")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        type_: int,
        arguments: tuple[Argued, ...],
        form: Form,
        *,
        local: bool = False,
    ) -> None:
        super().__init__(line, column)
        self.local = local
        self.dst = dst
        self.type = type_
        self.arguments = arguments
        self.form = form


class MemberInit(NamedTuple):
    """One of `: Base(a), field_{b}`. `name` is the one word that is written, '' for a qualified name or a template.

    `type` is computed by `type_body` where it is no field; `body` computes the arguments. `pack`: the type is a pack of bases.
    """

    name: str
    type_body: Block
    type: int
    body: Block
    arguments: tuple[Argued, ...]
    form: Form
    pack: bool = False


@final
class Initialise(Op):
    """The beginning of each constructor: bases, then fields as they are declared, each by its `MemberInit`, else by its own initialiser.

    Where a `MemberInit` names the class itself, that constructor does it all.
    """

    __slots__ = ("members",)

    def __init__(self, line: int, column: int, members: tuple[MemberInit, ...]) -> None:
        super().__init__(line, column)
        self.members = members

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return tuple(block for member in self.members for block in (member.type_body, member.body))


@final
class Narrow(Op):
    """Register `before` was read at `slot`; an `Assume` made `src` of it: so that stands there, unless it holds something else by now."""

    __slots__ = ("before", "slot", "src")

    def __init__(self, line: int, column: int, slot: int, before: int, src: int) -> None:
        super().__init__(line, column)
        self.slot = slot
        self.before = before
        self.src = src


@final
class Destructure(Op):
    """dsts = the parts of src (`auto [a, b] = …`), or their slots (`auto & [a, b]`); `src` is a slot."""

    __slots__ = ("dsts", "slot", "src")

    def __init__(self, line: int, column: int, dsts: tuple[int, ...], src: int, *, slot: bool) -> None:
        super().__init__(line, column)
        self.dsts = dsts
        self.src = src
        self.slot = slot


@final
class Braces(Op):
    """dst = `{a, b}`, for whoever makes something of it; with `names`, of designated initialisers (`{.a = 1}`), '' for others."""

    __slots__ = ("dst", "items", "names")

    def __init__(
        self, line: int, column: int, dst: int, items: tuple[Argued, ...], names: tuple[str, ...] = ()
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.items = items
        self.names = names


@final
class StaticLocal(Op):
    """dst = the slot of a `static` variable of a function; the first time, `body` runs and leaves its value in register `result`."""

    __slots__ = ("body", "dst", "result")

    def __init__(self, line: int, column: int, dst: int, body: Block, result: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.body = body
        self.result = result

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body,)


@final
class EndScope(Op):
    """The variables in these registers (values, or slots of cells) end, last first: the destructors of those that are objects run."""

    __slots__ = ("variables",)

    def __init__(self, line: int, column: int, variables: tuple[int, ...]) -> None:
        super().__init__(line, column)
        self.variables = variables
