# SPDX-License-Identifier: Apache-2.0
"""Values of languages in which a variable has an address: pointers, the slots that they lead to, types, overloads.

An object is a `Ref`, by value and by reference alike, for where it stands is what it is. `Pointer` tells a pointer from the object.

    Lamp lamp;              Ref(7)                        std::shared_ptr<Lamp> p;    Pointer(Ref(7))
    int & n = lamp.n;       Slot(Ref(7), 'field', 'n')    int * p = &lamp.n;          Pointer(Slot(Ref(7), 'field', 'n'))
"""

from __future__ import annotations

from typing import Literal, NamedTuple, final

from rosward.domain.compound import Record
from rosward.domain.values import Const, Function, Value
from rosward.ir.core import CharText

__all__ = ["Enumerated", "Overloads", "Pointer", "Slot", "SlotKind", "TypeOf", "is_char_text"]

SlotKind = Literal["cell", "field", "item", "entry", "reverse"]
"""What a slot is a part of."""


@final
class Enumerated(int):
    """The number of an enumerator, which knows its enumeration by the dotted name; what is computed from it is a plain number."""

    def __new__(cls, number: int, enumeration: str) -> Enumerated:  # noqa: D102 - see the class
        made = super().__new__(cls, number)
        made.enumeration = enumeration
        return made

    enumeration: str

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Enumerated):
            return self.enumeration == other.enumeration and int(self) == int(other)
        return int(self) == other

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return int.__hash__(self)

    def __reduce__(self) -> tuple[type, tuple[int, str]]:
        return Enumerated, (int(self), self.enumeration)


def is_char_text(value: Value) -> bool:
    """Whether a value is a literal, or a copy of one."""
    return isinstance(value, Const) and type(value.value) is CharText


class Pointer(Record, NamedTuple("_Pointer", [("target", "Value")])):
    """A pointer, smart pointer or iterator that leads to an object (`Ref`) or a `Slot`. A null pointer is `NONE`."""

    __slots__ = ()


class Slot(
    Record,
    NamedTuple("_Slot", [("base", "Value"), ("kind", "SlotKind"), ("key", "Value | str | None")]),
):
    """Where a value stands that is no object: in the cell `base`, in field `key` of the object `base`, or as element `key` (a value) of it.

    An iterator of a map leads to its 'entry': the pair of a key and what stands under it; a 'reverse' iterator runs from the end. The base of
    a character is the slot of its string, or the string itself.
    """

    __slots__ = ()


class TypeOf(Record, NamedTuple("_TypeOf", [("name", "str"), ("arguments", "tuple[Value, ...]")])):
    """A type that no class of the program is: builtin (`int`, `pointer` of its argument), or of a library (`std.vector`), by its dotted name.

    A type of a library without arguments is an `External`, so that `std_msgs.msg.String` is the same value in every language.
    """

    __slots__ = ()


class Overloads(
    Record,
    NamedTuple(
        "_Overloads",
        [
            ("name", "str"),
            ("functions", "tuple[Function, ...]"),
            ("receiver", "Value | None"),
            ("types", "tuple[Value, ...]"),
        ],
    ),
):
    """Functions of one name, of which a call chooses: `receiver` is the object of a member function, `types` the template arguments given."""

    __slots__ = ()
