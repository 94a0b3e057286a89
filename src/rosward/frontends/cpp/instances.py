# SPDX-License-Identifier: Apache-2.0
"""Which static members of class templates are there before `main`, as making an object of an instance needs them?

template<class D> struct Registered : Plugin { static bool done; Registered() { (void)done; } };
template<class D> bool Registered<D>::done = add<D>();
struct Arm : Registered<Arm> {};                        registers itself before `main`, whoever makes one
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from rosward.frontends.cpp.declarators import text_of
from rosward.ir.program import MODEL_PREFIX
from rosward.ir.symbols import Scope, SymbolKind

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.symbol import CppSymbol
    from rosward.frontends.cpp.symbol_file import FileSymbols

__all__ = ["called", "derived", "statics_used"]


def statics_used(files: Sequence[FileSymbols]) -> Mapping[Scope, Sequence[str]]:
    """By the scope of a class template, the static members that making an object needs: constructors, destructors, virtual functions and first
    values of fields say their names, or functions that those call."""
    found: dict[Scope, Sequence[str]] = {}
    for cls in _classes(files):
        if cls.template and b"static" in (cls.declared.node.text or b""):
            members = (
                *cls.members,
                *(m for file in files for ms in file.elsewhere.get(cls.inner, {}).values() for m in ms),
            )
            statics = [m.name for m in cls.members if m.kind is SymbolKind.VARIABLE and m.static]
            used = _used(cls, members) if statics else frozenset()
            if not used.isdisjoint(statics):
                found[cls.inner] = [name for name in statics if name in used]
    return found


def _used(cls: CppSymbol, members: Sequence[CppSymbol]) -> frozenset[str]:
    """Those of the members of a class that are used where an object is made, directly or by others."""
    said: dict[str, set[str]] = {}
    waiting: list[str] = []
    for member in members:
        said.setdefault(member.name, set()).update(_words(member.declared.whole))
        if member.virtual or member.name.removeprefix("~") == cls.name:
            waiting.append(member.name)
    waiting += [member.name for member in cls.members if member.kind is SymbolKind.VARIABLE and not member.static]
    used: set[str] = set()
    while waiting:
        here = waiting.pop()
        if here not in used:
            used.add(here)
            waiting.extend(word for word in said[here] if word in said)
    return frozenset(used)


def _words(node: Node) -> Iterator[str]:
    """The names in what is written; not those in comments and texts."""
    waiting = [node]
    while waiting:
        here = waiting.pop()
        if here.type in {"identifier", "field_identifier"}:
            yield text_of(here)
        waiting.extend(here.named_children)


def called(members: Iterable[CppSymbol]) -> list[tuple[str, ...]]:
    """What definitions elsewhere call the parameters of the class template that they are of."""
    return [names for names in dict.fromkeys(symbol.declared.called for symbol in members) if names]


def derived(files: Iterable[FileSymbols]) -> Sequence[CppSymbol]:
    """The classes that have a base and are no templates themselves, nor in one, as the files are."""
    found: list[CppSymbol] = []
    waiting = [cls for cls in _classes(files) if cls.template is None][::-1]
    while waiting:
        cls = waiting.pop()
        if cls.bases:
            found.append(cls)
        inner = (m for m in cls.members if m.kind is SymbolKind.CLASS and m.defined and m.template is None)
        waiting.extend(reversed(list(inner)))
    return found


def _classes(files: Iterable[FileSymbols]) -> Iterator[CppSymbol]:
    for file in files:
        if not file.text.startswith(MODEL_PREFIX):
            for table in (*file.plain.values(), *file.elsewhere.values()):
                for symbols in table.values():
                    yield from (s for s in symbols if s.kind is SymbolKind.CLASS and s.defined)
