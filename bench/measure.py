# SPDX-License-Identifier: Apache-2.0
"""Runs a command, or `rosward extract`, in a process of its own and says what it cost.

    run = measure(["sleep", "1"], seconds=60)
    run.wall, run.cpu, run.peak_mb, run.status

The peak is that of the largest process of the command. Linux counts in it the pages that this process has at the start,
so keep this one small.
"""

from __future__ import annotations

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from facts import Graph, load

MEMORY_LIMIT = 8 * 1024**3
"""Bytes of address space that a measured process may take: beyond it a runaway ends in a MemoryError of its own."""


@dataclass(frozen=True, slots=True)
class Run:
    """What one run of a command cost. `status` is None after the time limit, negative for a signal."""

    status: int | None
    wall: float
    cpu: float
    peak_mb: float
    output: str


@dataclass(frozen=True, slots=True)
class Extraction:
    """One run of `rosward extract`. `trouble` is None, or what went wrong in a way that no input may cause."""

    run: Run
    graph: Graph | None
    trouble: str | None


def _without_results() -> str:
    """A cache folder in which rosward's own models may be, and no result of an earlier run is."""
    folder = _own_folder().name
    for results in Path(folder).glob("results-*"):
        shutil.rmtree(results)
    return folder


@cache
def _own_folder() -> tempfile.TemporaryDirectory[str]:
    """No other bench that runs at the same time has it; it is gone when this one ends."""
    return tempfile.TemporaryDirectory(prefix="rosward-bench-", ignore_cleanup_errors=True)


def measure(command: Sequence[str], *, seconds: float) -> Run:
    """Run `command` for at most `seconds` and return its cost; its output and errors are kept together."""
    expired = threading.Event()
    with tempfile.TemporaryFile() as out:
        start = time.monotonic()
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            env={**os.environ, "ROSWARD_CACHE": _without_results()},
        )
        resource.prlimit(process.pid, resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))

        def stop() -> None:
            expired.set()
            os.killpg(process.pid, signal.SIGKILL)

        timer = threading.Timer(seconds, stop)
        timer.start()
        _, wait_status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        wall = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(wait_status)
        out.seek(0)
        output = out.read().decode(errors="replace")
    return Run(
        status=None if expired.is_set() else process.returncode,
        wall=wall,
        cpu=usage.ru_utime + usage.ru_stime,
        peak_mb=usage.ru_maxrss / 1024,
        output=output,
    )


def extract(paths: Sequence[Path], *, seconds: float = 60, options: Sequence[str] = ()) -> Extraction:
    """Run `rosward extract` with all its default outputs, and read the network.json it wrote."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "rosward", "extract", *map(str, paths), "-o", folder, *options]
        run = measure(command, seconds=seconds)
        written = Path(folder, "network.json")
        graph = load(written) if written.exists() and run.status in (0, 1) else None
    return Extraction(run, graph, _trouble(run, graph))


def _trouble(run: Run, graph: Graph | None) -> str | None:
    """What no input may cause: a time limit, a signal, a traceback, an exit status outside the contract, no result."""
    last = run.output.strip().rpartition("\n")[2]
    if run.status is None:
        return "timeout"
    if "Traceback (most recent call last)" in run.output:
        return f"traceback: {last}"
    if run.status not in (0, 1, 2):
        return f"exit status {run.status}: {last}"
    if graph is None and run.status != 2:
        return f"no network.json: {last}"
    return None
