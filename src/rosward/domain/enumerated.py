# SPDX-License-Identifier: Apache-2.0
"""Which number is the value of an enumerator?"""

from __future__ import annotations

from typing import final


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
