# SPDX-License-Identifier: Apache-2.0
"""Is it known what a process adds, though something has changed since?

    talker.py asks: find("demo.names", 0, "talker.py"), module("demo/names.py"), read("demo", "config/names.yaml"), …
    the same answers as when it was run   ->  what it added then; another file that changed does not matter

A process is asked for by its entry and by how it is started and run; what it asked of the sources (`engine/sources/reads.py`) is kept with
what it added, and a digest of the answers. These are asked again of the sources as they are now.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.models_state import stub_name
from rosward.analysis.outcome_form import ENTRY, OUTCOME, QUESTIONS, configuration_form
from rosward.cache.codec import MalformedError, loaded, text
from rosward.domain.values import ModuleValue
from rosward.engine.libraries.written import NotWrittenError
from rosward.engine.sources.remembered import ask, depends_on_the_machine
from rosward.source import disk

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rosward.analysis.outcome import Outcome, Outset, Task
    from rosward.analysis.read import SourcesRead
    from rosward.cache.store import Store
    from rosward.engine.sources.reads import Question

__all__ = ["Known"]

_KIND: Final = "process"


@final
class Known:
    """What a store knows of the processes of some sources."""

    def __init__(self, store: Store, version: str, models: list[list[str]], read: SourcesRead, outset: Outset) -> None:
        self._store = store
        self._read = read
        self._answers: dict[Question, bytes] = {}
        budget = {**outset.budget._asdict(), "watched": sorted(outset.budget.watched)}
        environment = {name: str(value.value) for name, value in sorted(read.library.environment.items())}
        self._how = [version, outset.distro.value, budget, environment, models]
        self._configuration = outset.configuration
        self._done: list[tuple[bytes, tuple[Question, ...], Outcome]] = []

    def of(self, task: Task) -> Outcome | None:
        """What a process adds, where that is known and still so."""
        question = self._question(task)
        if question is None:
            return None
        found = self._store.kept(_KIND, question, partial(self._accepted, disk.digest(question)))
        if found is None:
            return None
        questions, outcome = found
        for name, *rest in questions:  # what it reads beyond the workspace is told as well
            if name == "module":
                self._read.sources.module(str(rest[0]))
        if self._read.models:
            self._find_models(questions)
        return outcome

    def done(self, task: Task, questions: tuple[Question, ...], outcome: Outcome) -> None:
        """A process was run: it is to be kept."""
        if not any(map(depends_on_the_machine, outcome.findings)):
            question = self._question(task)
            if question is not None:
                self._done.append((question, questions, outcome))

    def keep(self) -> None:
        """Keep what was done. Whoever watches the disk must not have seen two states of it."""
        kept = self._done
        told = [self._told(questions) for _, questions, _ in kept]
        if disk.is_torn():
            return
        for (question, questions, outcome), answers in zip(kept, told, strict=True):
            head = text([disk.digest(question), answers, QUESTIONS.write(questions)])
            self._store.keep(_KIND, question, head + b"\n" + text(OUTCOME.write(outcome)))
        self._done.clear()

    def _question(self, task: Task) -> bytes | None:
        """None where there are no words for how the process is started."""
        entry, configuration = task
        try:
            default = configuration_form(self._configuration) if configuration is None else None
            return text([*self._how, ENTRY.write(entry), configuration_form(configuration), default])
        except NotWrittenError:
            return None

    def _find_models(self, questions: Iterable[Question]) -> None:
        """What is wrong with the stubs that a process asks for is told as if it had asked."""
        library = self._read.library
        for name, *rest in questions:
            if name == "find":
                wanted, level, file = str(rest[0]), int(rest[1]), str(rest[2])
                library.find(wanted, level, ModuleValue(-1, stub_name(file), file) if file else None)
            elif name == "model":
                library.load_again(str(rest[0]))

    def _accepted(self, question: str, answer: bytes) -> tuple[tuple[Question, ...], Outcome] | None:
        head, _, outcome = answer.partition(b"\n")
        try:
            document = loaded(head)
            if document.__class__ is not list or len(document) != 3 or document[0] != question:
                return None
            questions = QUESTIONS.read(document[2])
            return (questions, OUTCOME.read(loaded(outcome))) if self._told(questions) == document[1] else None
        except (
            MalformedError,
            AttributeError,
            IndexError,
            KeyError,
            TypeError,
            ValueError,
        ):  # or a question that has no meaning
            return None

    def _told(self, questions: Iterable[Question]) -> str:
        """A digest of the answers as they are now."""
        known = self._answers
        parts: list[bytes] = []
        for question in questions:
            if question[0] == "model":
                continue  # which models there are, is a part of how a process is run
            answer = known.get(question)
            if answer is None:
                answer = known[question] = repr(ask(self._read.sources, question)).encode("utf-8", "surrogatepass")
            parts += (b"%d " % len(answer), answer)
        return disk.digest(b"".join(parts))
