# SPDX-License-Identifier: Apache-2.0
"""How long does an editor wait, and how large does the server become?

    python bench/lsp.py WORKSPACE FILE [--edits 1000] [--launch]

A session as a worker has it: FILE is edited so many times, each time with another text. CPU time of this process and its largest memory; hover is
asked of the views that it told. Without `--launch`, the executables alone are analysed.
"""

from __future__ import annotations

import argparse
import os
import statistics
import time
from pathlib import Path

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
    options = parser.parse_args()
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


def _memory() -> float:
    """Resident memory now, in MB."""
    return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1]) * _PAGE / 1e6


if __name__ == "__main__":
    main()
