# SPDX-License-Identifier: Apache-2.0
"""How is an analysis run in a process of its own, and how does it end, whatever happens?

    await run_job(job, tell)    ->    End('done')

The process has a session of its own, so that it is killed with all that it started. It never looks for modules in the current folder, which
may be the folder that is analysed, nor where PYTHONPATH says.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable
from pathlib import Path

from rosward.confined import isolated
from rosward.server.job import LONGEST_LINE, Job, JobEnd, JobStep, read_line

__all__ = ["run_job"]


async def run_job(job: Job, tell: Callable[[JobStep], None]) -> JobEnd:
    """Do a job in a process of its own; if this is cancelled, the process is killed."""
    process = await asyncio.create_subprocess_exec(
        *isolated("rosward.server.worker"),
        stdin=PIPE,
        stdout=PIPE,
        cwd=Path(job.output).parent,
        limit=LONGEST_LINE,
        start_new_session=True,
    )
    try:
        return await asyncio.wait_for(_talk(process, job, tell), job.limits.seconds)
    except asyncio.TimeoutError:
        return JobEnd("failed", f"The analysis took more than {job.limits.seconds:g} seconds.")
    finally:
        _kill(process)
        await process.wait()


async def _talk(process: Process, job: Job, tell: Callable[[JobStep], None]) -> JobEnd:
    assert process.stdin is not None
    assert process.stdout is not None
    with contextlib.suppress(ConnectionError):
        process.stdin.write(f"{job.line()}\n".encode())
        await process.stdin.drain()
    while line := await _line(process.stdout):
        said = read_line(line)
        if isinstance(said, JobEnd):
            return said
        if said is not None:
            tell(said)
    return _ended_early(await process.wait())


async def _line(stream: asyncio.StreamReader) -> bytes:
    try:
        return await stream.readline()
    except ValueError:  # longer than anything that we write
        return b"\n"


def _ended_early(status: int) -> JobEnd:
    if status == -getattr(signal, "SIGXCPU", 0):
        return JobEnd("failed", "The analysis took too long.")
    if status < 0:
        return JobEnd(
            "failed",
            f"The analysis was killed ({signal.Signals(-status).name}): it may need more memory than is available.",
        )
    return JobEnd("failed", f"The analysis ended with status {status}.")


def _kill(process: Process) -> None:
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            if sys.platform == "win32":
                process.kill()
            else:
                os.killpg(process.pid, signal.SIGKILL)
