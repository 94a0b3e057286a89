# SPDX-License-Identifier: Apache-2.0
"""What a front end is: it makes the IR of one language out of the text of a file.

Which one reads a file is decided by the file's suffix (`registry.py`); nothing else calls the lowering of a language by name.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, final

from rosward.ir.program import Module
from rosward.records import NamedTuple

__all__ = ["FrontEnd", "FrontendError", "Lower"]


@final
class FrontendError(Exception):
    """A source text that can't be read; kind is 'syntax', 'python2', 'depth' or 'null'."""

    def __init__(self, kind: str, message: str, line: int, column: int) -> None:
        super().__init__(message)
        self.kind = kind
        self.message = message
        self.line = line
        self.column = column


class Lower(Protocol):
    """Makes the IR of a text; raises `FrontendError` where it cannot be read."""

    def __call__(self, text: str, file: str, origins: Sequence[int] = (), name: str = "") -> Module:
        """`file` is what the IR calls the file; `origins` are the lines of it that the lines of a text were made of.

        `name` tells the bodies of a text that is no whole file from those of others (`Code.key`).
        """


class FrontEnd(NamedTuple):
    """The language of its bodies (`Code.language`), the suffixes of its files, and what lowers one."""

    language: str
    suffixes: tuple[str, ...]
    lower: Lower
