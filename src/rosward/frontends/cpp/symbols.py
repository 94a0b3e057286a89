# SPDX-License-Identifier: Apache-2.0
"""Which names has a program?

    lamp.hpp:  struct Lamp { void on(int level = 1); };      lamp.cpp:  void Lamp::on(int level) {…}      ->  Lamp::on: one function

The files of a program are put together when a scope of it is asked for; what two programs share is computed once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from hashlib import blake2b
from typing import Final, final

from rosward.frontends.cpp.flow_marks import marked
from rosward.frontends.cpp.instances import called, derived, statics_used
from rosward.frontends.cpp.outline import namespace_at
from rosward.frontends.cpp.same import Merged
from rosward.frontends.cpp.symbol import CppSymbol
from rosward.frontends.cpp.symbol_file import FileSymbols
from rosward.frontends.cpp.unaware import unaware
from rosward.ir.symbols import Marked, Scope, SymbolKind

_TYPES: Final = frozenset({SymbolKind.CLASS, SymbolKind.ENUM})
_LITERALS: Final = frozenset(
    {
        "number_literal",
        "string_literal",
        "char_literal",
        "true",
        "false",
        "null",
        "unary_expression",
        "concatenated_string",
    }
)


@final
class CppSymbols:
    """See `ir.symbols.Symbols`. `merged` is what is known of declarations that are one, for all programs; `described` says how
    information flows through libraries that are part of no program."""

    def __init__(
        self, files: Iterable[FileSymbols], merged: Merged, described: Callable[[], Mapping[str, Marked]] = dict
    ) -> None:
        self.files = tuple(dict.fromkeys(files))
        self._described = described
        self._merged = merged
        self._scopes: dict[Scope, dict[str, list[CppSymbol]]] = {}
        self._used: dict[Scope, Sequence[CppSymbol]] = {}
        self._found: dict[tuple[Scope, str], Sequence[CppSymbol]] = {}
        self._elsewhere: dict[tuple[Scope, str], bool] = {}

    def at(self, scope: Scope, name: str) -> Sequence[CppSymbol]:
        """What a scope declares under a name, over all files of the program, in their order."""
        found = self._found.get((scope, name))
        if found is None:
            found = self._found[scope, name] = self._at(self._seen(scope), name)
        return found

    def _at(self, scope: Scope, name: str) -> Sequence[CppSymbol]:
        declared: list[CppSymbol] = []
        if scope:
            label = scope[-1]
            for symbol in self.at(scope[:-1], label.partition("<")[0]):
                if symbol.kind in _TYPES and symbol.label == label:
                    declared += symbol.named_members.get(name, ())
            if label.endswith("()"):
                declared += [each for file in self.files for each in file.locals.get(scope, {}).get(name, ())]
        declared += self._scope(scope).get(name, ())
        return self._merged.one_each(declared) if declared else ()

    def of_instances(self, scope: Scope) -> Mapping[str, Sequence[CppSymbol]]:
        """The members that single instances of a class template have instead of those of all."""
        found: dict[str, list[CppSymbol]] = {}
        for inner in self._instances.get(scope, ()):
            for name, symbols in self._scope(inner).items():
                general = self.at(scope, name)
                same = [self._merged.also(s, [g for g in general if g.kind is s.kind]) for s in symbols]
                found.setdefault(name, []).extend(same)
        return found

    def called(self, scope: Scope) -> Sequence[Sequence[str]]:
        """What members of a class template that are defined elsewhere call its parameters."""
        return called(symbol for symbols in self._scope(scope).values() for symbol in symbols)

    @cached_property
    def unaware(self) -> Mapping[str, frozenset[Scope]]:
        """The files that know nothing of ROS, and keep nothing between two calls, unless they are handed something of these namespaces."""
        return unaware(self.files)

    @cached_property
    def _instances(self) -> dict[Scope, list[Scope]]:
        """By the scope of a class template, those of its instances that are no specialisations themselves, but have members of their own."""
        found: dict[Scope, list[Scope]] = {}
        for scope in self._files:
            name, arguments, _ = scope[-1].partition("<") if scope else ("", "", "")
            if arguments and not any(s.label == scope[-1] for s in self.at(scope[:-1], name) if s.kind in _TYPES):
                found.setdefault((*scope[:-1], name), []).append(scope)
        return found

    def used(self, scope: Scope) -> Sequence[CppSymbol]:
        """The `using namespace` of a scope."""
        found = self._used.get(scope)
        if found is None:
            seen = self._seen(scope)
            found = self._used[scope] = [s for file in self._files.get(seen, ()) for s in file.used(seen)]
        return found

    def is_namespace(self, scope: Scope) -> bool:
        """Whether anything is declared in a namespace of that name."""
        return scope in self._spaces

    def is_elsewhere(self, scope: Scope, name: str) -> bool:
        """Whether another namespace than this has functions of that name."""
        found = self._elsewhere.get((scope, name))
        if found is None:
            others = (space for space in self._spaces if space != scope)
            found = any(s.kind is SymbolKind.FUNCTION for space in others for s in self.at(space, name))
            self._elsewhere[scope, name] = found
        return found

    @cached_property
    def digest(self) -> str:
        """What tells the program from one of other files, or of files that became something else."""
        return blake2b("\n".join(file.text for file in self.files).encode(), digest_size=16).hexdigest()

    @cached_property
    def variables(self) -> Sequence[CppSymbol]:
        """The variables outside of functions, and static members: first those whose first value is written there, then as the files are."""
        found: dict[CppSymbol, None] = {}
        for file in self.files:
            for symbol in file.variables:
                if "extern" in symbol.words and symbol.code is None:
                    continue
                whole = next((s for s in self.at(symbol.scope, symbol.name) if s.key == symbol.key), None)
                if whole is not None:
                    found[whole] = None
        return sorted(found, key=lambda symbol: not _is_written(symbol))

    @cached_property
    def statics_used(self) -> Mapping[Scope, Sequence[str]]:
        """By the scope of a class template, the static members that whoever makes an object of it needs."""
        return statics_used(self.files)

    @cached_property
    def derived(self) -> Sequence[CppSymbol]:
        """The classes that have a base and are no templates."""
        found = (next((s for s in self.at(d.scope, d.name) if s.key == d.key), None) for d in derived(self.files))
        return [symbol for symbol in found if symbol is not None]

    @cached_property
    def main(self) -> CppSymbol | None:
        """The function `main`."""
        return next((s for s in self.at((), "main") if s.kind is SymbolKind.FUNCTION and s.defined), None)

    @cached_property
    def registered(self) -> Mapping[str, tuple[Scope, str]]:
        """Where a macro registers a class for others to make by name, by what it says: the namespace and the file."""
        return {
            each.arguments[0]: (namespace_at(file.parsed, each.line), file.parsed.prepared.file)
            for file in self.files
            for each in file.parsed.prepared.registrations
            if each.arguments
        }

    def registered_class(self, name: str) -> Sequence[CppSymbol]:
        """The declarations of a class by the name under which it is registered, looked for from the namespace of the macro outwards."""
        *scope, own = name.removeprefix("::").split("::")
        within, file = self.registered.get(name, ((), ""))
        for length in range(0 if name.startswith("::") else len(within), -1, -1):
            around = within[:length]
            used = [use.target for use in self.used(around) if use.place.file == file]
            for space in (around, *((*around, *target) for target in used), *used):
                found = self.at((*space, *scope), own)
                if found:
                    return found
        return ()

    @cached_property
    def marked(self) -> Mapping[str, Marked]:
        """The declarations with attributes that say how information flows, by dotted names; what a file of the program says goes first."""
        found = dict(self._described())
        for file in self.files:
            found.update(marked(file))
        return found

    @cached_property
    def _spaces(self) -> frozenset[Scope]:
        return frozenset(space for file in self.files for space in file.outline.spaces)

    @cached_property
    def _inlines(self) -> dict[Scope, Scope]:
        return {inner: outer for file in self.files for inner, outer in file.outline.inlines.items()}

    def _seen(self, scope: Scope) -> Scope:
        """The scope without inline namespaces."""
        if self._inlines:
            for length in range(1, len(scope) + 1):
                outer = self._inlines.get(scope[:length])
                if outer is not None:
                    return self._seen((*outer, *scope[length:]))
        return scope

    @cached_property
    def _files(self) -> dict[Scope, list[FileSymbols]]:
        """The files that have something in a scope."""
        found: dict[Scope, list[FileSymbols]] = {}
        for file in self.files:
            for scope in dict.fromkeys((*file.plain, *file.elsewhere)):
                found.setdefault(scope, []).append(file)
        return found

    def _scope(self, scope: Scope) -> dict[str, list[CppSymbol]]:
        found = self._scopes.get(scope)
        if found is None:
            found = self._scopes[scope] = {}
            for file in self._files.get(scope, ()):
                for table in (file.plain, file.elsewhere):
                    for name, symbols in table.get(scope, {}).items():
                        found.setdefault(name, []).extend(symbols)
        return found


def _is_written(symbol: CppSymbol) -> bool:
    """Whether the first value of a variable needs nothing to run."""
    if not symbol.words.isdisjoint({"constexpr", "constinit"}):
        return True
    node = symbol.declared.node
    value = node.child_by_field_name("value") or symbol.declared.whole.child_by_field_name("default_value")
    return value is not None and value.type in _LITERALS
