# SPDX-License-Identifier: Apache-2.0
"""How long does an editor wait, and how large does the server become?

    python bench/lsp.py WORKSPACE FILE [--edits 1000] [--launch]

A session as a worker has it: FILE is edited so many times, each time with another text. CPU time of this process and its largest memory; hover is
asked of the views that it told. Without `--launch`, the executables alone are analysed.

    python bench/lsp.py WORKSPACE FILE --server

The server itself and its two processes, which a client edits over its standard input as an editor does, without saving: CPU time of both workers
for an edit, and the memory of each of the three processes.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import statistics
import sys
import time
from pathlib import Path
from typing import Any

from rosward.lsp.hover import hover
from rosward.lsp.records import LAUNCH, SOURCES, View
from rosward.lsp.session import Session, Settings
from rosward.lsp.state import State

_PAGE = os.sysconf("SC_PAGE_SIZE")


def main() -> None:
    """Measure, and print a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("workspace")
    parser.add_argument("file")
    parser.add_argument("--edits", type=int, default=1_000)
    parser.add_argument("--launch", action="store_true")
    parser.add_argument("--server", action="store_true")
    options = parser.parse_args()
    if options.server:
        asyncio.run(_edited(Path(options.workspace).resolve(), options.file, options.edits))
        return
    root = os.path.abspath(options.workspace)  # noqa: PTH100
    path = str(Path(root, options.file))
    text = Path(path).read_text(encoding="utf-8")
    state = State()
    folder = state.add_folder(root)
    session = Session(Settings(root), (SOURCES, LAUNCH) if options.launch else (SOURCES,))

    def renew(number: int | None) -> tuple[float, float]:
        """CPU seconds until the executables are told, and until all is."""
        since, first = time.process_time(), 0.0
        if number is not None:
            state.open(path, f"{text}\n# {number}\n")
        texts = {p: document.text for p, document in state.documents.items()}

        def tell(view: View) -> None:
            nonlocal first
            folder.take(view, texts)
            first = first or time.process_time() - since

        changed = None if number is None else [path]
        session.renew({p: t.encode() for p, t in texts.items()}, changed, tell, lambda *_: None)
        return first, time.process_time() - since

    print(f"at first: {renew(None)[1]:.2f} s, {_memory():.0f} MB, {len(folder.based)} views")
    firsts: list[float] = []
    wholes: list[float] = []
    for number in range(1, options.edits + 1):
        first, whole = renew(number)
        firsts.append(first)
        wholes.append(whole)
        if number in {10, 100, options.edits}:
            print(
                f"after {number} edits: executables {statistics.median(firsts):.3f} s (largest {max(firsts):.3f}), "
                f"all {statistics.median(wholes):.3f} s, {_memory():.0f} MB, {len(session.memory)} remembered"
            )
    asked: list[float] = []
    for _, _, place in list(state.in_file(path))[:50]:
        since = time.process_time()
        hover(state.at(path, place.line - 1, max(0, place.column - 1)))
        asked.append(time.process_time() - since)
    if asked:
        print(f"hover at {len(asked)} places: {statistics.median(asked):.4f} s (largest {max(asked):.4f})")


async def _edited(root: Path, file: str, edits: int) -> None:
    """Let a client edit a file, each time when all is told that follows from the time before."""
    from lsprotocol import types
    from pygls.lsp.client import LanguageClient

    client = LanguageClient("bench", "1")
    done = asyncio.Event()

    @client.feature("rosward/analysed")  # type: ignore[untyped-decorator]
    def _(told: Any) -> None:
        if not told.busy:
            done.set()

    client.feature("textDocument/publishDiagnostics")(lambda _: None)
    client.feature("window/logMessage")(lambda told: print(told.message, file=sys.stderr))
    for asked in ("workspace/codeLens/refresh", "client/registerCapability"):
        client.feature(asked)(lambda _: None)
    await client.start_io(sys.executable, "-m", "rosward", "lsp")
    server = next(int(p) for p in _children(os.getpid()))
    folder = types.WorkspaceFolder(root.as_uri(), root.name)
    await client.initialize_async(
        types.InitializeParams(capabilities=types.ClientCapabilities(), root_uri=None, workspace_folders=[folder])
    )
    client.initialized(types.InitializedParams())
    await done.wait()
    uri, text = (root / file).as_uri(), (root / file).read_text(encoding="utf-8")
    client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "python", 0, text)))
    wholes: list[float] = []
    for number in range(1, edits + 1):
        done.clear()
        since = sum(map(_cpu, _children(server)))
        known = types.VersionedTextDocumentIdentifier(uri=uri, version=number)
        whole = types.TextDocumentContentChangeWholeDocument(f"{text}\n# {number}\n")
        client.text_document_did_change(types.DidChangeTextDocumentParams(known, [whole]))
        await done.wait()
        wholes.append(sum(map(_cpu, _children(server))) - since)
        if number in {10, 100, edits}:
            memory = ", ".join(f"{_memory(process):.0f}" for process in (server, *_children(server)))
            print(
                f"after {number} edits: both workers {statistics.median(wholes):.3f} s, server and workers {memory} MB"
            )
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()  # type: ignore[no-untyped-call]


def _children(process: int) -> list[int]:
    """The processes that a process has started, in that order."""
    return [int(p) for p in Path(f"/proc/{process}/task/{process}/children").read_text(encoding="ascii").split()]


def _cpu(process: int) -> float:
    """CPU seconds that a process has used, to a hundredth."""
    fields = Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _memory(process: int | str = "self") -> float:
    """Resident memory now, in MB."""
    return int(Path(f"/proc/{process}/statm").read_text(encoding="ascii").split()[1]) * _PAGE / 1e6


if __name__ == "__main__":
    main()
