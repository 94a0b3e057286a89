# SPDX-License-Identifier: Apache-2.0
"""The process that analyses one repository: reads its job from its input, bounds itself, and writes what it found to its output.

    {"key": "9f86…"}                             as soon as the state of the sources is known: what follows depends on it
    {"peak": 81264640, "length": …, "sha256": "…"}   at the end, and then so many bytes: the body of the part

Or `{"key": "9f86…", "same": true}`, where that is what its job knows already, or `{"failed": …}`. It ends when its input does: then whoever asked is
gone.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, Final

from rosward._version import __version__
from rosward.confined import bound
from rosward.surveying.job import Job, job_of
from rosward.surveying.part import Repository, key_of, pack
from rosward.surveying.state import state_of

if TYPE_CHECKING:
    from rosward.pipeline import Result

__all__ = ["main"]

_LARGEST_FILE: Final = 2**28
"""Bytes of a file that it writes, which is one of rosward's own cache."""
_NO_MEMORY: Final = (
    "can't start new thread",
    "failed to map segment",
    "Cannot allocate memory",
    "cannot allocate memory",
)


def main() -> None:
    """Do the job that stands in the first line of the input."""
    out = _stream_of_its_own()
    job = job_of(sys.stdin.readline())
    threading.Thread(target=_end_with_input, daemon=True).start()
    bound(job.bounds.memory, job.bounds.seconds, _LARGEST_FILE, grace=5)
    _do(job, out)
    out.flush()
    os._exit(0)


def _stream_of_its_own() -> BinaryIO:
    """The standard output, which nothing else can write to from here on."""
    stream = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return stream


def _end_with_input() -> None:
    with contextlib.suppress(OSError):
        os.read(0, 1)
    os._exit(1)


def _say(out: BinaryIO, **what: object) -> None:
    out.write(json.dumps(what).encode() + b"\n")
    out.flush()


def _do(job: Job, out: BinaryIO) -> None:
    too_large = f"it needs more than {job.bounds.memory // 2**20:,} MB of memory"
    try:
        key = key_of(job, state_of(job.path))
    except (OSError, ValueError) as error:
        _say(out, failed=f"cannot be read: {getattr(error, 'strerror', None) or error}")
        return
    if key == job.known:
        _say(out, key=key, same=True)
        return
    _say(out, key=key)
    try:
        body = _body(job)
    except Exception as error:
        if _is_of_memory(error):
            _say(out, failed=too_large)
        else:
            from rosward.guard import where

            _say(out, failed=f"rosward failed ({type(error).__name__} in {where(error)}); please report it", fault=True)
        return
    if body is None:
        _say(out, failed=too_large)
        return
    _say(out, peak=_peak(), length=len(body), sha256=hashlib.sha256(body).hexdigest())
    out.write(body)


def _is_of_memory(error: Exception) -> bool:
    """Whether the bound on memory is behind an error: of Python, of a thread whose stack has no place, of a library that cannot be loaded."""
    told = str(error)
    return isinstance(error, MemoryError) or any(words in told for words in _NO_MEMORY)


def _body(job: Job) -> bytes | None:
    """The body of the part; None where memory ran out on a piece of the sources."""
    from rosward.pipeline import NothingToReadError
    from rosward.rules import INTERNAL_ERROR
    from rosward.surveying.rows import rows_of

    try:
        result = _analysed(job)
    except NothingToReadError:
        reason = "there is no Python, C++ or launch file"
        return pack(Repository("empty", reason, False, True, None, 0, 0, 0, 0, __version__, job.options.text()), {})
    faults = [finding for finding in result.findings if finding.code == INTERNAL_ERROR]
    if any("MemoryError" in finding.message for finding in faults):
        return None
    network = result.network
    row = Repository(
        "ok",
        None,
        bool(faults),
        result.complete,
        "launch files" if result.systems else "executables",
        network.files,
        network.lines,
        network.processes,
        result.launch_files,
        __version__,
        job.options.text(),
    )
    return pack(row, rows_of(result))


def _analysed(job: Job) -> Result:
    from rosward.deployment.request import Request
    from rosward.pipeline import budget_of, extract

    options = job.options

    def analysed(request: Request) -> Result:
        return extract(
            job.path,
            distro=options.distro,
            tests=options.tests,
            exclude=options.exclude,
            assumed=options.assumed,
            budget=budget_of(options.budget),
            request=request,
        )

    if options.all_launch:
        result = analysed(Request(all_launch=True))
        if result.systems:
            return result
    return analysed(Request())  # there is no launch file, so nothing else says what is started


def _peak() -> int | None:
    """The largest resident memory of this process; what its parent had when it was started counts in getrusage, but not here."""
    with contextlib.suppress(OSError, ValueError, StopIteration):
        lines = Path("/proc/self/status").read_text(encoding="ascii", errors="replace").splitlines()
        return 1024 * int(next(line for line in lines if line.startswith("VmHWM:")).split()[1])
    return None
