# SPDX-License-Identifier: Apache-2.0
"""What is followed in haste, that is with less precision where nothing is created, and what may depend on that.

Where something is created that does, the process is followed anew, without haste in the parts to blame: keys of callbacks, or `MAIN_BODY`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import final

from rosward.engine.budget import MAIN_BODY, BeginAnewError


@final
class Haste:
    """Which parts of a process are followed in haste, and what may depend on them."""

    __slots__ = ("_doubted", "careful", "early", "hides", "hurried", "in_loops", "on", "open", "relied")

    def __init__(self, careful: frozenset[str] | None) -> None:
        self.on = careful is not None  # something is followed in haste where it creates nothing,
        self.careful = careful or frozenset()  # but for these parts
        self.in_loops = self.on and MAIN_BODY not in self.careful
        self.hurried: frozenset[str] = frozenset()  # what was followed so
        # by what the main body creates surely, what was followed so before
        self.relied: dict[object, frozenset[str]] = {}
        self.hides = False  # something unknown was done in haste, which may be to create something
        self.open = 0  # how often something was created, or a program started, that is not wholly known
        self.early = False  # a loop of the main body was followed so
        # the addresses at which callbacks wrote that were followed so, and those that read what they wrote: which of the former
        self._doubted: dict[int, frozenset[str]] = {}

    def note_loop(self) -> None:
        """A loop of the main body was followed in haste."""
        self.early = True
        self.hurried |= {MAIN_BODY}

    def note_creation(self, key: object, *, exact: bool, in_main: bool, early: bool) -> None:
        """Something new is created; raises where it may depend on haste.

        `key`: what tells it from others; `exact`: it is wholly known and surely created; `in_main`: by the main body;
        `early`: in a loop of it that is followed in haste.
        """
        parts: frozenset[str] = frozenset()
        if in_main:
            parts = parts.union(*self._doubted.values())
        if early or self.early:
            parts |= {MAIN_BODY}
        if parts and not exact:
            raise BeginAnewError(parts)
        if parts and key is not None and in_main:
            self.relied[key] = parts

    def behind(self, addresses: Iterable[int]) -> frozenset[str]:
        """Which parts wrote there in haste, or read what such a part had written."""
        if not self._doubted:
            return frozenset()
        return frozenset().union(*(self._doubted[a] for a in self._doubted.keys() & set(addresses)))

    def doubt(self, addresses: Iterable[int], parts: frozenset[str]) -> None:
        """What stands there may depend on how these parts were followed."""
        for address in addresses:
            self._doubted[address] = self._doubted.get(address, parts) | parts
