# SPDX-License-Identifier: Apache-2.0
"""What does a translation unit hold after preprocessing?

    #include "demo/topics.hpp"                    files: demo/topics.hpp, then the source itself,
    auto pub = node->advertise(STATUS_TOPIC);     with "/robot/status" where the macro stood

Each file keeps its own text and its own lines; a header is prepared once for all units in which the macros that it looks at are the
same. Only what is included within brackets is put in place. No program of the machine has a part in this, and no header that is not of
the sources is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.file_text import Result, SourceLines
from rosward.frontends.cpp.known import predefined
from rosward.frontends.cpp.macros import Macro, Macros, definition
from rosward.frontends.cpp.prepared import Choice, Prepared, Translation
from rosward.frontends.cpp.unit import Unit

_VARIANTS: Final = 12

Read = Callable[[str], str | Finding]
Find = Callable[[str, str, Sequence[str], bool], str | None]


@final
class Preprocessor:
    """Prepares the sources of a workspace; what it has read and prepared is shared by all units.

    `read` gives the text of a file, `named` how places call it, `find` the file of the workspace that an include leads to.
    """

    def __init__(self, read: Read, named: Callable[[str], str], find: Find, distro: str = "") -> None:
        self._read = read
        self._named = named
        self.find = find
        self.distro = distro
        self._sources: dict[str, SourceLines | Finding] = {}
        self._results: dict[str, list[Result]] = {}
        self._same: dict[tuple[str, str, tuple[Choice, ...]], Prepared] = {}
        self._predefined = predefined()
        self.guards: set[str] = set()

    def translate(
        self, path: str, includes: Sequence[str], definitions: Iterable[tuple[str, str, bool]]
    ) -> Translation:
        """The unit of the source at `path`, with its folders of headers and the macros of its command line (name, value, sure)."""
        macros = dict(self._predefined)
        for name, value, sure in definitions:
            macro = definition(f"{name} {value}")
            if macro is not None:
                macros[macro.name] = macro if sure else Macro(macro.name, (), None, "", (macro, None))
        unit = Unit(self, tuple(includes), macros)
        unit.visit(path, 0)
        return Translation(path, tuple(unit.order.values()), tuple(dict.fromkeys(unit.findings)))

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
        return {n: macros[n] for n in macros.keys() & names if n not in self.guards and n not in self._predefined}

    def keep(self, path: str, result: Result) -> None:
        """Remember what became of a file."""
        several = self._results.setdefault(path, [])
        if len(several) < _VARIANTS:
            several.append(result)

    def one(self, prepared: Prepared) -> Prepared:
        """The same record for the same text."""
        return self._same.setdefault((prepared.path, prepared.text, prepared.choices), prepared)
