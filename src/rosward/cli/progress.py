# SPDX-License-Identifier: Apache-2.0
"""What does somebody see while the analysis goes on?"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rosward.pipeline import Progress


class ProgressLine:
    """A progress line on a terminal, for work that takes longer than a moment."""

    def __init__(self, *, shown: bool) -> None:
        self._shown = shown and sys.stderr.isatty()
        self._stream = sys.__stderr__ or sys.stderr  # what is drawn here is no part of what the command says
        self._drawn = False

    def __enter__(self) -> Progress:
        return self._tell

    def __exit__(self, *_: object) -> None:
        if self._drawn:
            print("\r\x1b[K", end="", file=self._stream, flush=True)

    def _tell(self, what: str, done: int, count: int) -> None:
        if self._shown and count > 20 and (done % 10 == 0 or done == count):
            self._drawn = True
            print(f"\r\x1b[K{what} {done}/{count}", end="", file=self._stream, flush=True)
