# SPDX-License-Identifier: Apache-2.0
"""How is something tried that may take all time and memory? In a process of its own, which has bounds and cannot hurt the tests.

    apart(lambda: len("x" * 10**12))  ->  Ended(value=None, error='… MemoryError')
    apart(lambda: 1 + 1)              ->  Ended(value=2, error='')

The process is a fork, so that nothing is imported anew for each of many tests, nor any model of a library that all of them use.
"""

from __future__ import annotations

import json
import math
import os
import resource
import select
import signal
import tempfile
import time
import traceback
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, Final, NamedTuple

import rosward
from hostile.fuzz import GOOD, GOOD_LAUNCH
from rosward.deployment.request import Request

SECONDS: Final = 60.0
HANGING: Final = 1_800.0
"""So long may it wait for what never comes; how long the work takes is counted in time of the processor."""
MEGABYTES: Final = 3_000


class Ended(NamedTuple):
    """What the work gave, as JSON can hold it; or why it gave nothing."""

    value: Any
    error: str
    seconds: float
    megabytes: int


def apart(work: Callable[[], object], *, seconds: float = SECONDS, megabytes: int = MEGABYTES) -> Ended:
    """Do the work in a process of its own, with `seconds` of the processor's time, and `megabytes` of memory beside the stack that is reserved."""
    _have_models_read()
    read, write = os.pipe()
    start = time.monotonic()
    child = os.fork()
    if child == 0:
        _work(work, write, seconds, megabytes)
    os.close(write)
    told = bytearray()
    late = False
    while True:
        left = start + HANGING - time.monotonic()
        if left <= 0 or not select.select([read], [], [], left)[0]:
            late = True
            os.kill(child, signal.SIGKILL)
            break
        piece = os.read(read, 1 << 20)
        if not piece:
            break
        told += piece
    os.close(read)
    _, status, usage = os.wait4(child, 0)
    spent = usage.ru_utime + usage.ru_stime
    size = usage.ru_maxrss // 1024
    if late or (os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU):
        return Ended(None, f"not done after {spent:g} seconds of the processor", spent, size)
    if not told:
        return Ended(None, f"ended by signal or exit: {status}", spent, size)
    value, error = json.loads(told)
    return Ended(value, error, spent, size)


@cache
def _have_models_read() -> None:
    """What a run has from the run before."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "good.py").write_text(GOOD, encoding="utf-8")
        (Path(folder) / "good.launch.xml").write_text(GOOD_LAUNCH, encoding="utf-8")
        for launched in (False, True):
            rosward.extract(folder, request=Request(all_launch=launched))


def _work(work: Callable[[], object], write: int, seconds: float, megabytes: int) -> None:
    limit = (megabytes + 1_500) << 20
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), resource.RLIM_INFINITY))
    try:
        told = json.dumps([work(), ""])
    except BaseException:
        told = json.dumps([None, traceback.format_exc(limit=-12)])
    try:
        with os.fdopen(write, "w", encoding="utf-8") as file:
            file.write(told)
    finally:
        os._exit(0)
