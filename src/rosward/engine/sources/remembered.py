# SPDX-License-Identifier: Apache-2.0
"""What does an analysis know from the one before it, in the same process of the machine?

    with remembering(memory):
        extract("my_ws")          runs every process of the sources
        extract("my_ws")          runs those that read a file which has changed

A process is known by its entry and by how it is started. What it asked of the sources (`reads.py`) is asked again, and where the answers are the
same, so is what it did. A file is lowered again where its bytes are others. `touched` are the files that were looked at since `begin`, as places
name them, `*/NAME` for a file that is installed under that name, and `PROGRAM` where a program in C++ was asked for.
Nothing is remembered unless somebody asks for it, so that one analysis alone keeps nothing that it does not need.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection, Hashable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, Final, TypeVar, final

from rosward.ir.program import MODEL_PREFIX
from rosward.models.interfaces import message_name
from rosward.records import NamedTuple
from rosward.rules import INTERNAL_ERROR, KILLED, TIME_LIMIT
from rosward.source.yaml_documents import YamlDocuments

if TYPE_CHECKING:
    from rosward.engine.sources.found import Sources
    from rosward.engine.sources.reads import Question
    from rosward.findings import Finding
    from rosward.ir.program import Module

__all__ = ["PROGRAM", "Lowered", "Memory", "ask", "depends_on_the_machine", "memory_here", "remembering"]


PROGRAM: Final = "**"
T = TypeVar("T")


class Lowered(NamedTuple):
    """A file that was lowered: its module, what was told of it, and how many lines it has."""

    module: Module | None
    findings: tuple[Finding, ...]
    lines: int


class _Kept(NamedTuple):
    """What a process did, and the answers on which that stands."""

    questions: tuple[Question, ...]
    answers: bytes
    run: Any


@final
class Memory:
    """What is known of processes and files. Only one analysis at a time uses it."""

    def __init__(self) -> None:
        self._runs: dict[Hashable, _Kept] = {}
        self._lowered: dict[str, tuple[str, Lowered]] = {}
        self._answers: dict[Question, bytes] = {}
        self._derived: dict[int, tuple[object, dict[Hashable, Any]]] = {}
        """What was made of what a process did, or of a file that was lowered, by the identity of that."""
        self.touched: set[str] = set()
        self.used: set[Hashable] = set()
        self._read: set[str] = set()
        self.documents = YamlDocuments()
        self.programs: object = None
        """What is known of the programs in C++, for whoever links them."""
        self.ran = 0
        """How many processes were run."""

    def __len__(self) -> int:
        return len(self._runs) + len(self._lowered)

    def begin(self) -> None:
        """Another part of the work begins: what it touches and uses is noted apart."""
        self.touched, self.used = set(), set()

    def sources_changed(self) -> None:
        """The sources are read anew: no answer holds any more."""
        self._answers.clear()
        self._read.clear()

    def keep_only(self, used: Collection[Hashable]) -> None:
        """Forget all processes but these, and the files that were not read since the sources changed."""
        self._runs = {key: kept for key, kept in self._runs.items() if key in used}
        self._lowered = {file: kept for file, kept in self._lowered.items() if file in self._read}
        there = {id(kept.run) for kept in self._runs.values()}
        there.update(id(lowered.module) for _, lowered in self._lowered.values())
        self._derived = {key: known for key, known in self._derived.items() if key in there}

    def lowered(self, file: str, content: str, lower: Callable[[], Lowered]) -> Lowered:
        """The file of this content as it was lowered before, else as it is now."""
        self._read.add(file)
        known = self._lowered.get(file)
        if known is None or known[0] != content:
            known = self._lowered[file] = content, lower()
        return known[1]

    def derived(self, of: object, key: Hashable, make: Callable[[], T]) -> T:
        """What was made before of what a process did, or of a lowered file, which decides it together with the key; else it is made now."""
        _, known = self._derived.setdefault(id(of), (of, {}))
        if key not in known:
            known[key] = make()
        found: T = known[key]
        return found

    def run(self, key: Hashable, sources: Sources, run: Callable[[], tuple[Any, tuple[Question, ...] | None]]) -> Any:
        """What a process did, if what it asked has the same answers; else it is run. Without questions nothing is kept of it."""
        self.used.add(key)
        known = self._runs.get(key)
        if known is not None and self._told(known.questions, sources) == known.answers:
            return known.run
        self._runs.pop(key, None)
        found, questions = run()
        self.ran += 1
        if questions is not None:
            self._runs[key] = _Kept(questions, self._told(questions, sources), found)
        return found

    def touch(self, question: Question) -> None:
        """A file is looked at, if the question is about one."""
        if question[0] == "module":
            self.touched.add(str(question[1]))
        elif question[0] == "program":
            self.touched.add(PROGRAM)
        elif question[0] == "read":
            self.touched.add(f"*/{str(question[2]).rpartition('/')[2]}")

    def _told(self, questions: tuple[Question, ...], sources: Sources) -> bytes:
        told = hashlib.blake2b(digest_size=20)
        for question in questions:
            self.touch(question)
            if question not in self._answers:
                self._answers[question] = repr(ask(sources, question)).encode("utf-8", "surrogatepass")
            answer = self._answers[question]
            told.update(b"%d " % len(answer))
            told.update(answer)
        return told.digest()


_OF_FILES: Final = frozenset({"is_file", "is_folder", "listing", "modules", "read"})
_OF_SOURCES: Final = frozenset(
    {"belongs", "content", "find", "in_folder", "interface_has", "is_of", "leads_out", "named", "python_package", "shared"}
)  # fmt: skip


def ask(sources: Sources, question: Question) -> object:
    """The answer to a question, as plain values. Raises ValueError for one that nobody knows."""
    name, *rest = question
    given: list[Any] = rest
    if name in _OF_SOURCES:
        return getattr(sources, str(name))(*given)
    if name in _OF_FILES:
        return getattr(sources.files, str(name))(*given)
    if name == "module":
        return "" if str(rest[0]).startswith(MODEL_PREFIX) else sources.content(str(rest[0]))
    if name == "program":
        return sources.program_digest(str(rest[0]))
    if name == "interface_definition":
        of_name = message_name(str(rest[0])) if len(rest) == 1 else None
        return sources.interface_definition(*(given if len(given) > 1 else of_name or ("", "msg", "", "")))
    raise ValueError(name)


_HERE: Final[ContextVar[Memory | None]] = ContextVar("rosward.engine.sources.remembered", default=None)


@contextmanager
def remembering(memory: Memory) -> Iterator[None]:
    """Use this memory, in this context and in those that are copies of it."""
    token = _HERE.set(memory)
    try:
        yield
    finally:
        _HERE.reset(token)


def memory_here() -> Memory | None:
    """The memory that is in use; None where nothing is remembered."""
    return _HERE.get()


def depends_on_the_machine(finding: Finding) -> bool:
    """Whether a finding is told of a run that another time may go another way: it is not to be kept."""
    return finding.code == INTERNAL_ERROR or (
        finding.code == "RW201" and any(each in finding.message for each in (KILLED, TIME_LIMIT))
    )
