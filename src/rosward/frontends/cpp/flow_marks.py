# SPDX-License-Identifier: Apache-2.0
"""Which declarations of a file say how information flows through them?

namespace [[rosward::pure]] fmt { [[rosward::sink("stdout")]] void print(); }      fmt: pure; fmt.print: sink stdout

models/cpp/marks/opencv.hpp     declarations of a library that has no model: they are part of no program, and only say this
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.frontends.cpp.declarators import text_of
from rosward.frontends.cpp.marks import ours
from rosward.frontends.cpp.parse import CppParser
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.symbol import CppSymbol
from rosward.frontends.cpp.symbol_file import FileSymbols, Seen
from rosward.ir.symbols import Marked, SymbolKind

if TYPE_CHECKING:
    from tree_sitter import Node

_SAID: Final = re.compile(rb"\[\[[^\]]*\brosward::(?:sink|source|pure|changes|stops|releases|holds)\b")
_FOLDER: Final = Path(__file__).parent.parent.parent / "models" / "cpp" / "marks"
PREFIX: Final = "models:"

_OWN: Final[dict[str, Marked]] = {}
"""What rosward's own files with marks alone say: they never change, so that one run has it from the run before."""


def marked(file: FileSymbols) -> Iterator[tuple[str, Marked]]:
    """What a file says, by dotted names."""
    root = file.parsed.tree.root_node
    if not _says(root):
        return
    yield from _namespaces(file, root, ())
    work = [
        s for table in (file.plain, file.elsewhere) for names in table.values() for same in names.values() for s in same
    ]
    while work:
        symbol = work.pop()
        if not _says(symbol.declared.whole):
            continue
        words = symbol.marks
        if words:
            yield (
                _name(symbol),
                Marked(words, symbol.place, symbol.kind is SymbolKind.CLASS, tuple(p.name for p in symbol.parameters)),
            )
        if symbol.kind is SymbolKind.CLASS:
            work += symbol.members


def _name(symbol: CppSymbol) -> str:
    return ".".join((*symbol.scope, symbol.name))


def _says(node: Node) -> bool:
    return _SAID.search(node.text or b"") is not None


def _namespaces(file: FileSymbols, root: Node, scope: tuple[str, ...]) -> Iterator[tuple[str, Marked]]:
    work = [(root, scope)]
    while work:
        node, outer = work.pop()
        for child in node.named_children:
            if child.type != "namespace_definition" or not _says(child):
                continue
            inner = (*outer, *(part.strip() for part in text_of(child.child_by_field_name("name")).split("::")))
            words = dict(o for c in child.children if c.type == "attribute_declaration" for o in ours(c))
            if words:
                yield ".".join(inner), Marked(words, file.parsed.place(child), True)
            body = child.child_by_field_name("body")
            if body is not None:
                work.append((body, inner))


def own_marks(parser: CppParser) -> Mapping[str, Marked]:
    """What the files with marks alone say; read once."""
    if not _OWN:
        for path in sorted(_FOLDER.glob("*.hpp")):
            parsed = parser.parse(Prepared(str(path), f"{PREFIX}{path.name}", path.read_text(encoding="utf-8")))
            if not isinstance(parsed, Finding):
                _OWN.update(marked(FileSymbols(parsed, Seen(), source=False)))
    return MappingProxyType(_OWN)
