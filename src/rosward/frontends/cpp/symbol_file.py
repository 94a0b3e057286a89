# SPDX-License-Identifier: Apache-2.0
"""Which symbols has a file, by scope and name?

    using namespace lamp;  void Lamp::on() {}       with lamp/lamp.hpp among the files before it:  on in lamp::Lamp

A file is the same for all programs; what it sees (`Seen`) are the files of the translation unit in which it was first read.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from hashlib import blake2b
from typing import TYPE_CHECKING, Final, final

from rosward.frontends.cpp.declarators import Part, dense, template_parameter_name
from rosward.frontends.cpp.outline import Declared, Outline, outline
from rosward.frontends.cpp.parse import Parsed
from rosward.frontends.cpp.patterns import written
from rosward.frontends.cpp.symbol import CppSymbol
from rosward.frontends.cpp.vexing import as_meant
from rosward.ir.symbols import Scope, SymbolKind

if TYPE_CHECKING:
    from tree_sitter import Node

_DEPTH: Final = 10
"""How many aliases of aliases are followed."""

Table = Mapping[Scope, Mapping[str, Sequence[CppSymbol]]]

_TYPES: Final = frozenset({SymbolKind.CLASS, SymbolKind.ENUM})
_SEEN_BY_ONE: Final = frozenset(
    {SymbolKind.ALIAS, SymbolKind.USING, SymbolKind.USING_NAMESPACE, SymbolKind.NAMESPACE_ALIAS}
)


@final
class FileSymbols:
    """The symbols of a file; `source` where it is the source of a unit, which has names that nobody else sees."""

    def __init__(self, parsed: Parsed, seen: Seen, *, source: bool) -> None:
        self.parsed = parsed
        self.source = source
        self._seen = seen
        self._symbols: dict[tuple[int, SymbolKind], CppSymbol] = {}
        self.locals: dict[
            Scope, dict[str, list[CppSymbol]]
        ] = {}  # what bodies declare, of those that have been asked for

    @cached_property
    def text(self) -> str:
        """What names the text for good: of a file, under some macros."""
        prepared = self.parsed.prepared
        digest = blake2b(prepared.text.encode("utf-8", "replace"), digest_size=6)
        digest.update(repr(prepared.choices).encode())
        return f"{prepared.file}@{digest.hexdigest()}"

    @cached_property
    def outline(self) -> Outline:
        """What it declares outside of classes."""
        return outline(self.parsed)

    @cached_property
    def _declared(self) -> Sequence[Declared]:
        """The same, each as what it is."""
        return [as_meant(each, self._seen.files) for each in self.outline.declared]

    @cached_property
    def plain(self) -> Table:
        """What is declared where it belongs."""
        found: dict[Scope, dict[str, list[CppSymbol]]] = {}
        for each in self._declared:
            if not each.before:
                own = each.templates[-1] if each.templates else None
                _put(found, self._symbol(each, each.scope, own))
        return found

    @cached_property
    def elsewhere(self) -> Table:
        """What is declared with the scope that it belongs to before its name."""
        found: dict[Scope, dict[str, list[CppSymbol]]] = {}
        for each in self._declared:
            if each.before:
                names, own = _scope_before(each.before, each.templates)
                _put(found, self._symbol(each, self._seen.scope(each.scope, names), own))
        return found

    def used(self, scope: Scope) -> Sequence[CppSymbol]:
        """The `using namespace` that stand in a scope."""
        return self._used.get(scope, ())

    @cached_property
    def _used(self) -> Mapping[Scope, Sequence[CppSymbol]]:
        found: dict[Scope, list[CppSymbol]] = {}
        for scope, names in self.plain.items():
            for symbols in names.values():
                if symbols[0].kind is SymbolKind.USING_NAMESPACE:
                    found.setdefault(scope, []).extend(symbols)
        return found

    @cached_property
    def variables(self) -> Sequence[CppSymbol]:
        """Its variables outside of functions, and static members, in their order."""
        found: list[CppSymbol] = []
        for table in (self.plain, self.elsewhere):
            for names in table.values():
                for symbols in names.values():
                    found += [each for symbol in symbols for each in _variables(symbol)]
        return sorted(dict.fromkeys(found), key=lambda symbol: symbol.declared.node.start_byte)

    def functions(self, wanted: re.Pattern[bytes]) -> Iterator[CppSymbol]:
        """The functions with a body in which something is said, those of classes included."""
        waiting = [s for table in (self.plain, self.elsewhere) for n in table.values() for ss in n.values() for s in ss]
        waiting.sort(key=lambda symbol: -symbol.declared.node.start_byte)
        while waiting:
            symbol = waiting.pop()
            if symbol.defined and wanted.search(symbol.declared.node.text or b""):
                if symbol.kind is SymbolKind.FUNCTION:
                    yield symbol
                elif symbol.kind is SymbolKind.CLASS:
                    waiting += reversed(symbol.members)

    # What symbols ask of their file

    def local(self, declared: Declared) -> CppSymbol:
        """The symbol of a class or enum that a function body declares, which is found from now on."""
        found = self.member(declared, None)
        same = self.locals.setdefault(found.scope, {}).setdefault(found.name, [])
        if found not in same:
            same.append(found)
        return found

    def member(self, declared: Declared, of: CppSymbol | None) -> CppSymbol:
        """The symbol of what a class declares."""
        own = declared.templates[-1] if declared.templates else None
        return self._symbol(declared, declared.scope, own, of)

    def in_class(self, symbol: CppSymbol) -> bool:
        """Whether what is written with a scope before its name is a member of a class: where nobody knows, it is."""
        return not self._seen.is_namespace(symbol.scope)

    def linkage(self, symbol: CppSymbol) -> str:
        """The source that alone may see a symbol, or ''."""
        if not self.source:
            return ""
        file = self.parsed.prepared.file
        if "" in symbol.scope:
            return file
        if symbol.owner is not None:
            return ""
        if symbol.kind in _SEEN_BY_ONE:
            return file
        if symbol.declared.before or symbol.kind not in {SymbolKind.VARIABLE, SymbolKind.FUNCTION}:
            return ""
        if "static" in symbol.words:
            return file
        is_own = symbol.kind is SymbolKind.VARIABLE and symbol.constant and symbol.template is None
        return file if is_own and not self._seen.is_external(symbol) else ""

    def _symbol(self, declared: Declared, scope: Scope, own: Node | None, of: CppSymbol | None = None) -> CppSymbol:
        key = declared.node.start_byte, declared.kind
        found = self._symbols.get(key)
        if found is None:
            found = self._symbols.setdefault(key, CppSymbol(self, declared, scope, own, of))
        return found


@final
class Seen:
    """The files of a translation unit, as far as what is declared elsewhere has to be looked up in them."""

    def __init__(self) -> None:
        self.files: list[FileSymbols] = []
        self._classes: dict[Scope, CppSymbol | None] = {}

    def is_namespace(self, scope: Scope) -> bool:
        """Whether there is a namespace of that name."""
        return any(scope in file.outline.spaces for file in self.files)

    def class_at(self, scope: Scope) -> CppSymbol | None:
        """The class or enum with that scope, its definition if it is seen."""
        if scope not in self._classes:
            self._classes[scope] = None  # where a class is asked for on the way to itself
            self._classes[scope] = self._class_at(scope)
        return self._classes[scope]

    def _class_at(self, scope: Scope) -> CppSymbol | None:
        if not scope:
            return None
        *outer, label = scope
        name = label.partition("<")[0]
        around = self.class_at(tuple(outer))
        found = [
            symbol
            for names in (
                *(file.plain.get(tuple(outer), {}) for file in self.files),
                around.named_members if around else {},
            )
            for symbol in names.get(name, ())
            if symbol.kind in _TYPES and symbol.label == label
        ]
        return next((symbol for symbol in found if symbol.defined), found[0] if found else None)

    def is_external(self, symbol: CppSymbol) -> bool:
        """Whether a constant is declared `extern` somewhere."""
        return any(
            "extern" in other.words
            for file in self.files
            for other in file.plain.get(symbol.scope, {}).get(symbol.name, ())
        )

    def scope(self, scope: Scope, names: Scope) -> Scope:
        """The scope that the `names` before a name mean where they are written in `scope`."""
        return self._meant(scope, names, 0) or (*scope, *names)

    def _meant(self, scope: Scope, names: Scope, depth: int) -> Scope | None:
        for base in self._bases(scope):
            first = (*base, names[0])
            if self.class_at(first) is not None or self.is_namespace(first):
                return (*base, *names)
            for file in self.files if depth < _DEPTH else ():
                for symbol in file.plain.get(base, {}).get(names[0].partition("<")[0], ()):
                    target = stands_for(symbol)
                    found = self._meant(base, target, depth + 1) if target and target != names[:1] else None
                    if found is not None:
                        return (*found, *names[1:])
        return None

    def _bases(self, scope: Scope) -> Iterator[Scope]:
        """Where a name may be found that is written in a scope, nearest first."""
        for length in range(len(scope), -1, -1):
            base = scope[:length]
            yield base
            yield (*base, "")
            for file in self.files:
                for used in file.used(base):
                    yield from ((*base[:n], *used.target) for n in range(length, -1, -1))


def stands_for(symbol: CppSymbol) -> Scope:
    """The names of the class or namespace that a `using` or alias stands for."""
    if symbol.kind is SymbolKind.ALIAS:
        described = symbol.declared.node.child_by_field_name("type")
        return () if described is None else written(described).names
    target = symbol.target
    return target[1:] if target[:1] == ("",) else target


def _put(table: dict[Scope, dict[str, list[CppSymbol]]], symbol: CppSymbol) -> None:
    table.setdefault(symbol.scope, {}).setdefault(symbol.name, []).append(symbol)


def _scope_before(before: tuple[Part, ...], templates: tuple[Node, ...]) -> tuple[Scope, Node | None]:
    """The names of the scope before a name, and the parameters of the template that is left for the name itself.

    `template <class T> void Box<T>::f()` is a member of Box, `template <> void Box<int>::f()` one of Box<int>.
    """
    lists = list(templates)
    names: list[str] = []
    for part in before:
        if part.arguments is None:
            names.append(part.name)
            continue
        given = [dense(each).removesuffix("...") for each in part.arguments.named_children]
        parameters = [template_parameter_name(each) for each in lists[0].named_children] if lists else []
        if lists:
            del lists[0]
        names.append(part.name if given == parameters else part.name + dense(part.arguments))
    return tuple(names), lists[-1] if lists else None


def _variables(symbol: CppSymbol) -> Iterator[CppSymbol]:
    """A variable that is there as long as the program, or those of a class."""
    waiting = [symbol]
    while waiting:
        here = waiting.pop()
        if here.template is not None and here.own is not None and here.own.named_children:
            continue  # there are as many as instances
        if any(parameters.named_children for parameters in here.declared.templates):
            continue  # as there are of a static member of a class template
        if here.kind is SymbolKind.VARIABLE:
            is_there = here.static and not here.words.isdisjoint({"inline", "constexpr"}) if here.owner else True
            if is_there and ("extern" not in here.words or here.declared.node.type == "init_declarator"):
                yield here
        elif here.kind is SymbolKind.CLASS and here.defined and b"static" in (here.declared.node.text or b""):
            waiting += reversed(here.members)
