# SPDX-License-Identifier: Apache-2.0
"""Which whole number has a type that shows: in a stream, in overloads?"""

from __future__ import annotations

from typing import final


@final
class Whole(int):
    """A whole number that knows its type, `uint8_t` or `int8_t`; what is computed from it is a plain number."""

    def __new__(cls, number: int, type_: str) -> Whole:  # noqa: D102 - see the class
        made = super().__new__(cls, number)
        made.named = type_
        return made

    named: str

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Whole):
            return self.named == other.named and int(self) == int(other)
        return int(self) == other

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return int.__hash__(self)

    def __reduce__(self) -> tuple[type, tuple[int, str]]:
        return Whole, (int(self), self.named)
