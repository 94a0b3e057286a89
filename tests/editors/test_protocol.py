# SPDX-License-Identifier: Apache-2.0
"""The server as a process, and a client that holds it to the protocol."""

from __future__ import annotations

import asyncio
import inspect
import json
import sys
from collections.abc import Awaitable, Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

if any(find_spec(name) is None for name in ("pygls", "pytest_lsp")):
    pytest.skip("the extra lsp is not installed", allow_module_level=True)

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pytest_lsp import LanguageClient, client_capabilities, make_test_lsp_client

from .desk import DEMO, LAUNCH, TALKER, write

COMMAND = [sys.executable, "-m", "rosward", "lsp"]
LONG = 300
NONSENSE = (
    b"",
    b"nonsense",
    b"[]",
    b"{}",
    b"\xff\xfe",
    b'{"jsonrpc": "2.0", "id": 900, "method": "textDocument/hover", "params": {"position": 3}}',
    b'{"jsonrpc": "2.0", "id": 901, "method": "textDocument/hover"}',
    b'{"jsonrpc": "2.0", "id": 902, "method": "no/such", "params": null}',
    b'{"jsonrpc": "2.0", "id": 903, "method": "workspace/symbol", "params": ["x"]}',
    b'{"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": 5}}',
    b'{"jsonrpc": "2.0", "method": "workspace/didChangeWatchedFiles", "params": {"changes": [{"uri": 3}]}}',
    b'{"jsonrpc": "2.0", "id": 3.5, "result": {}}',
)
SYSTEM = "launch/demo.launch.xml"


class Editor:
    """A client, and what it knows of a workspace."""

    def __init__(self, client: LanguageClient, root: Path) -> None:
        self.client = client
        self.root = root
        self.quiet = asyncio.Event()
        self.version = 0

        @client.feature("rosward/analysed")  # type: ignore[untyped-decorator]
        def analysed(told: Any) -> None:
            if not told.busy:
                self.quiet.set()

    def uri(self, name: str) -> str:
        return (self.root / name).as_uri()

    def at(self, name: str, text: str, after: str = "") -> dict[str, Any]:
        """The arguments of a question about the place behind `after` in a text."""
        lines = self.texts(name).split("\n")
        line = next(i for i, each in enumerate(lines) if text in each)
        column = lines[line].index(text) + len(after) + 1
        units = len(lines[line][:column].encode("utf-16-le")) // 2
        return {"text_document": types.TextDocumentIdentifier(self.uri(name)), "position": types.Position(line, units)}

    def texts(self, name: str) -> str:
        return (self.root / name).read_text()

    async def settled(self) -> None:
        await asyncio.wait_for(self.quiet.wait(), LONG)

    def open(self, name: str, language: str = "python") -> None:
        item = types.TextDocumentItem(self.uri(name), language, 0, self.texts(name))
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))

    async def type(self, name: str, text: str) -> None:
        """Change an open file, without saving it, and wait for what comes of it."""
        self.version += 1
        self.quiet.clear()
        known = types.VersionedTextDocumentIdentifier(uri=self.uri(name), version=self.version)
        whole = types.TextDocumentContentChangeWholeDocument(text)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(known, [whole]))
        await self.settled()

    def codes(self, name: str) -> list[tuple[object, int]]:
        return [(d.code, d.range.start.line) for d in self.client.diagnostics.get(self.uri(name), [])]


def run(root: Path, work: Callable[[Editor], Awaitable[None]], *, folders: bool = True, settle: bool = True) -> None:
    """Start a server, do something with it, and see that it stops when it is asked to."""

    async def session() -> None:
        client = make_test_lsp_client()
        editor = Editor(client, root)
        await client.start_io(*COMMAND)
        given = [types.WorkspaceFolder(root.as_uri(), "ws")] if folders else []
        await client.initialize_session(
            types.InitializeParams(
                capabilities=client_capabilities("visual-studio-code"), root_uri=None, workspace_folders=given
            )
        )
        if settle:
            await editor.settled()
        await work(editor)
        await client.shutdown_session()
        await client.stop()  # type: ignore[no-untyped-call]

    asyncio.run(session())


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("ws"), DEMO)


def test_an_editor_works_with_it(root: Path) -> None:
    async def work(editor: Editor) -> None:
        client = editor.client
        editor.open("demo/talker.py")
        here = editor.at("demo/talker.py", '"chatter"')
        found = await client.text_document_hover_async(types.HoverParams(**here))
        assert found is not None
        assert "`/news`" in found.contents.value  # type: ignore[union-attr]
        there = await client.text_document_definition_async(types.DefinitionParams(**here))
        assert [(each.uri, each.range.start.line) for each in there] == [(editor.uri("demo/listener.py"), 7)]  # type: ignore[union-attr]
        both = await client.text_document_references_async(
            types.ReferenceParams(types.ReferenceContext(include_declaration=True), **here)
        )
        assert both is not None
        assert len(both) == 2
        document = types.TextDocumentIdentifier(editor.uri("demo/talker.py"))
        symbols = await client.text_document_document_symbol_async(types.DocumentSymbolParams(document))
        assert "/news" in {each.name for each in symbols or []}
        assert [s.name for s in await client.workspace_symbol_async(types.WorkspaceSymbolParams("/news")) or []]
        lenses = await client.text_document_code_lens_async(types.CodeLensParams(document))
        assert [lens.command.title for lens in lenses or [] if lens.command] == ["/news: 1 publisher, 1 subscription"]
        asked = editor.at(SYSTEM, 'to="/news"', 'to="')
        ready = await client.text_document_prepare_rename_async(types.PrepareRenameParams(**asked))
        assert ready.placeholder == "/news"  # type: ignore[union-attr]
        edit = await client.text_document_rename_async(types.RenameParams(new_name="/olds", **asked))
        assert edit is not None
        assert {uri: len(each) for uri, each in (edit.changes or {}).items()} == {editor.uri(SYSTEM): 2}
        with pytest.raises(JsonRpcException, match="no name in ROS"):
            await client.text_document_rename_async(types.RenameParams(new_name="a b", **asked))
        offered = await client.text_document_completion_async(
            types.CompletionParams(**editor.at(SYSTEM, 'to="/news"', 'to="/'))
        )
        assert "/news" in {item.label for item in offered.items}  # type: ignore[union-attr]

    run(root, work)


@pytest.mark.slow
def test_findings_come_and_go_with_what_is_typed(root: Path) -> None:
    async def work(editor: Editor) -> None:
        editor.open("demo/talker.py")
        await editor.type("demo/talker.py", TALKER + "\ndef f(:\n")
        assert editor.codes("demo/talker.py") == [("RW001", 14)]
        unknown = TALKER.replace('"chatter"', "__import__('os').environ['жук🐞' and 'TOPIC']")
        await editor.type("demo/talker.py", unknown)
        assert "RW001" not in dict(editor.codes("demo/talker.py"))
        assert editor.codes("demo/talker.py")
        await editor.type("demo/talker.py", TALKER.replace("\n", "\r\n"))
        assert editor.codes("demo/talker.py") == []

    run(root, work)


@pytest.mark.slow
def test_positions_are_in_units_of_utf_16(tmp_path: Path) -> None:
    text = TALKER.replace("self.pub =", "self.a = '🐞🐞🐞'; self.pub =")
    root = write(tmp_path, {**DEMO, "demo/talker.py": text})

    async def work(editor: Editor) -> None:
        here = editor.at("demo/talker.py", '"chatter"')
        found = await editor.client.text_document_hover_async(types.HoverParams(**here))
        assert found is not None
        assert found.range is not None
        line = text.split("\n")[8].encode("utf-16-le")
        start = line[2 * found.range.start.character :].decode("utf-16-le")
        assert start.startswith("self.create_publisher(")

    run(root, work)


@pytest.mark.slow
def test_folders_come_and_go(root: Path, tmp_path: Path) -> None:
    broken = write(tmp_path / "other", {"demo/talker.py": "def f(:\n"})

    async def work(editor: Editor) -> None:
        folder = types.WorkspaceFolder(broken.as_uri(), "other")
        editor.quiet.clear()
        event = types.WorkspaceFoldersChangeEvent(added=[folder], removed=[])
        editor.client.workspace_did_change_workspace_folders(types.DidChangeWorkspaceFoldersParams(event))
        await editor.settled()
        uri = (broken / "demo/talker.py").as_uri()
        assert [d.code for d in editor.client.diagnostics[uri]] == ["RW001"]
        gone = types.WorkspaceFoldersChangeEvent(added=[], removed=[folder])
        editor.client.workspace_did_change_workspace_folders(types.DidChangeWorkspaceFoldersParams(gone))
        await editor.client.workspace_symbol_async(types.WorkspaceSymbolParams(""))
        assert not editor.client.diagnostics[uri]

    run(root, work)


@pytest.mark.slow
def test_a_file_that_somebody_else_saves(tmp_path: Path) -> None:
    root = write(tmp_path, DEMO)

    async def work(editor: Editor) -> None:
        (root / SYSTEM).write_text(LAUNCH.replace("/news", "/olds"))
        editor.quiet.clear()
        changed = [types.FileEvent(editor.uri(SYSTEM), types.FileChangeType.Changed)]
        editor.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams(changed))
        await editor.settled()
        found = await editor.client.workspace_symbol_async(types.WorkspaceSymbolParams("/olds"))
        assert found

    run(root, work)


@pytest.mark.slow
def test_nonsense_is_answered_and_the_server_stays(root: Path) -> None:
    async def work(editor: Editor) -> None:
        client = editor.client
        for uri in (
            "",
            "untitled:Untitled-1",
            "https://example.invalid/a.py",
            "file:///nowhere/a.py",
            "file:///%00",
            "::",
        ):
            for line, column in ((0, 0), (2**31 - 1, 2**31 - 1)):
                where = {"text_document": types.TextDocumentIdentifier(uri), "position": types.Position(line, column)}
                assert await client.text_document_hover_async(types.HoverParams(**where)) is None  # type: ignore[arg-type]
                assert not await client.text_document_definition_async(types.DefinitionParams(**where))  # type: ignore[arg-type]
            client.text_document_did_close(types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(uri)))
            client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "x", 0, "(\n")))
        for body in NONSENSE:
            sent = client.protocol.writer.write(f"Content-Length: {len(body)}\r\n\r\n".encode() + body)  # type: ignore[union-attr]
            if inspect.isawaitable(sent):
                await sent
        here = editor.at("demo/talker.py", '"chatter"')
        assert await client.text_document_hover_async(types.HoverParams(**here)) is not None

    run(root, work)


def test_without_a_folder_there_is_nothing_to_tell(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("def f(:\n")

    async def work(editor: Editor) -> None:
        editor.open("a.py")
        assert await editor.client.workspace_symbol_async(types.WorkspaceSymbolParams("")) == []
        assert editor.client.diagnostics == {}

    run(tmp_path, work, folders=False, settle=False)


@pytest.mark.slow
def test_what_is_wrong_with_rosward_toml_is_logged_until_it_is_right(tmp_path: Path) -> None:
    root = write(tmp_path, {**DEMO, "rosward.toml": "no-such-key = 1\n"})

    async def work(editor: Editor) -> None:
        for _ in range(LONG):
            if any("no-such-key" in each.message for each in editor.client.log_messages):
                break
            await asyncio.sleep(0.2)
        else:
            pytest.fail("it was not logged")
        (root / "rosward.toml").write_text('distro = "humble"\n')
        changed = [types.FileEvent(editor.uri("rosward.toml"), types.FileChangeType.Changed)]
        editor.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams(changed))
        await editor.settled()
        assert await editor.client.workspace_symbol_async(types.WorkspaceSymbolParams("/news"))

    run(root, work, settle=False)


def test_a_worker_answers_the_newest_question_and_passes_over_nonsense(tmp_path: Path) -> None:
    import io
    import threading

    from rosward.lsp.session import Session, Settings
    from rosward.lsp.worker import Worker

    root = write(tmp_path, DEMO)
    output = io.StringIO()
    worker = Worker(Session(Settings(str(root))), output)
    path = str(root / "demo/talker.py")
    lines = ["nonsense", "{}", '{"renew": "x"}', "[1]"]
    for number in range(1, 4):
        texts = {path: TALKER.replace("chatter", f"chatter{number}")}
        lines.append(json.dumps({"renew": number, "texts": texts, "changed": [path]}))
    worker.listen(lines)
    thread = threading.Thread(target=worker.work)
    thread.start()
    thread.join()
    answers = [json.loads(line) for line in output.getvalue().splitlines()]
    assert [answer["done"] for answer in answers if "done" in answer] == [3]
    assert "/chatter3" in output.getvalue()
    assert "/chatter2" not in output.getvalue()
