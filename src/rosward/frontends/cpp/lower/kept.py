# SPDX-License-Identifier: Apache-2.0
"""Registers that are not used again: the engine keeps what a cast says by the register of its result.

f(static_cast<int>(3)); f(std::string())      what the first call is given stands in a register of its own
"""

from __future__ import annotations

from typing import final

__all__ = ["Kept"]


@final
class Kept:
    """A set of numbers, of which generated code has thousands side by side."""

    __slots__ = ("_behind",)

    def __init__(self) -> None:
        self._behind: dict[int, int] = {}  # by each, a number behind it; what lies between is kept, too

    def keep(self, number: int) -> None:
        """It is not free any more."""
        self._behind.setdefault(number, number + 1)

    def free_from(self, first: int) -> int:
        """The first number from there on that is free."""
        number = first
        while number in self._behind:
            number = self._behind[number]
        while first != number:  # who asks next is led past all of them at once
            self._behind[first], first = number, self._behind[first]
        return number
