# SPDX-License-Identifier: Apache-2.0
"""How are many tasks run by whatever executor there is, each to its end?

    for repository, stored in outcomes(executor, tasks, stop):    as they end, in any order

No more tasks are handed over than may wait. A worker that is lost costs a task another attempt, and after several its repository a row; an executor
that is lost ends the survey, which goes on from there when it is run again.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future
from itertools import islice
from queue import SimpleQueue
from typing import Final

from rosward.records import NamedTuple
from rosward.surveying.apart import OtherRoswardError
from rosward.surveying.repositories import Repository, SurveyError

__all__ = ["Lost", "LostExecutorError", "Outcome", "outcomes"]

_WAITING: Final = 2_000
"""Tasks that are handed over at a time."""
_ATTEMPTS: Final = 3


class LostExecutorError(Exception):
    """The executor is gone, or takes no more tasks."""


class Lost(NamedTuple):
    """Why there is no outcome."""

    why: str


Outcome = bytes | Lost
_Waiting = dict["Future[bytes]", tuple[Repository, str, int]]


def outcomes(
    executor: Executor, work: Callable[[str], bytes], tasks: Iterable[tuple[Repository, str]]
) -> Generator[tuple[Repository, Outcome], None, None]:
    """What `work` gives for the text of each task. Raises SurveyError where no worker can do any, LostExecutorError."""
    waiting: _Waiting = {}
    ended: SimpleQueue[Future[bytes]] = SimpleQueue()
    remaining = iter(tasks)

    def hand_over(repository: Repository, text: str, attempt: int) -> None:
        future = _submitted(executor, work, text)
        waiting[future] = (repository, text, attempt)
        future.add_done_callback(ended.put)

    try:
        while True:
            for repository, text in islice(remaining, _WAITING - len(waiting)):
                hand_over(repository, text, 1)
            if not waiting:
                return
            future = ended.get()
            repository, text, attempt = waiting.pop(future)
            outcome = _outcome(future)
            if isinstance(outcome, Lost) and attempt < _ATTEMPTS:
                hand_over(repository, text, attempt + 1)
            else:
                yield repository, outcome
    finally:
        for future in waiting:
            future.cancel()


def _submitted(executor: Executor, work: Callable[[str], bytes], text: str) -> Future[bytes]:
    try:
        return executor.submit(work, text)
    except Exception as error:  # executors of others raise what they like
        raise LostExecutorError(f"{type(error).__name__}: {error}" if str(error) else type(error).__name__) from error


def _outcome(future: Future[bytes]) -> Outcome:
    try:
        return future.result()
    except OtherRoswardError as error:
        raise SurveyError(str(error)) from error
    except ImportError as error:
        raise SurveyError(f"a worker cannot load rosward ({error}); install it on all machines") from error
    except (CancelledError, BrokenExecutor) as error:
        raise LostExecutorError(str(error) or "its tasks were cancelled") from error
    except Exception as error:  # the machine of a worker is gone, or out of processes, memory, files …
        return Lost(f"{type(error).__name__}: {error}" if str(error) else type(error).__name__)
