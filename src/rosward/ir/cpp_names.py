# SPDX-License-Identifier: Apache-2.0
"""The operations of C++ that say what something is: names, members, what a pointer leads to, types."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal, final

from rosward.ir.core import NO_REGISTER
from rosward.ir.op import Block, Op
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.ir.symbols import Symbol

__all__ = [
    "AddressOf",
    "CellSlot",
    "Declared",
    "Deref",
    "Item",
    "LocalSymbol",
    "MakeType",
    "Member",
    "Name",
    "Part",
    "Read",
    "TypeOfValue",
    "UnknownValue",
]


class Part(NamedTuple):
    """One part of a qualified name; `arguments` are the registers of its template arguments, None where it is written without."""

    name: str
    arguments: tuple[int, ...] | None = None


@final
class Name(Op):
    """dst = what a name stands for that is no local variable: `a::b<c>::d`, `::d`, or `d` seen from where the code stands.

    A member of `this` included. With `base`, the first part is looked up in the type or namespace in that register (`T::value`).
    `slot`: its slot where it is a variable; without, its value. A function is its overloads, a class, alias or enum its type.
    `designator`: `&Lamp::on`, which of a field is the field of any Lamp.
    """

    __slots__ = ("absolute", "base", "designator", "dst", "parts", "slot")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        parts: tuple[Part, ...],
        *,
        base: int = NO_REGISTER,
        absolute: bool = False,
        slot: bool = False,
        designator: bool = False,
    ) -> None:
        super().__init__(line, column)
        self.designator = designator
        self.dst = dst
        self.parts = parts
        self.base = base
        self.absolute = absolute
        self.slot = slot


@final
class CellSlot(Op):
    """dst = the slot of cell number `cell`: of a local variable that is referred to. A variable that is a reference is read instead."""

    __slots__ = ("cell", "dst")

    def __init__(self, line: int, column: int, dst: int, cell: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.cell = cell


@final
class Member(Op):
    """dst = obj.name, or its slot; `obj` is a slot. `arguments`: those of a template (`obj.template f<T>`).

    `seen` and `static` are as for `InvokeMember`.
    """

    __slots__ = ("arguments", "dst", "name", "obj", "seen", "slot", "static")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        obj: int,
        name: str,
        *,
        arguments: tuple[int, ...] | None = None,
        slot: bool = False,
        seen: Block | None = None,
        static: int = NO_REGISTER,
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.obj = obj
        self.name = name
        self.arguments = arguments
        self.slot = slot
        self.seen: Block = seen if seen is not None else []
        self.static = static

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.seen,) if self.seen else ()


@final
class Item(Op):
    """dst = obj[index], or its slot; `obj` is a slot. `constant` as for `InvokeMember`."""

    __slots__ = ("constant", "dst", "index", "obj", "slot")

    def __init__(
        self, line: int, column: int, dst: int, obj: int, index: int, *, slot: bool = False, constant: bool = False
    ) -> None:
        super().__init__(line, column)
        self.constant = constant
        self.dst = dst
        self.obj = obj
        self.index = index
        self.slot = slot


@final
class Deref(Op):
    """dst = *src, or its slot; `src` is the value of a pointer, smart pointer, iterator or optional."""

    __slots__ = ("dst", "slot", "src")

    def __init__(self, line: int, column: int, dst: int, src: int, *, slot: bool = False) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.slot = slot


@final
class Declared(Op):
    """dst = the type that a field of `this`, or a variable of a class or namespace, is declared with; none where it has none that is written.

    With `obj`: that of a field of what is there, or of what it leads to. With `()` behind the name, what functions of that name return.
    """

    __slots__ = ("dst", "name", "obj")

    def __init__(self, line: int, column: int, dst: int, name: str, obj: int = NO_REGISTER) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.name = name
        self.obj = obj


@final
class AddressOf(Op):
    """dst = &src, where `src` is a slot. What has just been made by `new` is wrapped so as well."""

    __slots__ = ("dst", "src")

    def __init__(self, line: int, column: int, dst: int, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src


@final
class Read(Op):
    """dst = the value at the slot `src`; a value that is no slot is itself."""

    __slots__ = ("dst", "src")

    def __init__(self, line: int, column: int, dst: int, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src


@final
class LocalSymbol(Op):
    """dst = the class or enum that is declared in a function body.

    `names` are those of the body that it mentions, and mean what is in `registers`: the first `types` of them types, constants and packs, the
    others variables that are the same in each call.
    """

    __slots__ = ("dst", "names", "registers", "symbol", "types")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        symbol: Symbol,
        names: tuple[str, ...] = (),
        registers: tuple[int, ...] = (),
        types: int = 0,
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.symbol = symbol
        self.names = names
        self.registers = registers
        self.types = types


@final
class MakeType(Op):
    """dst = a type. `kind`: 'pointer', 'reference', 'array', 'function' of those in `inner`; else the name of a builtin type (`int`, `auto`)."""

    __slots__ = ("dst", "inner", "kind")

    def __init__(self, line: int, column: int, dst: int, kind: str, inner: tuple[int, ...] = ()) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.kind = kind
        self.inner = inner


ELEMENT: Final = "[*]"
UNDER: Final = "[]"
LED: Final = "*"
ARROW: Final = "->"
DOT: Final = "."
CALLED: Final = "()"
NUMBERED: Final = "#"


@final
class TypeOfValue(Op):
    """dst = the type of the value at a slot: `decltype(x)`, `typeid(x)`; with `member`, that of this member of the type in `src`, or of a part
    of what has such a type: of the elements that a loop runs over (ELEMENT), or that stand under an index or key (UNDER), of what a pointer leads to
    (LED), of `.field`, of what `.function()` returns, of `->field` and `->function()`, of the member of a pair or tuple with that number (`#0`)."""

    __slots__ = ("dst", "member", "src")

    def __init__(self, line: int, column: int, dst: int, src: int, member: str = "") -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.member = member


@final
class UnknownValue(Op):
    """dst = something that nobody knows. `cause`: 'macro' (a condition of the preprocessor), 'syntax' (not understood), 'language' (`sizeof`)."""

    __slots__ = ("cause", "dst", "subject")

    def __init__(
        self, line: int, column: int, dst: int, cause: Literal["macro", "syntax", "language"], subject: str
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.cause = cause
        self.subject = subject
