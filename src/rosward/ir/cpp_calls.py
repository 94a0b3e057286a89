# SPDX-License-Identifier: Apache-2.0
"""The calls of C++, and what is done for each of several things."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, final

from rosward.ir.core import NO_REGISTER
from rosward.ir.op import Block, Op
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.ir.program import Code

__all__ = ["Argued", "Default", "Elements", "Invoke", "InvokeMember", "Kind", "MakeLambda", "Placed", "Spread"]


Kind = Literal["value", "slot", "result", "constant", "moved", "forwarded", "pack"]


class Argued(NamedTuple):
    """One argument of a call: of kind 'value' (an rvalue that nobody else has), 'slot' (an lvalue), 'result' (of a call or cast: one or the
    other), 'constant' (a variable that is so), 'moved' (an lvalue that may be moved from), 'forwarded' (what it was for the
    caller), or 'pack' (a parameter pack, spread here). `number`: the arithmetic type that it has as it is written, other than `int` and `double`; ''
    where that does not show. `alterable`: it is a variable that is surely not constant. `items`: of what kind the items of a pack
    are; 'pack' where that is not known.
    """

    register: int
    kind: Kind = "value"
    number: str = ""
    alterable: bool = False
    items: Kind = "pack"


@final
class Elements(Op):
    """dst = what `for (… : src)` runs through; `slot`: the slots of the elements, for a loop variable that is a reference. `src` is a slot."""

    __slots__ = ("dst", "slot", "src")

    def __init__(self, line: int, column: int, dst: int, src: int, *, slot: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.slot = slot


@final
class Invoke(Op):
    """dst = func(arguments…). `func` holds what a `Name` gave, a value that can be called, or a type (which makes one of it).

    The result of a function that returns a reference is the slot; with `copied`, a copy of what stands there. An argument that is a call itself
    is of kind 'value' also where that gave a slot.
    """

    __slots__ = ("arguments", "copied", "dst", "func")

    def __init__(
        self, line: int, column: int, dst: int, func: int, arguments: tuple[Argued, ...], *, copied: bool = False
    ) -> None:
        super().__init__(line, column)
        self.copied = copied
        self.dst = dst
        self.func = func
        self.arguments = arguments


@final
class InvokeMember(Op):
    """dst = obj.name<types…>(arguments…); `obj` is a slot. With `scope`, a register with a class: `obj.Base::name(…)`, which is not virtual.

    `copied` as for `Invoke`. `constant`: the object is constant as it is seen here. `given`: as what, as of `Argued.kind`. `seen` leaves in
    register `static` the type that the object, or the pointer to it, is declared with; it is run where that makes a difference.
    """

    __slots__ = ("arguments", "constant", "copied", "dst", "given", "name", "obj", "scope", "seen", "static", "types")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        obj: int,
        name: str,
        arguments: tuple[Argued, ...],
        *,
        types: tuple[int, ...] | None = None,
        scope: int = NO_REGISTER,
        copied: bool = False,
        constant: bool = False,
        seen: Block | None = None,
        static: int = NO_REGISTER,
        given: str = "slot",
    ) -> None:
        super().__init__(line, column)
        self.given = given
        self.constant = constant
        self.seen: Block = seen if seen is not None else []
        self.static = static
        self.copied = copied
        self.dst = dst
        self.obj = obj
        self.name = name
        self.arguments = arguments
        self.types = types
        self.scope = scope

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.seen,) if self.seen else ()


@final
class MakeLambda(Op):
    """dst = a lambda. `copies` are registers with what it captures by copy, `this` (register 0) included: they come before its arguments.

    `captures` gives, for each free cell of `code`, the number of the cell in the enclosing code: what it captures by reference.
    """

    __slots__ = ("captures", "code", "copies", "dst")

    def __init__(
        self, line: int, column: int, dst: int, code: Code, copies: tuple[int, ...], captures: tuple[int, ...]
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.code = code
        self.copies = copies
        self.captures = captures


@final
class Spread(Op):
    """dst = the items of a pack after `body` ran for each, in register `item`, with its result in register `result`: `(f(args), …)`.

    With an operator, the results are folded: from the left, after `init` where there is one, or from the `right`, before it. Several packs run
    side by side.
    """

    __slots__ = ("body", "dst", "init", "items", "operator", "packs", "result", "right")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        packs: tuple[int, ...],
        items: tuple[int, ...],
        body: Block,
        result: int,
        *,
        operator: str = "",
        init: int = NO_REGISTER,
        right: bool = False,
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.packs = packs
        self.items = items
        self.body = body
        self.result = result
        self.operator = operator
        self.init = init
        self.right = right

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body,)


Placing = Literal["found", "copied", "kept", "taken"]


@final
class Placed(Op):
    """dst = where what is in `src` stands; of a `pack`, each of its items.

    'found': a value that stands nowhere gets a place; 'copied': a copy gets one, wherever the value stands; 'kept': one that lasts longer than
    the call; 'taken': copies, without a place.
    """

    __slots__ = ("dst", "how", "pack", "src")

    def __init__(self, line: int, column: int, dst: int, src: int, how: Placing, *, pack: bool = False) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.how = how
        self.pack = pack


@final
class Default(Op):
    """Where register `dst` (a parameter) got no argument, run `body`, which writes it."""

    __slots__ = ("body", "dst")

    def __init__(self, line: int, column: int, dst: int, body: Block) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.body = body

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body,)
