# SPDX-License-Identifier: Apache-2.0
"""Where are lines printed that have colours on a terminal?

    paper.line(("error", "bold red"), (" RW101", "bold"))        the second of each pair is a style of rich

rich draws them on a terminal. Elsewhere they are plain text, and rich, which is slow to import, is not loaded.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Final, Protocol, TextIO, final

if TYPE_CHECKING:
    from rich.console import Console

__all__ = ["Drawn", "Paper", "Plain", "standard_output"]

_COLOURS_ASKED_FOR: Final = ("FORCE_COLOR", "TTY_COMPATIBLE")
"""Variables by which rich draws also where there is no terminal."""


class Paper(Protocol):
    """What takes lines."""

    def line(self, *parts: tuple[str, str]) -> None:
        """A line of texts with their styles; without any it is empty."""


@final
class Plain:
    """Plain text: no colours, and no line is cut."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def line(self, *parts: tuple[str, str]) -> None:
        """See `Paper`."""
        self._stream.write("".join(text for text, _ in parts) + "\n")


@final
class Drawn:
    """A console of rich."""

    def __init__(self, console: Console) -> None:
        self._console = console

    def line(self, *parts: tuple[str, str]) -> None:
        """See `Paper`."""
        from rich.text import Text

        self._console.print(Text.assemble(*parts), soft_wrap=True)


def standard_output() -> Paper:
    """Standard output, as it wants to be written to."""
    if not sys.stdout.isatty() and not any(os.environ.get(name) for name in _COLOURS_ASKED_FOR):
        return Plain(sys.stdout)
    from rich.console import Console

    return Drawn(Console(soft_wrap=not sys.stdout.isatty()))
