# SPDX-License-Identifier: Apache-2.0
"""How is one repository analysed in a process of its own, and what is known of it, whatever happens?

    analysed_apart(job.line())    ->    the content of its part, or b"" where what is there already still holds

This is the task that executors run, in threads, processes or on other machines. It neither raises for anything in the repository nor computes itself.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import signal
import subprocess
import sys
import threading
from typing import Any, Final

from rosward.confined import isolated
from rosward.records import NamedTuple
from rosward.safe import printable
from rosward.surveying.identity import identity
from rosward.surveying.job import Job, job_of
from rosward.surveying.part import LARGEST, Part, failed

__all__ = ["SAME", "OtherRoswardError", "analysed_apart"]

SAME: Final = b""
_LONGEST_LINE: Final = 10_000
_FAULTS: Final = frozenset({"SIGSEGV", "SIGILL", "SIGFPE", "SIGBUS", "SIGABRT"})
"""Signals by which a process ends that did something wrong; what else kills it comes from outside."""


class OtherRoswardError(Exception):
    """This worker has another rosward, or another Python, than whoever asked."""


class _End(NamedTuple):
    """How the process ended: its status, negative for a signal, seconds of processor time, and whether it was we who ended it."""

    status: int
    cpu: float
    expired: bool


def analysed_apart(line: str) -> bytes:
    """Do a job. Raises OtherRoswardError."""
    job = job_of(line)
    if job.identity != identity():
        raise OtherRoswardError("a worker has another version of rosward or Python; install the same on all machines")
    output, end = _run(job)
    said = _said(output)
    if said.get("same"):
        return SAME
    return _part(job, said, output, end).stored()


def _run(job: Job) -> tuple[bytes, _End]:
    process = subprocess.Popen(
        isolated("rosward.surveying.one"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=os.path.abspath(os.sep),  # noqa: PTH100
        start_new_session=True,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    expired = threading.Event()

    def stop() -> None:
        expired.set()
        _kill(process)

    timer = threading.Timer(job.bounds.wall, stop)
    timer.daemon = True
    timer.start()
    try:
        with contextlib.suppress(BrokenPipeError):
            process.stdin.write(f"{job.line()}\n".encode())
            process.stdin.flush()
        output = process.stdout.read(LARGEST + _LONGEST_LINE)
        if len(output) > LARGEST:
            _kill(process)
        status, cpu = _waited(process)
    finally:
        timer.cancel()
        _kill(process)
        process.stdout.close()
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
    return output, _End(status, cpu, expired.is_set())


def _waited(process: subprocess.Popen[bytes]) -> tuple[int, float]:
    """Its status, and its seconds of processor time."""
    if sys.platform == "win32":
        return process.wait(), 0.0
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def _kill(process: subprocess.Popen[bytes]) -> None:
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            if sys.platform == "win32":
                process.kill()
            else:
                os.killpg(process.pid, signal.SIGKILL)


def _said(output: bytes) -> dict[str, Any]:
    """All that the lines of the process say; `body` is where what follows them begins."""
    said: dict[str, Any] = {}
    start = 0
    while "length" not in said:
        line, mark, _ = output[start : start + _LONGEST_LINE].partition(b"\n")
        try:
            told = json.loads(line) if mark else None
        except ValueError:  # it was killed while it wrote, or something else writes there
            told = None
        if not isinstance(told, dict):
            break
        said |= told
        start += len(line) + 1
    return {**said, "body": start}


def _part(job: Job, said: dict[str, Any], output: bytes, end: _End) -> Part:
    key = str(said.get("key", ""))
    body = output[said["body"] :]
    if len(body) == said.get("length") and hashlib.sha256(body).hexdigest() == said["sha256"]:
        return Part(key, end.cpu, said["peak"], body)
    state, reason, fault, lasting = _why(job, said, output, end)
    return failed(job, state, reason, key=key if lasting else "", fault=fault, cpu=end.cpu)


def _why(job: Job, said: dict[str, Any], output: bytes, end: _End) -> tuple[str, str, bool, bool]:
    """State, reason, whether rosward failed, and whether another analysis would end in the same way."""
    name = signal.Signals(-end.status).name if end.status < 0 else ""
    if end.expired:
        return "timeout", f"it took more than {job.bounds.wall:,.0f} seconds", False, True
    if name == "SIGXCPU":
        return "timeout", f"it took more than {job.bounds.seconds:,} seconds of processor time", False, True
    if "failed" in said:
        return "failed", printable(str(said["failed"])), bool(said.get("fault")), True
    if len(output) > LARGEST:
        return "failed", f"its result is larger than {LARGEST // 2**20:,} MB", False, True
    if name in _FAULTS:
        return "failed", f"rosward was killed ({name}); please report it", True, True
    if name:
        return "failed", f"it was killed ({name}); the memory of the machine may be exhausted", False, False
    return "failed", f"the process ended with status {end.status}", True, False
