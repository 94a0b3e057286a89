# SPDX-License-Identifier: Apache-2.0
"""How do our positions and records become those of the protocol, and back?

Lines and columns of the protocol count from 0, columns in units that editor and server agree on (UTF-16, if nothing else); ours count characters.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final, final

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.uris import from_fs_path

from rosward.lsp.extents import Extent, column_of
from rosward.lsp.links import Aim
from rosward.lsp.rename import Edit
from rosward.lsp.symbols import Lens, Symbol

if TYPE_CHECKING:
    from pygls.workspace import PositionCodec

    from rosward.lsp.completion import Offer
    from rosward.lsp.records import Told
    from rosward.lsp.state import State

__all__ = ["Turned"]

_KINDS: Final = {
    "node": types.SymbolKind.Class,
    "topic": types.SymbolKind.Event,
    "service": types.SymbolKind.Interface,
    "action": types.SymbolKind.Function,
    "parameter": types.SymbolKind.Property,
    "started": types.SymbolKind.Module,
}
_REFUSED: Final = -32803
"""The protocol's code of a request that failed for a reason that the user is to read."""


@final
class Turned:
    """Turns what is asked of a server and what it answers."""

    def __init__(self, state: State, codec: Callable[[], PositionCodec]) -> None:
        self._state = state
        self._codec = codec

    @staticmethod
    def uri(path: str) -> str:
        """The address of a file."""
        return from_fs_path(path) or ""

    def position(self, path: str, position: types.Position) -> tuple[int, int]:
        """Line and column in characters, within the text."""
        lines = self._state.lines(path)
        if not 0 <= position.line < len(lines):
            return max(0, min(position.line, len(lines))), 0
        text = lines[position.line]
        found = self._codec().position_from_client_units(
            [text], types.Position(0, max(0, min(position.character, 4 * len(text) + 4)))
        )
        return position.line, min(found.character, len(text))

    def range(self, path: str, where: Extent) -> types.Range:
        """The range of an extent."""
        lines = self._state.lines(path)
        return types.Range(
            self._turned(lines, where.line, where.column), self._turned(lines, where.end_line, where.end_column)
        )

    def _turned(self, lines: Sequence[str], line: int, column: int) -> types.Position:
        if not 0 <= line < len(lines):
            return types.Position(max(0, line), 0)
        units = self._codec().client_num_units(lines[line][:column])
        return types.Position(line, units)

    def location(self, aim: Aim) -> types.Location:
        """Where something stands."""
        return types.Location(self.uri(aim.path), self.range(aim.path, aim.extent))

    def diagnostic(
        self, path: str, lines: Sequence[str], told: Told, severity: types.DiagnosticSeverity
    ) -> types.Diagnostic:
        """A finding: from its place to the end of the line."""
        line = max(0, told.place.line - 1)
        text = lines[line] if line < len(lines) else ""
        first = column_of(lines, path, told.place)
        first = first if text[first:].strip() else len(text) - len(text.lstrip())
        folder = self._state.folder_of(path)
        related = [
            types.DiagnosticRelatedInformation(
                types.Location(
                    self.uri(folder.path(place.file)),
                    types.Range(types.Position(max(0, place.line - 1), 0), types.Position(max(0, place.line - 1), 0)),
                ),
                "on the way",
            )
            for place in told.path
            if folder is not None and place.file
        ]
        return types.Diagnostic(
            types.Range(self._turned(lines, line, first), self._turned(lines, line, len(text.rstrip()))),
            f"{told.message}\n{told.help}" if told.help else told.message,
            severity=severity,
            code=told.code,
            source="rosward",
            related_information=related or None,
        )

    def symbol(self, path: str, symbol: Symbol) -> types.DocumentSymbol:
        """A symbol of a document."""
        where = self.range(path, symbol.extent)
        return types.DocumentSymbol(symbol.name or "?", _KINDS[symbol.kind], where, where, detail=symbol.detail)

    def workspace_symbol(self, path: str, symbol: Symbol) -> types.WorkspaceSymbol:
        """A symbol of the workspace."""
        where = types.Location(self.uri(path), self.range(path, symbol.extent))
        return types.WorkspaceSymbol(where, symbol.name or "?", _KINDS[symbol.kind], container_name=symbol.detail)

    def lens(self, path: str, lens: Lens) -> types.CodeLens:
        """A line above a line; who clicks it sees the places, where the editor has the command."""
        where = self.range(path, lens.extent)
        places = [self.location(aim) for aim in lens.aims]
        arguments = [self.uri(path), where.start, places]
        return types.CodeLens(where, types.Command(lens.title, "rosward.showPlaces", arguments=arguments))

    def completion(self, path: str, offer: Offer) -> types.CompletionItem:
        """A name that may be meant."""
        return types.CompletionItem(
            offer.name,
            kind=types.CompletionItemKind.Value,
            detail=offer.detail,
            sort_text=f"{offer.rank}{offer.name}",
            text_edit=types.TextEdit(self.range(path, offer.extent), offer.name),
        )

    def edit(self, edits: Sequence[Edit]) -> types.WorkspaceEdit:
        """Changes of files, by file."""
        found: dict[str, list[types.TextEdit]] = {}
        for each in edits:
            found.setdefault(self.uri(each.path), []).append(
                types.TextEdit(self.range(each.path, each.extent), each.text)
            )
        return types.WorkspaceEdit(changes=found)

    @staticmethod
    def refusal(message: str) -> JsonRpcException:
        """A request that is not carried out, and why."""
        return JsonRpcException(message, _REFUSED)
