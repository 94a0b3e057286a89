# SPDX-License-Identifier: Apache-2.0
"""What does git say of a repository, when nothing that the repository configures may run?

    Git("/ws").commit("main")          ->  "9d1f…"
    Git("/ws").entries("9d1f…")        ->  Entry("100644", "blob", "77ab…", 812, "src/talker.py"), …
    Git("/ws").contents(["77ab…"])     ->  b"import rclpy…"

Only commands that read objects are used: no checkout, so no hook, filter, attribute or driver of a difference has a part in it. What is missing
in a partial clone is not fetched. What git prints is read to a bound only: a few objects can stand for endless trees.
"""

from __future__ import annotations

import os
import subprocess
import threading
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import IO, Final, final

from rosward.records import NamedTuple

__all__ = ["Git", "GitError", "TreeEntry"]

_SAFE: Final = (
    "--no-pager",
    "--no-replace-objects",
    *("-c", "core.fsmonitor=false"),
    *("-c", f"core.hooksPath={os.devnull}"),
    *("-c", "core.untrackedCache=false"),
    *("-c", "protocol.allow=never"),
    *("-c", "safe.bareRepository=explicit"),
)
_KEPT: Final = ("PATH", "HOME", "XDG_CONFIG_HOME", "TMPDIR", "GIT_CONFIG_GLOBAL", "GIT_CEILING_DIRECTORIES")
_SETTINGS: Final = {
    "GIT_ALLOW_PROTOCOL": "none",
    "GIT_CONFIG_NOSYSTEM": "1",
    "GIT_NO_LAZY_FETCH": "1",
    "GIT_NO_REPLACE_OBJECTS": "1",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_TERMINAL_PROMPT": "0",
    "LC_ALL": "C",
}
_MOST_ENTRIES: Final = 200_000
_LONGEST_LISTING: Final = 100_000_000
_LONGEST_ERROR: Final = 4_000
_MOST_ALTERNATES: Final = 50
_LONGEST_ALTERNATES: Final = 100_000
_PATIENCE: Final = 120.0
"""Seconds for one command."""


class GitError(Exception):
    """Git does not say it; the message says why."""


class TreeEntry(NamedTuple):
    """A file, symbolic link or submodule of a commit; `size` is None of a submodule."""

    mode: str
    kind: str
    name: str
    size: int | None
    path: str


@final
class Git:
    """The repository that a folder belongs to."""

    def __init__(self, folder: str) -> None:
        self._folder = folder
        self.top = self._line("rev-parse", "--show-toplevel")
        """The folder of the work tree."""
        self._check_alternates(Path(folder, self._line("rev-parse", "--git-path", "objects")))

    @staticmethod
    def _check_alternates(objects: Path) -> None:
        """Raise where objects are borrowed from more folders than anyone has: git compares each of them with all others."""
        known = [objects]
        for folder in known:
            try:
                listed = (folder / "info" / "alternates").read_bytes()[:_LONGEST_ALTERNATES].splitlines()
            except (OSError, ValueError):  # there is none, or a NUL in the path
                continue
            known += (folder / os.fsdecode(line) for line in listed if line and not line.startswith(b"#"))
            if len(known) > _MOST_ALTERNATES:
                raise GitError(f"the repository borrows objects from more than {_MOST_ALTERNATES} others")

    def commit(self, revision: str) -> str:
        """The name of a commit. Raises GitError."""
        if not revision or revision.startswith("-"):
            raise GitError(f"{revision!r} is not a revision")
        try:
            return self._line("rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
        except GitError as error:
            shallow = " (the clone is shallow: fetch more of the history)" if self._is_shallow() else ""
            said = f": {error}" if str(error) else ""
            raise GitError(f"there is no commit {revision!r}{shallow}{said}") from error

    def common(self, one: str, other: str) -> str:
        """The best common ancestor of two commits. Raises GitError."""
        try:
            return self._line("merge-base", one, other)
        except GitError as error:
            raise GitError(f"{one[:12]} and {other[:12]} have no common ancestor in this clone") from error

    def entries(self, commit: str) -> list[TreeEntry]:
        """All files of a commit. Raises GitError."""
        text = self._read("ls-tree", "-r", "-z", "--long", "--full-tree", commit)
        found = [_entry(line) for line in text.split(b"\0") if line]
        if len(found) > _MOST_ENTRIES:
            raise GitError(f"{commit[:12]} has more than {_MOST_ENTRIES:,} files")
        return found

    def work_tree(self) -> list[str]:
        """The files of the work tree that are not ignored, as paths below `top`. Raises GitError."""
        own = ("rev-parse", "--absolute-git-dir")
        if self._line(*own) != self._line("-C", self.top, *own):
            raise GitError(f"{self.top}, the configured work tree of the repository, belongs to another repository")
        text = self._read("-C", self.top, "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--full-name")
        paths = sorted({os.fsdecode(line) for line in text.split(b"\0") if line})
        if len(paths) > _MOST_ENTRIES:
            raise GitError(f"the work tree has more than {_MOST_ENTRIES:,} files")
        return paths

    def contents(self, names: Iterable[str]) -> Iterator[bytes]:
        """The content of each blob, in order. Raises GitError."""
        with self._start(["cat-file", "--batch"], subprocess.PIPE) as process:
            timer = threading.Timer(_PATIENCE * 5, process.kill)
            timer.start()
            try:
                if process.stdin is None or process.stdout is None:
                    raise GitError("git has no pipes")
                for name in names:
                    yield _content(name, process.stdin, process.stdout)
            except (OSError, ValueError) as error:
                raise GitError(f"git cat-file ended early: {error}") from error
            finally:
                timer.cancel()
                process.kill()

    def _is_shallow(self) -> bool:
        try:
            return self._line("rev-parse", "--is-shallow-repository") == "true"
        except GitError:
            return False

    def _line(self, *arguments: str) -> str:
        return os.fsdecode(self._read(*arguments)).removesuffix("\n")

    def _read(self, *arguments: str) -> bytes:
        with self._start(arguments, subprocess.DEVNULL) as process:
            timer = threading.Timer(_PATIENCE, process.kill)
            timer.start()
            try:
                if process.stdout is None or process.stderr is None:
                    raise GitError("git has no pipes")
                text = process.stdout.read(_LONGEST_LISTING + 1)
                if len(text) > _LONGEST_LISTING:
                    raise GitError(f"git {arguments[0]} prints more than {_LONGEST_LISTING:,} bytes")
                said = os.fsdecode(process.stderr.read(_LONGEST_ERROR)).strip()
                if process.wait():
                    raise GitError(_first_line(said))
            finally:
                timer.cancel()
                process.kill()
        return text

    def _start(self, arguments: Sequence[str], stdin: int) -> subprocess.Popen[bytes]:
        kept = {key: os.environ[key] for key in _KEPT if key in os.environ}
        try:
            return subprocess.Popen(
                ["git", *_SAFE, *arguments],
                cwd=self._folder,
                env={**kept, **_SETTINGS},
                stdin=stdin,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        except OSError as error:
            raise GitError(f"git cannot be started: {error.strerror or error}") from error


def _entry(line: bytes) -> TreeEntry:
    head, _, path = line.partition(b"\t")
    words = head.decode("ascii", "replace").split()
    if len(words) != 4 or not path:
        raise GitError("git lists files in an unknown form")
    mode, kind, name, size = words
    return TreeEntry(mode, kind, name, int(size) if size.isdecimal() else None, os.fsdecode(path))


def _content(name: str, requests: IO[bytes], answers: IO[bytes]) -> bytes:
    requests.write(f"{name}\n".encode("ascii"))
    requests.flush()
    head = answers.readline(1_000).split()
    if len(head) != 3 or not head[2].isdigit():
        raise GitError(f"object {name[:12]} is missing (in a partial clone, fetch it first)")
    size = int(head[2])
    data = answers.read(size + 1)
    if len(data) != size + 1:
        raise GitError(f"object {name[:12]} ends early")
    return data[:-1]


def _first_line(said: str) -> str:
    """What git complains of, and nothing of its advice but the one that decides."""
    first = said.partition("\n")[0].removeprefix("fatal: ")
    if "dubious ownership" in said:
        return f"{first}; if you trust it, run:  git config --global --add safe.directory FOLDER"
    return first
