# SPDX-License-Identifier: Apache-2.0
"""How does the process that analyses tell how far it is? Ten lines a second at most, whatever the analysis says."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final, TextIO, final

from rosward.server.job import JobEnd, JobStep, line_of_end, line_of_step

__all__ = ["Teller"]

_PAUSE: Final = 0.1


@final
class Teller:
    """Writes lines to the server. It is the `progress` of an extraction."""

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._last = -_PAUSE
        self._what = ""

    def __call__(self, what: str, done: int, count: int) -> None:
        """Tell a step, unless another one of the same kind was told a moment ago."""
        now = self._clock()
        if what != self._what or now - self._last >= _PAUSE:
            self._what, self._last = what, now
            self._write(line_of_step(JobStep(what, done, count)))

    def end(self, end: JobEnd) -> None:
        """Tell how it ended."""
        self._write(line_of_end(end))

    def _write(self, line: str) -> None:
        self._stream.write(line + "\n")
        self._stream.flush()
