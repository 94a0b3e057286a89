# SPDX-License-Identifier: Apache-2.0
"""Which names has a program, by the sources that it is built of?

Each file is prepared, parsed and looked through once for all programs that see it under the same macros. Where the sources hold a library
that there are models of, one of both counts: mostly the models, which say in few words what it does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property, partial
from typing import final

from rosward.findings import Finding
from rosward.frontends.cpp.flow_marks import own_marks
from rosward.frontends.cpp.model_headers import YIELDING, library_of
from rosward.frontends.cpp.parse import CppParser
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.preprocess import Preprocessor
from rosward.frontends.cpp.same import Merged
from rosward.frontends.cpp.symbol import CppSymbol
from rosward.frontends.cpp.symbol_file import FileSymbols, Seen
from rosward.frontends.cpp.symbols import CppSymbols
from rosward.ir.symbols import Scope, SymbolKind
from rosward.records import NamedTuple

Unit = tuple[str, Sequence[str], Iterable[tuple[str, str, bool]]]
"""A source, its folders of headers, and the macros of its command line."""


class Linked(NamedTuple):
    """The names of a program, the files that they stand in, and what is to be told of these."""

    symbols: CppSymbols
    files: tuple[Prepared, ...]
    findings: tuple[Finding, ...]


def _nothing(_parser: CppParser) -> Sequence[FileSymbols]:
    return ()


def _classes(models: Sequence[FileSymbols]) -> dict[tuple[Scope, str], str]:
    """The classes that models define, each with its library."""
    return {
        (scope, name): library_of(file)
        for file in models
        for scope, names in file.plain.items()
        for name, symbols in names.items()
        if _defines(symbols)
    }


def _defines(symbols: Iterable[CppSymbol]) -> bool:
    """Whether a class is defined here; a specialisation is another class."""
    return any(s.kind is SymbolKind.CLASS and s.defined and s.specialises is None for s in symbols)


@final
class SymbolStore:
    """The files of all programs, and `models`: the headers that stand for libraries, which every program sees."""

    def __init__(
        self, preprocessor: Preprocessor, models: Callable[[CppParser], Sequence[FileSymbols]] = _nothing
    ) -> None:
        self._preprocessor = preprocessor
        self._parser = CppParser()
        self._models = models(self._parser)
        self._described = _classes(self._models)
        self._merged = Merged()
        self._files: dict[tuple[int, bool], tuple[Prepared, FileSymbols | Finding]] = {}

    def symbols(self, units: Iterable[Unit]) -> Linked:
        """Those of a program of these units."""
        found: dict[FileSymbols, None] = {}
        replaced: set[str] = set()
        prepared: dict[int, Prepared] = {}
        findings: dict[Finding, None] = {}
        for path, includes, definitions in units:
            translation = self._preprocessor.translate(path, includes, definitions)
            findings |= dict.fromkeys(translation.findings)
            seen = Seen()
            for each in translation.files:
                file = self._file(each, seen, source=each.path == path)
                prepared[id(each)] = each
                if isinstance(file, FileSymbols):
                    seen.files.append(file)
                    clashes = self._clashes(file)
                    replaced |= clashes & YIELDING
                    if clashes <= YIELDING:
                        found[file] = None
                    findings |= dict.fromkeys((*each.findings, *file.parsed.findings))
                else:
                    findings[file] = None
        models = dict.fromkeys(m for m in self._models if library_of(m) not in replaced)
        symbols = CppSymbols({**models, **found}, self._merged, partial(own_marks, self._parser))
        return Linked(symbols, tuple(prepared.values()), tuple(findings))

    def _clashes(self, file: FileSymbols) -> frozenset[str]:
        """The libraries of which a file of the sources defines a class that their models have, or a part of one."""
        found = {
            self._described[scope, name]
            for scope, names in file.plain.items()
            for name, symbols in (names.items() if scope[:1] in self._spaces else ())
            if (scope, name) in self._described and _defines(symbols)
        }
        parts = {self._described.get((scope[:-1], scope[-1]), "") for scope in file.elsewhere if scope}
        return frozenset(found | parts - {""})

    @cached_property
    def _spaces(self) -> frozenset[Scope]:
        """The outermost namespaces of the models."""
        return frozenset(scope[:1] for scope, _ in self._described)

    def _file(self, prepared: Prepared, seen: Seen, *, source: bool) -> FileSymbols | Finding:
        key = id(prepared), source
        known = self._files.get(key)
        if known is None:
            parsed = self._parser.parse(prepared)
            file = parsed if isinstance(parsed, Finding) else FileSymbols(parsed, seen, source=source)
            known = self._files[key] = prepared, file
        return known[1]
