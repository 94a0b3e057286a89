# SPDX-License-Identifier: Apache-2.0
"""What is known of a local variable, a block, a loop and what a function returns, while its body is lowered?"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, final

from rosward.ir.core import NO_REGISTER
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node


class Over(NamedTuple):
    """What a variable begins with, which part of it that is, and the variable that the first name in it meant there; None where that is none."""

    node: Node
    which: tuple[str, ...]
    first: Variable | None


@final
class Variable:
    """A local variable: in a register, or in a cell where something may refer to it.

    `reference`: it holds a slot. `constant`: it is never assigned to, whoever gets it. `alterable`: it is surely not constant.
    `leads_to_constant`: a pointer, through which nothing
    is changed. `builtin`: the arithmetic type that it has. `buffer`: an array of characters, which is kept as a text, and as a value a pointer
    to the first of them. `counts`: it is `auto` of a part of something, which may be a short or unsigned number. `raw`: a type, a constant of a
    template or a pack, which is taken as it is; `pack` tells the last, `type` a type or constant. `path`: it is no variable at all, but another
    name for that (`using std::string;`, `namespace fs = std::filesystem;`), with '' first where that begins with `::`. `written` is the type
    that it is declared with, and what its declarator adds. `over`: where that is `auto`, what it begins with, or the loop runs over. `members`
    are the enumerators of an enum.
    """

    __slots__ = (
        "alterable",
        "buffer",
        "builtin",
        "cell",
        "constant",
        "counts",
        "leads_to_constant",
        "members",
        "name",
        "over",
        "pack",
        "path",
        "raw",
        "reference",
        "register",
        "type",
        "written",
    )

    def __init__(
        self,
        name: str,
        register: int,
        cell: int,
        *,
        reference: bool = False,
        builtin: str = "",
        raw: bool = False,
        pack: bool = False,
        type_: bool = False,
        path: tuple[str, ...] = (),
    ) -> None:
        self.name = name
        self.register = register
        self.cell = cell
        self.reference = reference
        self.builtin = builtin
        self.buffer = False
        self.alterable = False
        self.constant = False
        self.counts = False
        self.leads_to_constant = False
        self.written: tuple[Node, Node | None] | None = None
        self.over: Over | None = None
        self.raw = raw or pack or type_
        self.pack = pack
        self.type = type_
        self.path = path
        self.members: dict[str, Variable] = {}


@final
class Scope:
    """A block: its names, and those of its variables that may be objects, in their order; `floor` is the first register that is free after it."""

    __slots__ = ("floor", "names", "objects")

    def __init__(self, floor: int) -> None:
        self.floor = floor
        self.names: dict[str, Variable] = {}
        self.objects: list[Variable] = []


class Loop(NamedTuple):
    """A loop or `switch` around: how many blocks are outside, what `continue` has to do first, and the register that it sets within a `switch`."""

    scopes: int
    step: Callable[[], None] | None = None
    is_switch: bool = False
    flag: int = NO_REGISTER


class Jumps(NamedTuple):
    """A block with labels that is being lowered: how many loops and blocks are outside, the number of each part, and the registers that say
    from which part on the next turn goes, whether there is one, and what the loop around does behind it.

    `depths`: how many loops are outside of the jumps that were met.
    """

    loops: int
    scopes: int
    numbers: dict[str, int]
    start: int
    going: int
    leaving: dict[str, int]
    depths: list[int]


class Returns(NamedTuple):
    """What a function returns: its type as it is written, whether that is a reference. `plain`: nothing is to be converted."""

    type: Node | None = None
    declarator: Node | None = None
    reference: bool = False
    plain: bool = True

    @classmethod
    def of_descriptor(cls, node: Node) -> Returns:
        """Of `-> T`."""
        type_ = node.child_by_field_name("type")
        return cls.of(type_, node.child_by_field_name("declarator"))

    @classmethod
    def of(cls, type_: Node | None, declarator: Node | None) -> Returns:
        """Of a function with this type before this declarator."""
        reference = declarator is not None and declarator.type in {
            "reference_declarator",
            "abstract_reference_declarator",
        }
        plain = type_ is None or type_.type in {"placeholder_type_specifier", "auto"} or type_.text == b"void"
        return cls(type_, declarator, reference, plain or reference)
