# SPDX-License-Identifier: Apache-2.0
"""Which declarations outside of functions read like those of functions, and are variables?

static const Key key(ids::NAV, ids::FIX);     where ids::NAV is a constant        ->  a variable that is made of two arguments
Key Message::key(kFirst);                     a static member of the class Message
template<class T> int Table<T>::n(T::SIZE);   the same: what names a member of the class that is a variable is no function
Key made(ids::Number);                        where ids::Number is a type         ->  a function
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final, Protocol

from rosward.frontends.cpp.declarators import inner, spelled
from rosward.frontends.cpp.lower.vexing import arguments_in
from rosward.frontends.cpp.outline import Declared, Outline, members
from rosward.ir.symbols import Scope, SymbolKind

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.frontends.cpp.parse import Parsed

__all__ = ["as_meant"]

_VALUES: Final = frozenset({SymbolKind.VARIABLE, SymbolKind.ENUMERATOR})
_HOLDERS: Final = frozenset({SymbolKind.CLASS, SymbolKind.ENUM})
_OTHERS: Final = frozenset({SymbolKind.USING, SymbolKind.USING_NAMESPACE, SymbolKind.NAMESPACE_ALIAS})
_NO_TYPES: Final = frozenset({"placeholder_type_specifier", "auto"})


class File(Protocol):
    """A file that the declaration sees."""

    @property
    def parsed(self) -> Parsed:
        """Its text and tree."""

    @property
    def outline(self) -> Outline:
        """What it declares outside of classes."""


def as_meant(declared: Declared, seen: Sequence[File]) -> Declared:
    """The declaration as what it is, where these files are seen."""
    declarator = declared.whole.child_by_field_name("declarator")
    if (
        declared.kind is not SymbolKind.FUNCTION
        or declared.defined
        or declared.whole.type != "declaration"
        or declarator is None
        or declarator.type != "function_declarator"
    ):
        return declared
    type_node, name = declared.whole.child_by_field_name("type"), inner(declarator)
    listed = arguments_in(declarator)
    if listed is None or name is None or type_node is None or type_node.type in _NO_TYPES or type_node.text == b"void":
        return declared
    if not _is_member(declared, seen) and not _are_values(listed, declared.scope, seen):
        return declared
    return declared._replace(kind=SymbolKind.VARIABLE, node=name)


def _is_member(declared: Declared, seen: Sequence[File]) -> bool:
    """Whether it names a static member that its class declares as a variable."""
    if not declared.before:
        return False
    names = (*(part.name for part in declared.before), declared.name)
    return any(
        SymbolKind.VARIABLE in _declared((*base, *names), file)
        for base in _bases(declared.scope, seen)
        for file in seen
    )


def _are_values(listed: Sequence[Node], scope: Scope, seen: Sequence[File]) -> bool:
    """Whether what reads like parameters are arguments: one of the names is surely that of a value, and none that of a type."""
    found = [_is_value(each, scope, seen) for each in listed]
    return True in found and False not in found


def _is_value(node: Node, scope: Scope, seen: Sequence[File]) -> bool | None:
    type_node, called = node.child_by_field_name("type"), node.child_by_field_name("declarator")
    if type_node is None or type_node.type == "template_type":
        return None
    name = spelled(type_node)
    names = (*(part.name for part in name.scope), name.last.name)
    for base in ((),) if name.absolute else _bases(scope, seen):
        kinds = {kind for file in seen for kind in _declared((*base, *names), file)}
        if not kinds.isdisjoint(_VALUES):
            return called is None or called.type == "abstract_array_declarator"
        if SymbolKind.FUNCTION in kinds:
            return called is not None
        if kinds:
            return False
    return None


def _bases(scope: Scope, seen: Sequence[File]) -> Iterator[Scope]:
    """Where a name may be found that is written in a scope, nearest first."""
    for length in range(len(scope), -1, -1):
        base = scope[:length]
        yield base
        yield (*base, "")
        for file in seen:
            for each in file.outline.declared:
                if each.kind is SymbolKind.USING_NAMESPACE and each.scope == base:
                    used = tuple(each.name.split("::"))
                    yield from ((*base[:n], *used) for n in range(length, -1, -1))


def _declared(full: Scope, file: File) -> Iterator[SymbolKind]:
    """What a file declares under a full name, in a class or enum as well."""
    *around, last = full
    scope = tuple(around)
    for each in file.outline.declared:
        if each.name == last and each.scope == scope and not each.before and each.kind not in _OTHERS:
            yield each.kind
    for holder in _holders(scope, file):
        yield from (member.kind for member in members(file.parsed, holder) if member.name == last)


def _holders(scope: Scope, file: File) -> Iterator[Declared]:
    """The classes and enums of that full name, those within classes as well."""
    if not scope:
        return
    for each in file.outline.declared:
        if each.kind in _HOLDERS and each.name == scope[-1] and (*each.scope, each.label) == scope:
            yield each
    for outer in _holders(scope[:-1], file):
        yield from (m for m in members(file.parsed, outer) if m.kind in _HOLDERS and m.name == scope[-1])
