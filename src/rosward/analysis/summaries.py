# SPDX-License-Identifier: Apache-2.0
"""What do earlier runs know of the Python files that are here now?

    Summaries(store, …).of("demo/talker.py", digest)    ->  its summary, if the file had this content then

All files of a workspace are in one entry, so that one look finds them.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.summary import Creation, Summary, summary_of
from rosward.cache.codec import (
    FLAG,
    NUMBER,
    TEXT,
    MalformedError,
    loaded,
    mapping,
    pair,
    record,
    sequence,
    several,
    text,
)
from rosward.source import disk

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rosward.cache.store import Store
    from rosward.ir.program import Module
    from rosward.models.facts import LibraryFacts

__all__ = ["SUMMARY", "Summaries"]

_KIND: Final = "files"

CREATION: Final = record(Creation, TEXT, TEXT, TEXT, TEXT, NUMBER, NUMBER, pair(TEXT, NUMBER))
SUMMARY: Final = record(
    Summary,
    TEXT,  # content
    NUMBER,  # text_lines
    NUMBER,  # lines
    TEXT,  # key
    several(TEXT),  # imports
    several(TEXT),  # first
    FLAG,  # has_main
    several(TEXT),  # main_calls
    sequence(CREATION),
)
_ALL: Final = mapping(SUMMARY)


@final
class Summaries:
    """What a store knows of the files below a folder, as a version of rosward sees them with the models of the user."""

    def __init__(self, store: Store, version: str, models: list[list[str]], root: str) -> None:
        self._store = store
        self._question = text([version, models, root])
        self._known = store.kept(_KIND, self._question, partial(_accepted, disk.digest(self._question))) or {}

    def of(self, file: str, content: str) -> Summary | None:
        """The summary of a file of this content."""
        found = self._known.get(file)
        return None if found is None or found.content != content else found

    def keep(
        self, lowered: Mapping[str, tuple[str, Module]], text_lines: Mapping[str, int], facts: LibraryFacts
    ) -> None:
        """Keep the summaries of all that was read, each file with what tells its content.

        Whoever watches the disk must not have seen two states of it.
        """
        found: dict[str, Summary] = {}
        for file, (content, module) in sorted(lowered.items()):
            known = self.of(file, content)
            found[file] = known or summary_of(content, text_lines[file], module, facts)
        if found != self._known and not disk.is_torn():
            head = disk.digest(self._question).encode("ascii")
            self._store.keep(_KIND, self._question, head + b"\n" + text(_ALL.write(found)))


def _accepted(question: str, answer: bytes) -> dict[str, Summary] | None:
    head, _, rest = answer.partition(b"\n")
    try:
        return _ALL.read(loaded(rest)) if head == question.encode("ascii") else None
    except MalformedError:
        return None
