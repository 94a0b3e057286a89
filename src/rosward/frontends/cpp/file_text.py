# SPDX-License-Identifier: Apache-2.0
"""What is known of a file before macros, and what became of it under some?"""

from __future__ import annotations

from typing import final

from rosward.frontends.cpp.branches import directives, guard
from rosward.frontends.cpp.clean import cleaned
from rosward.frontends.cpp.macros import Macro, Macros
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.tokens import NAME


@final
class SourceLines:
    """A file as it is on disk, cleaned."""

    __slots__ = ("file", "found", "guard", "lines", "names")

    def __init__(self, file: str, text: str) -> None:
        self.file = file
        self.lines = cleaned(text).split("\n")
        self.found = directives(self.lines)
        self.guard = guard(self.lines, self.found)
        self.names = frozenset(NAME.findall("\n".join(self.lines)))


@final
class Result:
    """What became of a file where the macros were these: `seen` are the ones at its beginning that it could look at."""

    __slots__ = ("changes", "names", "prepared", "seen")

    def __init__(
        self, prepared: Prepared, names: frozenset[str], seen: Macros, changes: list[tuple[str, Macro | None]]
    ) -> None:
        self.prepared = prepared
        self.names = names
        self.seen = seen
        self.changes = changes
