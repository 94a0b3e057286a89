# SPDX-License-Identifier: Apache-2.0
"""No test here may compute or block for long: each has a few seconds of CPU time, and a time to wait that only what blocks for good uses up."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from types import FrameType

import pytest

_CPU_SECONDS = 5
_BLOCKED_SECONDS = 300


@pytest.fixture(autouse=True)
def _soon() -> Iterator[None]:
    def too_long(_signal: int, _frame: FrameType | None) -> None:
        raise AssertionError(f"took more than {_CPU_SECONDS} seconds of CPU time, or blocked")

    before = {number: signal.signal(number, too_long) for number in (signal.SIGPROF, signal.SIGALRM)}
    signal.setitimer(signal.ITIMER_PROF, _CPU_SECONDS)
    signal.alarm(_BLOCKED_SECONDS)
    yield
    signal.alarm(0)
    signal.setitimer(signal.ITIMER_PROF, 0)
    for number, handler in before.items():
        signal.signal(number, handler)
