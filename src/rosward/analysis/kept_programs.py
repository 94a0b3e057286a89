# SPDX-License-Identifier: Apache-2.0
"""Which programs in C++ were linked before, of files that are still the same?

    InStore(store, …).latest().programs["demo/pump"].digest      what tells the program from any other, without reading it anew

To know whether a process has to run again, it need not be known what is in its program, only whether it is another one. All programs of a workspace
are one entry, with all that was asked of its headers (`Headers.asked`): where one answer is another one, nothing of it counts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Final, Protocol, final

from rosward.analysis.linked_functions import LinkedCreation, LinkedFunction
from rosward.cache.codec import FLAG, NUMBER, TEXT, MalformedError, loaded, mapping, maybe, record, sequence, text
from rosward.cache.records import FINDINGS, PLACE, PLACES
from rosward.findings import Finding
from rosward.frontends.cpp.headers import HeadersAsked
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk

if TYPE_CHECKING:
    from rosward.cache.store import Store
    from rosward.engine.sources.remembered import Memory

__all__ = ["InMemory", "InStore", "Keeper", "Kept", "KeptProgram"]

_KIND: Final = "programs"


class KeptProgram(NamedTuple):
    """A program that was linked: what it was linked of, what tells it from any other, what was told of it, and the lines of its files.

    `loads`: it loads plugins, so that which there are was asked. `functions` are those that would create an entity, by file of the program;
    None, as for `places`, where nobody has asked.
    """

    units: str
    digest: str
    findings: tuple[Finding, ...]
    lines: Mapping[str, int]
    loads: bool
    functions: Mapping[str, tuple[LinkedFunction, ...] | None]
    places: tuple[Place, ...] | None = None

    def functions_in(self, wanted: Callable[[str], bool]) -> dict[str, tuple[LinkedFunction, ...]] | None:
        """Those of the files that are wanted; None where they are not known."""
        chosen = {file: functions for file, functions in self.functions.items() if wanted(file)}
        known = {file: functions for file, functions in chosen.items() if functions is not None}
        return known if len(known) == len(chosen) else None

    def with_more(self, other: KeptProgram | None) -> KeptProgram:
        """The same with what another time was asked of it."""
        if other is None or other.digest != self.digest:
            return self
        functions = {file: other.functions.get(file) if mine is None else mine for file, mine in self.functions.items()}
        return self._replace(functions=functions, places=other.places if self.places is None else self.places)


class Kept(NamedTuple):
    """All programs by their names, and what was asked for them."""

    asked: HeadersAsked
    programs: Mapping[str, KeptProgram]


_ASKED: Final = record(HeadersAsked, TEXT, mapping(FLAG), mapping(TEXT))
_CREATION: Final = record(LinkedCreation, TEXT, NUMBER, TEXT, PLACE, FLAG)
_FUNCTIONS: Final = sequence(record(LinkedFunction, TEXT, TEXT, FLAG, sequence(_CREATION)))
_PROGRAM: Final = record(
    KeptProgram,
    TEXT,  # units
    TEXT,  # digest
    FINDINGS,
    mapping(NUMBER),  # lines
    FLAG,  # loads
    mapping(maybe(_FUNCTIONS)),
    maybe(PLACES),
)
_KEPT: Final = record(Kept, _ASKED, mapping(_PROGRAM))


class Keeper(Protocol):
    """Where it is kept."""

    def latest(self) -> Kept | None:
        """What was kept last."""

    def keep(self, found: Kept) -> None:
        """Keep this in its place."""


@final
class InMemory:
    """From one analysis to the next in the same process of the machine."""

    def __init__(self, memory: Memory) -> None:
        self._memory = memory

    def latest(self) -> Kept | None:
        """See `Keeper`."""
        found = self._memory.programs
        return found if isinstance(found, Kept) else None

    def keep(self, found: Kept) -> None:
        """See `Keeper`."""
        self._memory.programs = found


@final
class InStore:
    """From one run to the next, for the sources below a folder, as a version of rosward sees them with the models of the user."""

    def __init__(self, store: Store, version: str, models: list[list[str]], distro: str, root: str) -> None:
        self._store = store
        self._question = text([version, models, distro, root])

    def latest(self) -> Kept | None:
        """See `Keeper`."""
        return self._store.kept(_KIND, self._question, partial(_accepted, disk.digest(self._question)))

    def keep(self, found: Kept) -> None:
        """See `Keeper`. Whoever watches the disk must not have seen two states of it."""
        if not disk.is_torn():
            head = disk.digest(self._question).encode("ascii")
            self._store.keep(_KIND, self._question, head + b"\n" + text(_KEPT.write(found)))


def _accepted(question: str, answer: bytes) -> Kept | None:
    head, _, rest = answer.partition(b"\n")
    try:
        return _KEPT.read(loaded(rest)) if head == question.encode("ascii") else None
    except MalformedError:
        return None
