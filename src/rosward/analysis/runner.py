# SPDX-License-Identifier: Apache-2.0
"""Where does each process run: here, or in a worker? Or is known what it adds?

Small sources are done here: workers begin where much is left after a moment's work. By then, most models that processes need are there, and
every worker has them. What comes out does not depend on where.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from functools import partial
from types import TracebackType
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.outcome import Done, Outcome, Outset, Task, outcome_of
from rosward.analysis.read import SourcesRead
from rosward.analysis.seen import Seen
from rosward.deadline import Deadline
from rosward.effects.entry import Entry
from rosward.findings import Finding, Findings
from rosward.location import Place
from rosward.rules import KILLED
from rosward.source.disk import by_how, looks_of, saw_elsewhere, watching

if TYPE_CHECKING:
    from rosward.analysis.known import Known
    from rosward.analysis.workers import Lost, Workers
    from rosward.cache.store import Store

__all__ = ["Runner"]

_MOMENT: Final = 0.5
"""Seconds of work here, after which workers begin."""

_FEW: Final = 2
"""So many processes are not worth a worker."""


def _behind(done: Callable[[int], None], before: int, number: int) -> None:
    done(before + number)


def _known(store: Store, read: SourcesRead, outset: Outset) -> Known | None:
    from rosward.analysis.known import Known
    from rosward.analysis.models_state import models_state
    from rosward.cache.version import version_key

    models = models_state(read.models)
    return None if models is None else Known(store, version_key(), models, read, outset)


@final
class Runner:
    """Runs processes, by so many workers, those of which the store knows nothing. To be closed."""

    def __init__(self, read: SourcesRead, outset: Outset, jobs: int = 1, store: Store | None = None) -> None:
        self._read = read
        self._outset = outset
        self._jobs = jobs
        self._moment = Deadline(_MOMENT)
        self._workers: Workers | None = None
        self._known = None if store is None else _known(store, read, outset)
        self._exits = ExitStack()
        self.lost: set[str] = set()
        """The files of processes whose workers died."""

    def __enter__(self) -> Runner:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        self._exits.close()
        if self._known is not None and _error is None:
            self._known.keep()

    def one(self, entry: Entry) -> Outcome:
        """What a process of the sources adds: what is known of it, or it runs here."""
        return self.all([Task(entry)], lambda _: None)[0]

    def all(self, tasks: Sequence[Task], done: Callable[[int], None]) -> list[Outcome]:
        """What each of several processes adds, none of which depends on another. `done` is told how many there are so far."""
        known = (
            {} if self._known is None else {n: o for n, t in enumerate(tasks) if (o := self._known.of(t)) is not None}
        )
        left = [task for number, task in enumerate(tasks) if number not in known]
        found: list[Outcome] = []
        for number, task in enumerate(left):
            if self._are_worth_it(len(left) - number):
                found += self._by_workers(left[number:], partial(_behind, done, len(known) + number))
                break
            done(len(known) + number)
            found.append(self._here(task))
        rest = iter(found)
        return [known[number] if number in known else next(rest) for number in range(len(tasks))]

    def _here(self, task: Task) -> Outcome:
        return self._done(task, outcome_of(self._outset, task))

    def _done(self, task: Task, done: Done) -> Outcome:
        if self._known is not None:
            self._known.done(task, done.questions, done.outcome)
        return done.outcome

    def _are_worth_it(self, left: int) -> bool:
        if self._jobs < _FEW or left < _FEW:
            return False
        if self._workers is not None:
            return True
        if not self._moment.is_over():
            return False
        from rosward.analysis.workers import can_fork

        return can_fork()

    def _by_workers(self, tasks: Sequence[Task], done: Callable[[int], None]) -> list[Outcome]:
        from rosward.analysis.outcome_form import TASK
        from rosward.analysis.workers import Workers
        from rosward.cache.codec import text

        if self._workers is None:
            # what all of them would read, each for itself, and this process after them
            planned = self._read.plan.entries if tasks[0].configuration is None else [task.entry for task in tasks]
            for name in dict.fromkeys(entry.program for entry in planned if entry.program):
                self._read.sources.program(name)
            self._workers = self._exits.enter_context(Workers(self._work, self._jobs))
        answers = self._workers.all([text(TASK.write(task)) for task in tasks], done)
        return [self._outcome(task, answer) for task, answer in zip(tasks, answers, strict=True)]

    def _outcome(self, task: Task, answer: bytes | Lost | None) -> Outcome:
        from rosward.analysis.outcome_form import ANSWER
        from rosward.analysis.workers import Lost
        from rosward.cache.codec import loaded

        if answer is None:
            return self._here(task)
        if isinstance(answer, Lost):
            return self._lost(task.entry, answer)
        found = ANSWER.read(loaded(answer))
        self._read.sources.read_elsewhere(found.python, found.cpp, found.findings)
        self._read.library.findings.update(found.stubs)
        saw_elsewhere(looks_of(found.looks))
        return self._done(task, Done(found.outcome, found.questions))

    def _lost(self, entry: Entry, lost: Lost) -> Outcome:
        """The process of a worker that died is not run again here: what killed the worker would kill everything."""
        self.lost.add(entry.file)
        message = f"{entry.label or entry.file} was not analysed: {KILLED} ({lost.why})"
        module = None if entry.program else self._read.sources.module(entry.file)
        entered = frozenset[str]() if module is None else frozenset({module.code.key})
        nothing = Seen(entry.program, entered, frozenset(), frozenset(), frozenset(), (), (), ())
        return Outcome((), (Finding("RW201", message, Place(entry.file)),), False, nothing)

    def _work(self, task: bytes) -> bytes:
        """In a worker: the answer to a task. What the worker has read before, it has told before."""
        from rosward.analysis.outcome_form import ANSWER, TASK, Answer
        from rosward.cache.codec import loaded, text

        sources, library = self._read.sources, self._read.library
        python, cpp, findings, stubs = (
            set(sources.python_files),
            set(sources.cpp_files),
            Findings(sources.findings),
            Findings(library.findings),
        )
        with watching() as trace:
            outcome, questions = outcome_of(self._outset, TASK.read(loaded(task)))
        return text(
            ANSWER.write(
                Answer(
                    outcome,
                    questions,
                    {file: lines for file, lines in sources.python_files.items() if file not in python},
                    {file: lines for file, lines in sources.cpp_files.items() if file not in cpp},
                    tuple(f for f in sources.findings if f not in findings),
                    tuple(f for f in library.findings if f not in stubs),
                    by_how(trace.seen),
                )
            )
        )
