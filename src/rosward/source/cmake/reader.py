# SPDX-License-Identifier: Apache-2.0
"""What does whoever interprets a CMakeLists.txt ask of who wants to know something of it?"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol, TypeAlias

from rosward.source.cmake.text import Command

Handler: TypeAlias = Callable[[list[str], Command], None]


class Reader(Protocol):
    """What a reader adds to the interpreter."""

    handlers: Mapping[str, Handler]

    def known(self, name: str) -> str:
        """The value of a variable that CMake itself sets; '' where it sets none."""

    def environment(self, name: str) -> str:
        """The value of an environment variable."""

    def unknown_command(self, name: str) -> bool:
        """Whether a function of that name could be had from elsewhere, and was given to the interpreter."""

    def not_understood(self, arguments: list[str], command: Command) -> None:
        """What becomes of a command that nothing defines."""
