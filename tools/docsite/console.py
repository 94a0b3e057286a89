# SPDX-License-Identifier: Apache-2.0
"""Does a page show what the commands in it really print?

    ```python title="src/talker.py"          a file: it is written as it stands here
    …
    ```
    <!-- runs -->
    ```console                               a run: each `$ command` is carried out, in the folder of the page
    $ rosward extract src
    rosward read 1 file …
    …                                        a line of its own: some lines are left out
    ```

The folder of a page is empty but for `examples`, and lives as long as the page: what one run writes the next may read. Commands are
`rosward …`, `echo $?` (its exit status), and whatever else a shell knows.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from pathlib import Path
from typing import Final, NamedTuple

from docsite.pages import ROOT
from rosward.cli import main

__all__ = ["Run", "agrees", "perform", "rewritten", "runs_of", "steps_of", "write_files"]

ELIDED: Final = "…"
_TITLED: Final = r"^```\w+ [^\n]*?title=\"(?P<title>[^\"\n]+)\"[^\n]*\n(?P<text>.*?)^```[ \t]*$"
_SHOWN: Final = r"^<!-- runs -->\n+```console\n(?P<runs>.*?)^```[ \t]*$"
_QUOTED: Final = re.compile(
    r"^(`{4,})[^\n]*\n.*?^\1[ \t]*$", re.MULTILINE | re.DOTALL
)  # a page that shows how to write one
_STEP: Final = re.compile(f"{_TITLED}|{_SHOWN}", re.MULTILINE | re.DOTALL)
_PLAIN: Final = re.compile(r"[^|&;<>$`(){}\\]*")
_SECONDS: Final = 120


class File(NamedTuple):
    """A file that a page shows."""

    name: str
    text: str


class Run(NamedTuple):
    """A command that a page shows, with the lines below it, and where these stand in the page."""

    command: str
    shown: list[str]
    start: int
    end: int


def steps_of(page: str) -> Iterator[File | Run]:
    """The files and runs of a page, in their order."""
    for step in _STEP.finditer(_QUOTED.sub(lambda quoted: " " * len(quoted.group()), page)):
        if step.group("title"):
            yield File(step.group("title"), step.group("text"))
        else:
            yield from _runs(step.group("runs"), step.start("runs"))


def runs_of(page: str) -> list[Run]:
    """The runs of a page."""
    return [step for step in steps_of(page) if isinstance(step, Run)]


def _runs(block: str, start: int) -> Iterator[Run]:
    for part in re.finditer(
        r"^\$ (?P<command>(?:[^\n]*\\\n)*[^\n]*)\n(?P<shown>.*?)(?=^\$ |\Z)", block, re.MULTILINE | re.DOTALL
    ):
        command = re.sub(r"\\\n(?:> )?\s*", "", part["command"])
        yield Run(command, part["shown"].splitlines(), start + part.start("shown"), start + part.end("shown"))


def write_files(files: Sequence[File], folder: Path) -> None:
    """Write files into the folder of a page."""
    for name, text in files:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def perform(page: str, folder: Path) -> Iterator[tuple[Run, list[str]]]:
    """Carry out a page in a folder, which is the current one: each run with the lines that it prints."""
    (folder / "examples").symlink_to(ROOT / "examples")
    status = 0
    for step in steps_of(page):
        if isinstance(step, File):
            write_files([step], folder)
        elif step.command == "echo $?":
            yield step, [str(status)]
        else:
            status, printed = _carried_out(step.command, folder)
            yield step, [line.rstrip() for line in printed.splitlines()]


def _carried_out(command: str, folder: Path) -> tuple[int, str]:
    if not command.startswith("rosward ") or not _PLAIN.fullmatch(command):
        return _in_a_shell(command, folder)
    terminal = io.StringIO()
    with contextlib.redirect_stdout(terminal), contextlib.redirect_stderr(terminal):
        try:
            status = main(shlex.split(command)[1:])
        except SystemExit as left:
            status = left.code if isinstance(left.code, int) else 1
    return status, terminal.getvalue()


def _in_a_shell(command: str, folder: Path) -> tuple[int, str]:
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        env={**os.environ, "PATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=_SECONDS,
        check=False,
    )
    return done.returncode, done.stdout


def agrees(shown: Sequence[str], printed: Sequence[str]) -> bool:
    """Whether the lines shown are those printed; a line `…` stands for any number of lines."""
    if ELIDED not in shown:
        return list(shown) == list(printed)
    pieces: list[list[str]] = [[]]
    for line in shown:
        if line == ELIDED:
            pieces.append([])
        else:
            pieces[-1].append(line)
    first, *middle, last = pieces
    at, stop = len(first), len(printed) - len(last)
    if at > stop or list(printed[:at]) != first or list(printed[stop:]) != last:
        return False
    for piece in middle:
        found = next((n for n in range(at, stop - len(piece) + 1) if list(printed[n : n + len(piece)]) == piece), None)
        if found is None:
            return False
        at = found + len(piece)
    return True


def rewritten(page: str, results: Sequence[tuple[Run, Sequence[str]]]) -> str:
    """The page with what was printed in the place of what it shows, where the two differ; what was left out stays so."""
    for run, printed in sorted(results, key=lambda result: -result[0].start):
        if not agrees(run.shown, printed):
            page = page[: run.start] + "".join(f"{line}\n" for line in _elided(run.shown, printed)) + page[run.end :]
    return page


def _elided(shown: Sequence[str], printed: Sequence[str]) -> Sequence[str]:
    """The lines printed, with those left out that stand where the lines shown have `…`; all of them where that is not clear."""
    kept: list[str] = []
    cuts: set[int] = set()
    for line in shown:
        if line == ELIDED:
            cuts.add(len(kept))
        else:
            kept.append(line)
    lines: list[str] = []
    for kind, a, b, c, d in SequenceMatcher(None, kept, printed, autojunk=False).get_opcodes():
        inside = sorted(cut for cut in cuts if a <= cut <= b)
        if kind == "equal" or not inside:
            lines += printed[c:d]
        else:
            before, after = inside[0] - a, b - inside[-1]
            lines += [*printed[c : min(c + before, d)], ELIDED, *printed[max(d - after, c + before) : d]]
    return lines if agrees(lines, printed) else printed
