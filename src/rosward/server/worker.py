# SPDX-License-Identifier: Apache-2.0
"""The process that analyses: reads a job from its input, bounds itself, does it, and tells how it ended.

It is a process of its own so that the server answers while it computes, and so that what goes wrong in it (a limit, a crash, somebody who
cancels) ends it and nothing else. It bounds its memory, its processor time and the size of its files before it looks at what was uploaded.
A second process does nothing but wait, for the end of the analysis or of the server: no thread of Python's could, while one long computation
has the interpreter for itself.
"""

from __future__ import annotations

import contextlib
import os
import select
import signal
import sys
import threading
import traceback
from typing import NoReturn, TextIO

from rosward.confined import bound
from rosward.pipeline import NothingToReadError, UnknownRequestError
from rosward.safe import printable
from rosward.server.analysis import analyse
from rosward.server.job import Job, JobEnd, read_job
from rosward.server.places import UploadRefusedError
from rosward.server.telling import Teller

__all__ = ["main"]


def main() -> None:
    """Do the job that stands in the first line of the input."""
    if sys.platform == "win32":
        threading.Thread(target=_end_with_input, args=(sys.stdin.fileno(),), daemon=True).start()
    else:
        computing = os.fork()
        if computing:
            _watch(computing)
    teller = Teller(_stream_of_its_own())
    job = read_job(sys.stdin.readline())
    limits = job.limits
    bound(limits.memory, int(limits.seconds) + 5, limits.unpacked)
    teller.end(_end_of(job, teller))


def _stream_of_its_own() -> TextIO:
    """The standard output, which nothing else can write to from here on."""
    stream = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return stream


def _watch(computing: int) -> NoReturn:
    """Wait until the analysis ends, and end as it did; or until the server does, and end both.

    The server holds the other end of our input; that it is gone is an event of its own, whether or not all input was read.
    """
    ended, ends = os.pipe()
    os.set_blocking(ends, False)
    signal.set_wakeup_fd(ends, warn_on_full_buffer=False)
    signal.signal(signal.SIGCHLD, lambda _number, _frame: None)
    waiting = select.poll()
    waiting.register(0, 0)  # nothing but the end
    waiting.register(ended, select.POLLIN)
    while True:
        done, status = os.waitpid(computing, os.WNOHANG)
        if done:
            _end_as(status)
        if any(descriptor == 0 for descriptor, _ in waiting.poll()):
            os.killpg(0, signal.SIGKILL)
        os.read(ended, 1)


def _end_as(status: int) -> NoReturn:
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        _no_core()
        with contextlib.suppress(OSError, ValueError):  # SIGKILL has no handler
            signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
    os._exit(os.waitstatus_to_exitcode(status) if os.WIFEXITED(status) else 1)


def _no_core() -> None:
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _end_with_input(descriptor: int) -> None:
    """Where there is no second process."""
    with contextlib.suppress(OSError, ValueError):
        os.read(descriptor, 1)
    os._exit(1)


def _end_of(job: Job, teller: Teller) -> JobEnd:
    try:
        analyse(job, teller)
    except (UploadRefusedError, UnknownRequestError) as error:
        return JobEnd("failed", printable(str(error)))
    except NothingToReadError:
        return JobEnd("failed", "It contains no Python, C++ or launch files.")
    except MemoryError:
        return JobEnd("failed", f"The analysis needs more than {job.limits.memory // 2**20:,} MB of memory.")
    except OSError as error:
        return JobEnd("failed", f"The result cannot be written: {error.strerror or error}.")
    except Exception as error:
        print(printable(traceback.format_exc()).replace("\\x0a", "\n"), file=sys.stderr)  # noqa: T201
        return JobEnd(
            "failed", f"The analysis failed ({type(error).__name__}). This is a bug in rosward. Please report it."
        )
    return JobEnd("done")
