# SPDX-License-Identifier: Apache-2.0
"""Which files make a translation unit, in which order, and what do the conditions in them ask?

src/main.cpp  includes  demo/driver.hpp  includes  demo/topics.hpp     ->   topics.hpp, driver.hpp, main.cpp
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.file_text import Result
from rosward.frontends.cpp.known import DEPENDS, HEADERS, NOT_DEFINED, macro_prefix
from rosward.frontends.cpp.macros import Macros
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.reading import DEPTH, Reading
from rosward.frontends.cpp.store import FileStore
from rosward.location import Place

_BUDGET: Final = 2_000_000
"""How many tokens macros may make in one unit, and what else takes long."""


@final
class Unit:
    """A translation unit in the course of being prepared."""

    def __init__(self, store: FileStore, includes: tuple[str, ...], macros: Macros) -> None:
        self.store = store
        self.includes = includes
        self.macros = macros
        self.order: dict[str, Prepared] = {}
        self.active: set[str] = set()
        self.once: set[str] = set()
        self.prefixes: set[str] = set()
        self.findings: list[Finding] = []
        self.budget = _BUDGET
        self.here = ""

    def visit(self, path: str, depth: int) -> frozenset[str]:
        """Prepare a file that is included at file scope; the names in it and in what it includes."""
        source = self.store.source(path)
        if isinstance(source, Finding):
            self.findings.append(source)
            return frozenset()
        if path in self.once or path in self.active or depth > DEPTH:
            if depth > DEPTH:
                self.findings.append(
                    Finding("RW201", "Files include each other too deeply: not all are read.", Place(source.file))
                )
            return frozenset()
        if source.guard is not None:
            self.once.add(path)
        before = self.here
        self.active.add(path)
        result = self.store.known(path, self.macros)
        if result is None:
            reading = Reading(self, path, source, depth)
            seen = dict(self.macros)
            prepared = self.store.one(reading.prepared())
            names = frozenset().union(source.names, *reading.inner)
            result = Result(prepared, names, self.store.looked_at(seen, names), reading.changes)
            self.store.keep(path, result)
        else:
            self.prefixes.update(map(macro_prefix, result.prepared.external))
            for inner in result.prepared.includes:
                self.visit(inner, depth + 1)
            for name, macro in result.changes:
                if macro is None:
                    self.macros.pop(name, None)
                else:
                    self.macros[name] = macro
        self.order[path] = result.prepared
        self.active.discard(path)
        self.here = before
        return result.names

    def defined(self, name: str) -> bool | None:
        """By the tables, and by the headers from elsewhere that were included: these may define what begins with their name."""
        if name in NOT_DEFINED:
            return False
        if name in DEPENDS or name.endswith(("_VERSION", "_VERSION_MAJOR", "_VERSION_MINOR", "_VERSION_GTE")):
            return None
        return None if name.partition("_")[0] in self.prefixes and "_" in name else False

    def has_include(self, name: str, *, quoted: bool) -> bool | None:
        """A header of the workspace or of the standard library is there; nobody knows about others."""
        if name in HEADERS or self.store.find(name, self.here, self.includes, quoted) is not None:
            return True
        return None

    def call(self, name: str, arguments: Sequence[str]) -> bool | None:
        """`RCLCPP_VERSION_GTE(28, 0, 0)` by the version of the library, if it is known."""
        version = self.store.versions.get(name)
        if version is None or not all(a.isdigit() for a in arguments):
            return None
        return version >= tuple(int(a[:9]) for a in arguments)
