# SPDX-License-Identifier: Apache-2.0
"""One process after another: each in Python is followed in haste at first, and anew where something may depend on that; or remembered.

def on_timer(self):            takes long, and creates something at its end: it is followed anew, and this callback without haste
"""

from __future__ import annotations

from typing import Final

from rosward.analysis.left_out import leaves_out
from rosward.analysis.process import Run, follow
from rosward.analysis.seen import seen_of
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.engine.budget import BeginAnewError, Budget
from rosward.engine.libraries.library import Library
from rosward.engine.sources.reads import Question, Reads
from rosward.engine.sources.remembered import depends_on_the_machine

_MOST_ATTEMPTS: Final = 3
"""So often a process is followed with some haste."""


def run(library: Library, entry: Entry, budget: Budget, configuration: Configuration | None = None) -> Run:
    """Interpret one process to its end, and everything that it schedules, as the configuration starts it; or remember what it did."""
    memory = library.memory
    if memory is None:
        return _run(library, entry, budget, configuration)

    def now() -> tuple[Run, tuple[Question, ...] | None]:
        found = _run(library, entry, budget, configuration)
        failed = found.reads is None or any(map(depends_on_the_machine, found.log.findings))
        return found, None if failed or found.reads is None else found.reads.questions

    found: Run = memory.run((entry, budget, how_started(configuration)), library.plain_sources, now)
    return found


def how_started(configuration: Configuration | None) -> tuple[object, ...]:
    """What tells one way of starting a program from another."""
    if configuration is None:
        return ()
    return (
        configuration.words,
        configuration.component,
        tuple(sorted(configuration.files.items(), key=lambda item: item[0])),
        tuple(sorted(configuration.environment.items(), key=lambda item: item[0])),
    )


def _run(library: Library, entry: Entry, budget: Budget, configuration: Configuration | None) -> Run:
    with library.reading() as reading:
        found = _interpret(library, entry, budget, configuration)
    variables = tuple(sorted(found.log.variables.read))
    reads = Reads(tuple(sorted(reading.questions)), tuple(sorted(reading.models)), variables, budget, configuration)
    return found._replace(reads=reads)


def _interpret(library: Library, entry: Entry, budget: Budget, configuration: Configuration | None) -> Run:
    """Follow a process in haste where it creates nothing; parts of it without haste, if it turns out that something depends on them.

    One in C++ is not followed in haste: to follow it anew would cost more than haste saves.
    """
    if entry.program:
        return follow(library, entry, budget, configuration, None)

    def judge(found: Run) -> None:
        parts = _to_follow_anew(found, library)
        if parts:
            raise BeginAnewError(parts)

    careful: frozenset[str] = frozenset()
    for _ in range(_MOST_ATTEMPTS):
        try:
            return follow(library, entry, budget, configuration, careful, judge)
        except BeginAnewError as error:  # noqa: PERF203 - twice or three times
            careful |= error.parts
    return follow(library, entry, budget, configuration, None)


def _to_follow_anew(found: Run, library: Library) -> frozenset[str]:
    """What was followed in haste where an entity may be missing, or one that seemed sure is not: only one of several ways leads to it."""
    parts = frozenset().union(*(parts for key, parts in found.relied if key not in found.done))
    if parts or not found.hurried:
        return parts
    if found.hides or leaves_out(seen_of(found, library), found.log.functions.values(), library):
        return found.hurried
    return frozenset()
