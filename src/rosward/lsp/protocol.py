# SPDX-License-Identifier: Apache-2.0
"""The server of the Language Server Protocol: what comes from an editor is asked of `state.py` and of the modules beside it, and sent back.

Thin: positions and addresses are turned (`turned.py`), and nothing is computed. Whatever a client sends, the server stays: pygls answers what
fails with an error, and the failure is logged.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Sequence
from typing import Any, Final, final

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.uris import to_fs_path

from rosward._version import __version__
from rosward.guard import where
from rosward.lsp.completion import completions
from rosward.lsp.hover import hover
from rosward.lsp.links import Aim, aims, everywhere
from rosward.lsp.rename import RefusedError, rename, renamed_at
from rosward.lsp.state import State
from rosward.lsp.symbols import lenses, symbols_in, symbols_named
from rosward.lsp.turned import Turned
from rosward.lsp.workers import Crew

__all__ = ["Commands", "RoswardServer", "server"]

Commands = Callable[[str], Sequence[tuple[Sequence[str], float]]]
"""For the root of a folder: the commands of its workers, and how many seconds each waits for further changes."""

_SEVERITIES: Final = {
    "error": types.DiagnosticSeverity.Error,
    "warning": types.DiagnosticSeverity.Warning,
    "note": types.DiagnosticSeverity.Information,
}
_SETTINGS: Final = frozenset({"rosward.toml", "pyproject.toml"})
_WATCHED: Final = "**/*.{py,cpp,cc,cxx,h,hpp,xml,yaml,yml,toml,cfg,txt,msg,srv,action}"


@final
class RoswardServer(LanguageServer):
    """State, workers, and what was published."""

    def __init__(self, commands: Commands) -> None:
        super().__init__("rosward", __version__, text_document_sync_kind=types.TextDocumentSyncKind.Full)
        self.state = State()
        self.commands = commands
        self.crews: dict[str, Crew] = {}
        self.asked: dict[tuple[str, int], dict[int, dict[str, str]]] = {}
        self.published: dict[str, tuple[object, ...]] = {}
        self.turned = Turned(self.state, lambda: self.workspace.position_codec)
        self.ends: set[asyncio.Task[None]] = set()

    def report_server_error(self, error: Exception, source: Any) -> None:
        """What fails is logged; nobody is to close a window for it."""
        self.log(
            f"{getattr(source, '__name__', source)}: {type(error).__name__} in {where(error)}", types.MessageType.Error
        )

    def log(self, message: str, kind: types.MessageType = types.MessageType.Info) -> None:
        """A line in the editor's log."""
        self.window_log_message(types.LogMessageParams(type=kind, message=message[:2_000]))

    # Folders and files

    def add_folder(self, root: str) -> None:
        """Begin to analyse a folder."""
        if root in self.crews:
            return
        self.state.add_folder(root)
        crew = self.crews[root] = Crew(self.commands(root), lambda index, document: self.take(root, index, document))
        for path, document in self.state.documents.items():
            if self.root_of(path) == root:
                crew.show(path, document.text)
        crew.change(None)

    def remove_folder(self, root: str) -> None:
        """Stop, and take back what was told of its files."""
        crew = self.crews.pop(root, None)
        if crew is None:
            return
        self.state.folders.pop(root, None)
        for key in [key for key in self.asked if key[0] == root]:
            del self.asked[key]
        ending = asyncio.ensure_future(crew.end())
        self.ends.add(ending)
        ending.add_done_callback(self.ends.discard)
        self.publish([path for path in self.published if self.root_of(path) is None])

    def root_of(self, path: str) -> str | None:
        """The root of the folder in which a file is."""
        folder = self.state.folder_of(path)
        return None if folder is None else folder.root

    def show(self, path: str, text: str | None) -> None:
        """A file is open with this text; None: it is closed."""
        if text is None:
            self.state.close(path)
        else:
            self.state.open(path, text)
        root = self.root_of(path)
        if root is not None and root in self.crews:
            self.crews[root].show(path, text)
        self.publish([path])

    def changed(self, paths: Sequence[str]) -> None:
        """Files have changed on the disk."""
        by_root: dict[str, list[str]] = {}
        for path in paths:
            root = self.root_of(path)
            if root is not None and path not in self.state.documents:
                by_root.setdefault(root, []).append(path)
        for root, inside in by_root.items():
            if any(os.path.basename(path) in _SETTINGS for path in inside):  # noqa: PTH119
                self.remove_folder(root)
                self.add_folder(root)
            else:
                self.crews[root].change(inside)

    # What workers say

    def take(self, root: str, index: int, document: dict[str, Any]) -> None:
        """A worker has said something."""
        folder = self.state.folders.get(root)
        if folder is None:
            return
        waiting = self.asked.setdefault((root, index), {})
        if "asked" in document:
            waiting[document["asked"]] = document["texts"]
        elif "view" in document:
            files = folder.take(document["view"], waiting.get(document["of"], {}), index)
            self.publish([folder.path(file) for file in sorted(files)])
        elif "done" in document:
            if document["names"] is not None:
                files = folder.keep_only(document["names"], index)
                self.publish([folder.path(file) for file in sorted(files)])
            for number in [number for number in waiting if number <= document["done"]]:
                del waiting[number]
            self.told_done(root)
        elif "log" in document:
            self.log(document["log"])

    def told_done(self, root: str) -> None:
        """Whoever waits for the end of an analysis (tests, the status bar of an extension) is told."""
        self.protocol.notify("rosward/analysed", {"folder": self.turned.uri(root), "busy": self.crews[root].busy})
        capable = self.client_capabilities.workspace
        if capable is not None and capable.code_lens is not None and capable.code_lens.refresh_support:
            self.workspace_code_lens_refresh(None)

    def publish(self, paths: Sequence[str]) -> None:
        """Publish diagnostics where they are others than before."""
        for path in paths:
            found = tuple(self.state.findings(path))
            if self.published.get(path, ()) == found:
                continue
            if found:
                self.published[path] = found
            else:
                self.published.pop(path, None)
            lines = self.state.lines(path)
            told = [self.turned.diagnostic(path, lines, each, _SEVERITIES[each.severity]) for each in found]
            self.text_document_publish_diagnostics(
                types.PublishDiagnosticsParams(uri=self.turned.uri(path), diagnostics=told)
            )


def server(commands: Commands) -> RoswardServer:
    """A server with all its features."""
    made = RoswardServer(commands)
    _documents(made)
    _folders(made)
    _questions(made)
    return made


def _path(uri: str) -> str | None:
    """The path of an address; None for what is no file."""
    try:
        path = to_fs_path(uri)
    except (ValueError, TypeError, AttributeError):
        return None
    return os.path.normpath(path) if path and uri.startswith("file:") and "\0" not in path else None


def _documents(made: RoswardServer) -> None:
    @made.feature(types.TEXT_DOCUMENT_DID_OPEN)
    @made.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: RoswardServer, params: types.DidOpenTextDocumentParams | types.DidChangeTextDocumentParams) -> None:
        path = _path(params.text_document.uri)
        if path is not None:
            ls.show(path, ls.workspace.get_text_document(params.text_document.uri).source)

    @made.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(ls: RoswardServer, params: types.DidCloseTextDocumentParams) -> None:
        path = _path(params.text_document.uri)
        if path is not None and path in ls.state.documents:
            ls.show(path, None)


def _folders(made: RoswardServer) -> None:
    @made.feature(types.INITIALIZED)
    def initialized(ls: RoswardServer, _params: types.InitializedParams) -> None:
        for folder in ls.workspace.folders.values():
            path = _path(folder.uri)
            if path is not None and os.path.isdir(path):  # noqa: PTH112
                ls.add_folder(path)
        if not ls.workspace.folders:
            path = _path(ls.workspace.root_uri or "")
            if path is not None and os.path.isdir(path):  # noqa: PTH112
                ls.add_folder(path)
        capable = ls.client_capabilities.workspace
        watched = capable.did_change_watched_files if capable is not None else None
        if watched is not None and watched.dynamic_registration:
            options = types.DidChangeWatchedFilesRegistrationOptions([types.FileSystemWatcher(_WATCHED)])
            wanted = types.Registration("rosward-files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)
            ls.client_register_capability(types.RegistrationParams([wanted]))

    @made.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched_files(ls: RoswardServer, params: types.DidChangeWatchedFilesParams) -> None:
        ls.changed([path for change in params.changes if (path := _path(change.uri)) is not None])

    @made.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(ls: RoswardServer, params: types.DidChangeWorkspaceFoldersParams) -> None:
        for gone in params.event.removed:
            path = _path(gone.uri)
            if path is not None:
                ls.remove_folder(path)
        for come in params.event.added:
            path = _path(come.uri)
            if path is not None and os.path.isdir(path):  # noqa: PTH112
                ls.add_folder(path)

    @made.feature(types.SHUTDOWN)
    async def shutdown(ls: RoswardServer, *_: object) -> None:
        for crew in ls.crews.values():
            await crew.end()


def _questions(made: RoswardServer) -> None:
    def linked(
        ls: RoswardServer, params: types.DefinitionParams | types.ReferenceParams, find: Callable[..., list[Aim]]
    ) -> list[types.Location]:
        path = _path(params.text_document.uri)
        if path is None:
            return []
        line, column = ls.turned.position(path, params.position)
        return [ls.turned.location(aim) for aim in find(ls.state, path, line, column)]

    @made.feature(types.TEXT_DOCUMENT_HOVER)
    def hovered(ls: RoswardServer, params: types.HoverParams) -> types.Hover | None:
        path = _path(params.text_document.uri)
        if path is None:
            return None
        found = ls.state.at(path, *ls.turned.position(path, params.position))
        text = hover(found)
        if not text:
            return None
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, text), ls.turned.range(path, found[0].extent))

    @made.feature(types.TEXT_DOCUMENT_DEFINITION)
    @made.feature(types.TEXT_DOCUMENT_IMPLEMENTATION)
    def definition(ls: RoswardServer, params: types.DefinitionParams) -> list[types.Location]:
        return linked(ls, params, aims)

    @made.feature(types.TEXT_DOCUMENT_REFERENCES)
    def references(ls: RoswardServer, params: types.ReferenceParams) -> list[types.Location]:
        return linked(ls, params, everywhere)

    @made.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def symbols(ls: RoswardServer, params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        path = _path(params.text_document.uri)
        return [] if path is None else [ls.turned.symbol(path, each) for each in symbols_in(ls.state, path)]

    @made.feature(types.WORKSPACE_SYMBOL)
    def named(ls: RoswardServer, params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol]:
        return [ls.turned.workspace_symbol(path, each) for path, each in symbols_named(ls.state, params.query)]

    @made.feature(types.TEXT_DOCUMENT_CODE_LENS)
    def lens(ls: RoswardServer, params: types.CodeLensParams) -> list[types.CodeLens]:
        path = _path(params.text_document.uri)
        return [] if path is None else [ls.turned.lens(path, each) for each in lenses(ls.state, path)]

    @made.feature(types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=['"', "'", "/"]))
    def complete(ls: RoswardServer, params: types.CompletionParams) -> types.CompletionList:
        path = _path(params.text_document.uri)
        found = [] if path is None else completions(ls.state, path, *ls.turned.position(path, params.position))
        return types.CompletionList(is_incomplete=False, items=[ls.turned.completion(str(path), c) for c in found])

    @made.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def prepare(ls: RoswardServer, params: types.PrepareRenameParams) -> types.PrepareRenamePlaceholder | None:
        path = _path(params.text_document.uri)
        found = None if path is None else renamed_at(ls.state, path, *ls.turned.position(path, params.position))
        if path is None or found is None:
            return None
        return types.PrepareRenamePlaceholder(ls.turned.range(path, found.extent), found.name)

    @made.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    def renamed(ls: RoswardServer, params: types.RenameParams) -> types.WorkspaceEdit | None:
        path = _path(params.text_document.uri)
        if path is None:
            return None
        try:
            edits = rename(ls.state, path, *ls.turned.position(path, params.position), params.new_name)
        except RefusedError as error:
            raise ls.turned.refusal(str(error)) from error
        return ls.turned.edit(edits)
