# SPDX-License-Identifier: Apache-2.0
"""The whole survey: repositories to tasks to parts to tables and an overview.

rosward.survey("checkouts", "survey-of-2026", jobs=8)
rosward.survey(paths, "survey-of-2026", executor=client.get_executor())
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import closing, contextmanager
from importlib.util import find_spec
from typing import Final

from rosward.pipeline import Progress, budget_of
from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO, Distro
from rosward.source.exclude import pattern_of
from rosward.surveying.apart import SAME, analysed_apart
from rosward.surveying.executing import Lost, LostExecutorError, Outcome, outcomes
from rosward.surveying.identity import identity
from rosward.surveying.job import Bounds, Job, SurveyOptions
from rosward.surveying.overview import Overview
from rosward.surveying.part import Part, Rows, failed, unpacked
from rosward.surveying.parts import Parts
from rosward.surveying.repositories import (
    Found,
    Repository,
    SurveyError,
    check_output,
    repositories_at,
    repositories_of,
)

__all__ = ["Survey", "SurveyError", "survey"]

Paths = str | os.PathLike[str] | Iterable[str | os.PathLike[str]]

_SHOWN: Final = 20
"""So many repositories without a result are named."""


class Survey(NamedTuple):
    """What a survey gave. `output` is the folder with the tables, `rows` how many each has, `states` how many repositories ended in each state.

    `analysed`: repositories that were analysed in this run; the results of the others were there. `faults`: those in which rosward itself failed.
    `duplicates` and `links` are entries that were left out. `without`: the first repositories without a result, and why.
    """

    output: str
    rows: Mapping[str, int]
    states: Mapping[str, int]
    analysed: int
    faults: int
    duplicates: int
    links: int
    without: tuple[tuple[str, str], ...]

    @property
    def complete(self) -> bool:
        """Whether there is a result of each repository."""
        return not self.states.get("failed") and not self.states.get("timeout")


def survey(
    repositories: Paths,
    output: str | os.PathLike[str] = "rosward-survey",
    *,
    executor: Executor | None = None,
    jobs: int | None = None,
    null: bool = False,
    distro: str = DEFAULT_DISTRO,
    all_launch: bool = False,
    tests: bool = False,
    exclude: Sequence[str] = (),
    assumed: bool = True,
    budget: float = 1.0,
    seconds: int = 600,
    memory: int = 4096,
    retry: bool = False,
    progress: Progress | None = None,
) -> Survey:
    """Analyse many repositories, each in a process of its own, and write one set of tables and an overview.

    Args:
        repositories: a folder, each folder in which is a repository; a file that lists paths; or several paths, called by
            their place below the working directory.
        output: the folder for the tables, the overview, and the parts of which they are made.
        executor: any executor; each of its tasks starts one process and waits for it. By default, `jobs` processes on this machine.
        jobs: processes at a time; by default as many as there are cores. Of no meaning with an executor, which says itself.
        null: whether the paths of a list are separated by NUL characters.
        distro: as for `rosward.extract`, as are `tests`, `exclude` and `assumed`.
        all_launch: analyse what the launch files of a repository start; in one without launch files, its executables.
        budget: multiplies the steps per program.
        seconds: of processor time for one repository.
        memory: megabytes of address space for one repository.
        retry: analyse again what failed or took too long in an earlier run.
        progress: called as the work goes on.

    Raises:
        SurveyError: where the repositories cannot be listed, a worker has another rosward, or a package is missing.
        LostExecutorError: where the executor is gone; what was done is kept, and another run continues.
        OSError: where the output cannot be written; likewise.
        ValueError: where an option has no meaning.

    A run that was stopped, however it was, is continued by another one with the same arguments.
    """
    if find_spec("pyarrow") is None:
        raise SurveyError("survey needs additional packages: pip install 'rosward[survey]'")
    Distro(distro)
    budget_of(budget)
    options = SurveyOptions(distro, all_launch, tests, tuple(pattern_of(e) for e in exclude), assumed, float(budget))
    if seconds < 1 or memory < 1 or (jobs is not None and jobs < 1):
        raise ValueError("seconds, memory and jobs must be at least 1")
    bounds = Bounds(int(seconds), int(memory) * 2**20)
    target = os.fspath(output)
    found = _found(repositories, target, null=null)
    check_output(target, found.repositories)
    run = _Run(found, Parts(target), options, bounds, retry)
    with _executing(executor, jobs) as chosen:
        run.analyse(chosen, progress)
    return run.written(target)


def _found(repositories: Paths, output: str, *, null: bool) -> Found:
    if isinstance(repositories, (str, os.PathLike)):
        return repositories_at(os.fspath(repositories), output, null=null)
    found = repositories_of(repositories, ".")
    if not found.repositories:
        raise SurveyError("there is no repository")
    return found


@contextmanager
def _executing(executor: Executor | None, jobs: int | None) -> Iterator[Executor]:
    """The executor; by default threads, each of which waits for one process at a time."""
    if executor is not None:
        yield executor
        return
    own = ThreadPoolExecutor(jobs or _cores())
    try:
        yield own
    except BaseException:
        own.shutdown(wait=False, cancel_futures=True)
        raise
    own.shutdown()


def _cores() -> int:
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1


class _Run:
    """A survey while it is carried out."""

    def __init__(self, found: Found, parts: Parts, options: SurveyOptions, bounds: Bounds, retry: bool) -> None:
        self._found = found
        self._parts = parts
        self._options = options
        self._bounds = bounds
        self._retry = retry
        self._identity = identity()
        self._lost: dict[Repository, Part] = {}
        self._analysed = 0

    def analyse(self, executor: Executor, progress: Progress | None) -> None:
        """See to it that there is a part of each repository."""
        every = self._found.repositories
        tasks = ((repository, self._job(repository).line()) for repository in every)
        try:
            with closing(outcomes(executor, analysed_apart, tasks)) as ended:
                for done, (repository, outcome) in enumerate(ended, 1):
                    self._take(repository, outcome)
                    if progress is not None:
                        progress("repositories", done, len(every))
        except LostExecutorError as error:
            told = f"the executor stopped ({error}); run the same command again to continue"
            raise LostExecutorError(told) from error

    def _job(self, repository: Repository) -> Job:
        part = self._parts.read(repository.path)
        counts = part is not None and part.counts_for(self._bounds, retry=self._retry) and unpacked(part) is not None
        known = part.key if part is not None and counts else ""
        return Job(repository.path, self._options, self._bounds, self._identity, known)

    def _take(self, repository: Repository, outcome: Outcome) -> None:
        if isinstance(outcome, Lost):
            reason = f"the worker was lost several times ({outcome.why})"
            self._lost[repository] = failed(self._job(repository), "failed", reason)
        elif outcome != SAME:
            self._parts.write(repository.path, outcome)
            self._analysed += 1

    def _read(self, repository: Repository) -> tuple[Part, Rows]:
        part = self._lost.get(repository) or self._parts.read(repository.path)
        rows = None if part is None else unpacked(part)
        if part is None or rows is None:
            raise SurveyError(f"the part of {repository.name} is gone; run the same command again")
        return part, rows

    def written(self, output: str) -> Survey:
        """Write the tables and the overview."""
        from rosward.surveying.tables import Tables

        states: Counter[str] = Counter()
        overview = Overview()
        faults = 0
        without: list[tuple[str, str]] = []
        with Tables(output) as tables:
            for repository in self._found.repositories:
                part, rows = self._read(repository)
                tables.add(repository, part, rows)
                about = overview.add(repository.name, part, rows)
                states[about.state] += 1
                faults += about.fault
                if about.state in ("failed", "timeout") and len(without) < _SHOWN:
                    without.append((repository.name, about.reason or about.state))
        overview.write(output, self._options.text())
        found = self._found
        return Survey(
            output,
            tables.counts(),
            states,
            self._analysed,
            faults,
            found.duplicates,
            found.links,
            tuple(without),
        )
