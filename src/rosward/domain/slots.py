# SPDX-License-Identifier: Apache-2.0
"""Values of languages in which a variable has an address: pointers, the slots that they lead to, types, overloads.

An object is a `Ref`, by value and by reference alike, for where it stands is what it is. `Pointer` tells a pointer from the object.

    Lamp lamp;              Ref(7)                        std::shared_ptr<Lamp> p;    Pointer(Ref(7))
    int & n = lamp.n;       Slot(Ref(7), 'field', 'n')    int * p = &lamp.n;          Pointer(Slot(Ref(7), 'field', 'n'))
"""

from __future__ import annotations

from typing import Literal, final

from rosward.domain.compound import Record
from rosward.domain.enumerated import Enumerated
from rosward.domain.values import Const, Function, Value
from rosward.ir.core import CharText

__all__ = ["Enumerated", "Overloads", "Owner", "Pointer", "Slot", "SlotKind", "TypeOf", "is_char_text"]

SlotKind = Literal["cell", "field", "item", "entry", "reverse"]
"""What a slot is a part of."""


Owner = Literal["", "unique", "shared"]


def is_char_text(value: Value) -> bool:
    """Whether a value is a literal, or a copy of one."""
    return isinstance(value, Const) and type(value.value) is CharText


@final
class Pointer(Record):
    """A pointer, smart pointer or iterator that leads to an object (`Ref`) or a `Slot`. A null pointer is `NONE`.

    `owner`: whether it owns what it leads to, alone or with others, as far as that shows.
    """

    __slots__ = ("owner", "target")

    def __init__(self, target: Value, owner: Owner = "") -> None:
        self.target = target
        self.owner = owner

    def fields(self) -> tuple[Value, Owner]:
        """In the order of the constructor."""
        return self.target, self.owner


@final
class Slot(Record):
    """Where a value stands that is no object: in the cell `base`, in field `key` of the object `base`, or as element `key` (a value) of it.

    An iterator of a map leads to its 'entry': the pair of a key and what stands under it; a 'reverse' iterator runs from the end. The base of
    a character is the slot of its string, or the string itself.
    """

    __slots__ = ("base", "key", "kind")

    def __init__(self, base: Value, kind: SlotKind, key: Value | str | None) -> None:
        self.base = base
        self.kind = kind
        self.key = key

    def fields(self) -> tuple[Value, SlotKind, Value | str | None]:
        """In the order of the constructor."""
        return self.base, self.kind, self.key


@final
class TypeOf(Record):
    """A type that no class of the program is: builtin (`int`, `pointer` of its argument), or of a library (`std.vector`), by its dotted name.

    A type of a library without arguments is an `External`, so that `std_msgs.msg.String` is the same value in every language.
    """

    __slots__ = ("arguments", "name")

    def __init__(self, name: str, arguments: tuple[Value, ...]) -> None:
        self.name = name
        self.arguments = arguments

    def fields(self) -> tuple[str, tuple[Value, ...]]:
        """In the order of the constructor."""
        return self.name, self.arguments


@final
class Overloads(Record):
    """Functions of one name, of which a call chooses: `receiver` is the object of a member function, `types` the template arguments given."""

    __slots__ = ("functions", "name", "receiver", "types")

    def __init__(
        self, name: str, functions: tuple[Function, ...], receiver: Value | None, types: tuple[Value, ...]
    ) -> None:
        self.name = name
        self.functions = functions
        self.receiver = receiver
        self.types = types

    def fields(self) -> tuple[str, tuple[Function, ...], Value | None, tuple[Value, ...]]:
        """In the order of the constructor."""
        return self.name, self.functions, self.receiver, self.types

    def of(self, receiver: Value | None) -> Overloads:
        """The same of another object."""
        return Overloads(self.name, self.functions, receiver, self.types)

    def only(self, functions: tuple[Function, ...]) -> Overloads:
        """Some of them."""
        return Overloads(self.name, functions, self.receiver, self.types)
