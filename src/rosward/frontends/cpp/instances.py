# SPDX-License-Identifier: Apache-2.0
"""Which static members of class templates are there before `main`, as making an object of an instance needs them?

template<class D> struct Registered : Plugin { static bool done; Registered() { (void)done; } };
template<class D> bool Registered<D>::done = add<D>();
struct Arm : Registered<Arm> {};                        registers itself before `main`, whoever makes one
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from rosward.frontends.cpp.declarators import template_parameter_name
from rosward.ir.program import MODEL_PREFIX
from rosward.ir.symbols import Scope, SymbolKind

if TYPE_CHECKING:
    from rosward.frontends.cpp.symbol import CppSymbol
    from rosward.frontends.cpp.symbol_file import FileSymbols

__all__ = ["called", "derived", "statics_used"]


def statics_used(files: Iterable[FileSymbols]) -> Mapping[Scope, Sequence[str]]:
    """By the scope of a class template, its static members of which a constructor or a virtual function says the name."""
    found: dict[Scope, Sequence[str]] = {}
    for cls in _classes(files):
        if cls.template and b"static" in (cls.declared.node.text or b""):
            statics = [m.name for m in cls.members if m.kind is SymbolKind.VARIABLE and m.static]
            used = [name for name in statics if _is_used(cls, name)]
            if used:
                found[cls.inner] = used
    return found


def _is_used(cls: CppSymbol, name: str) -> bool:
    said = re.compile(rf"\b{re.escape(name)}\b".encode())
    return any(
        member.kind is SymbolKind.FUNCTION
        and (member.name == cls.name or member.virtual)
        and said.search(member.declared.node.text or b"") is not None
        for member in cls.members
    )


def called(members: Iterable[CppSymbol]) -> list[tuple[str, ...]]:
    """What definitions elsewhere call the parameters of the class template that they are of."""
    found: dict[tuple[str, ...], None] = {}
    for symbol in members:
        if len(symbol.declared.before) == 1 and symbol.declared.templates:
            found[tuple(template_parameter_name(each) for each in symbol.declared.templates[0].named_children)] = None
    return list(found)


def derived(files: Iterable[FileSymbols]) -> Sequence[CppSymbol]:
    """The classes of namespaces that have a base and are no templates themselves, as the files are."""
    return [cls for cls in _classes(files) if cls.template is None and cls.bases]


def _classes(files: Iterable[FileSymbols]) -> Iterator[CppSymbol]:
    for file in files:
        if not file.text.startswith(MODEL_PREFIX):
            for table in file.plain.values():
                for symbols in table.values():
                    yield from (s for s in symbols if s.kind is SymbolKind.CLASS and s.defined)
