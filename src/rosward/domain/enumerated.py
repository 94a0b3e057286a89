# SPDX-License-Identifier: Apache-2.0
"""Which whole numbers know a type by its name, so that they are no other number that is as great?"""

from __future__ import annotations

from typing import TypeVar, final

T = TypeVar("T", bound="_Typed")


class _Typed(int):
    """A whole number that knows its type; what is computed from it is a plain number."""

    def __new__(cls: type[T], number: int, named: str) -> T:
        made = super().__new__(cls, number)
        made.named = named
        return made

    named: str

    def of(self: T, number: int) -> T:
        """Another number of the same type."""
        return self.__class__(number, self.named)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, _Typed):
            return self.__class__ is other.__class__ and self.named == other.named and int(self) == int(other)
        return int(self) == other

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return int.__hash__(self)

    def __reduce__(self) -> tuple[type, tuple[int, str]]:
        return self.__class__, (int(self), self.named)


def same_number(left: object, right: object) -> bool:
    """Whether two constants are equal to an operator, which asks for no type: `case` of an enumerator where a byte is asked."""
    return int(left) == int(right) if isinstance(left, _Typed) and isinstance(right, _Typed) else bool(left == right)


@final
class Enumerated(_Typed):
    """The number of an enumerator, which knows its enumeration by the dotted name."""

    @property
    def enumeration(self) -> str:
        """Which one that is."""
        return self.named


@final
class Whole(_Typed):
    """A number of the type `uint8_t` or `int8_t`: a character to a stream, and of that type to overloads."""
