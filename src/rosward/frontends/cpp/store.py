# SPDX-License-Identifier: Apache-2.0
"""Which files have been read, and what became of them under which macros? Shared by all units."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.file_text import Result, SourceLines
from rosward.frontends.cpp.known import predefined
from rosward.frontends.cpp.macros import Macros
from rosward.frontends.cpp.prepared import Choice, Prepared

_VARIANTS: Final = 12

Read = Callable[[str], str | Finding]
Versions = Mapping[str, tuple[int, int, int]]
NO_VERSIONS: Final[Versions] = MappingProxyType({})
Find = Callable[[str, str, Sequence[str], bool], str | None]
Above = Callable[[str, str], str | None]


def nowhere(name: str, including: str) -> None:
    """A header that no folder of headers has is not among the files."""


@final
class FileStore:
    """The files of a workspace, each read once.

    `read` gives the text of a file, `named` how places call it, `find` the file of the workspace that an include leads to.
    """

    def __init__(
        self, read: Read, named: Callable[[str], str], find: Find, versions: Versions, above: Above = nowhere
    ) -> None:
        self._read = read
        self._named = named
        self.find = find
        self.above = above
        self.versions = versions
        self._sources: dict[str, SourceLines | Finding] = {}
        self._results: dict[str, list[Result]] = {}
        self._same: dict[tuple[str, str, tuple[Choice, ...]], Prepared] = {}
        self.predefined = predefined()
        self.guards: set[str] = set()

    def source(self, path: str) -> SourceLines | Finding:
        """A file, read once."""
        found = self._sources.get(path)
        if found is None:
            text = self._read(path)
            found = self._sources[path] = text if isinstance(text, Finding) else SourceLines(self._named(path), text)
            if isinstance(found, SourceLines) and found.guard:
                self.guards.add(found.guard)
        return found

    def known(self, path: str, macros: Macros) -> Result | None:
        """What became of the file before, under macros that for it are the same."""
        for result in self._results.get(path, ()):
            seen = result.seen
            if len(seen) == len(self.looked_at(macros, result.names)) and all(
                macros.get(n) is m or macros.get(n) == m for n, m in seen.items()
            ):
                return result
        return None

    def looked_at(self, macros: Macros, names: frozenset[str]) -> Macros:
        """The macros that a file with these names in it can look at."""
        return {
            n: macros[n]
            for n in macros.keys() & names
            if n not in self.guards and macros[n] is not self.predefined.get(n)
        }

    def keep(self, path: str, result: Result) -> None:
        """Remember what became of a file."""
        several = self._results.setdefault(path, [])
        if len(several) < _VARIANTS:
            several.append(result)

    def one(self, prepared: Prepared) -> Prepared:
        """The same record for the same text."""
        return self._same.setdefault((prepared.path, prepared.text, prepared.choices), prepared)
