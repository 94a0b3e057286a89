# SPDX-License-Identifier: Apache-2.0
"""What does an analysis see of the disk, and is it still the same?

    with watching() as trace:
        discover(…), read_bytes(…)
    trace.seen      {("list", "/ws/src"): digest of its names, ("read 10000", "/ws/src/a.py"): digest of its bytes, ("kind", "/ws/b.py"): "", …}
    holds(trace.seen)    ->  whether whoever looks again sees the same, also of what is not there

Whatever reads sources asks here, so that a result can be kept together with all that it depends on. Nothing is noted where nobody watches.
"""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from types import MappingProxyType
from typing import Final, final

from rosward.records import NamedTuple
from rosward.source import same
from rosward.source.overlay import shown_instead
from rosward.source.same import FILE, FOLDER, kind_of, mark_of

__all__ = [
    "Look", "Trace", "Unread", "by_how", "digest", "exists", "head", "holds", "is_executable", "is_file", "is_folder", "is_there", "is_torn",
    "listing", "looks_of", "note_program", "read", "real_path", "saw_elsewhere", "tear", "walk", "watching", "wrote",
]  # fmt: skip

Look = tuple[str, str]
"""How something was looked at, and its path."""

_OPEN_FLAGS: Final = (
    os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0) | getattr(os, "O_BINARY", 0)
)


class Unread(NamedTuple):
    """Why a file is not read, as a sentence."""

    why: str
    too_large: bool = False


@final
class Trace:
    """What was seen: for each look, a short text that tells what was seen from anything else."""

    __slots__ = ("marks", "seen", "torn", "written")

    def __init__(self) -> None:
        self.seen: dict[Look, str] = {}
        self.marks: dict[str, str] = {}
        """By path, the state in which a file or folder was when it was read (`same.py`); '' where that may not tell a change."""
        self.torn = False
        """Whether something changed meanwhile, so that what was seen never was so at once; or what was found may not be found again."""
        self.written: list[tuple[str, str, bytes]] = []
        """What was written into output folders: folder, name and content."""

    def note(self, how: str, path: str, told: str) -> None:
        """Note what was seen."""
        known = self.seen.setdefault((how, path), told)
        if known is not told and known != told:
            self.torn = True

    def mark(self, path: str, status: os.stat_result) -> None:
        """Note in which state something is that is read now."""
        mark = mark_of(status)
        if self.marks.setdefault(path, mark) != mark:
            self.marks[path] = ""

    def join(self, other: Trace) -> None:
        """Note all that somebody else has noted."""
        self.add(other.seen)
        for path, mark in other.marks.items():
            if self.marks.setdefault(path, mark) != mark:
                self.marks[path] = ""
        self.torn |= other.torn
        self.written += other.written

    def add(self, seen: Mapping[Look, str]) -> None:
        """Note what was seen by somebody else."""
        for (how, path), told in seen.items():
            self.note(how, path, told)


_WATCHED_BY: Final[ContextVar[Trace | None]] = ContextVar("rosward.source.disk", default=None)


@contextmanager
def watching() -> Iterator[Trace]:
    """Note each look in this context, and in those that are copies of it; whoever watches already sees it, too."""
    trace, outer = Trace(), _WATCHED_BY.get()
    token = _WATCHED_BY.set(trace)
    try:
        yield trace
    finally:
        _WATCHED_BY.reset(token)
        if outer is not None:
            outer.join(trace)


def _kind(path: str | os.PathLike[str]) -> str:
    """What is at a path, links followed; '' for nothing, or what cannot be reached."""
    found = kind_of(path)
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.note("kind", os.fspath(path), found)
    return found


def is_file(path: str | os.PathLike[str]) -> bool:
    """Whether there is a regular file; links are followed. Never raises, however odd the path is."""
    return _kind(path) == FILE


def is_folder(path: str | os.PathLike[str]) -> bool:
    """Whether there is a folder; links are followed."""
    return _kind(path) == FOLDER


def exists(path: str | os.PathLike[str]) -> bool:
    """Whether there is anything; links are followed."""
    return _kind(path) != ""


def is_there(path: str | os.PathLike[str]) -> bool:
    """Whether there is anything, be it a link that leads nowhere."""
    found = same.is_there(path)
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.note("there", os.fspath(path), found)
    return found != ""


def is_executable(path: str | os.PathLike[str]) -> bool:
    """Whether a file may be executed."""
    found = same.is_executable(path)
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.note("executable", os.fspath(path), found)
    return found != ""


def real_path(path: str | os.PathLike[str]) -> str:
    """The path without links. Raises ValueError where it holds a NUL."""
    found = same.real_path(path)
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.note("real", os.fspath(path), found)
    return found


def listing(folder: str | os.PathLike[str]) -> list[os.DirEntry[str]]:
    """What is in a folder, sorted by name. Raises OSError, or ValueError where its path holds a NUL."""
    trace = _WATCHED_BY.get()
    path = os.fspath(folder)
    try:
        before = os.stat(path) if trace is not None else None  # noqa: PTH116
        with os.scandir(path) as entries:
            found = sorted(entries, key=lambda entry: entry.name)
    except OSError as error:
        if trace is not None:
            trace.note("list", path, f"!{error.strerror}")
        raise
    if trace is not None:
        text = "\0".join(f"{_letter(entry)}{entry.name}" for entry in found)
        trace.note("list", path, digest(text.encode("utf-8", "surrogateescape")))
        if before is not None and not any(
            entry.is_symlink() for entry in found
        ):  # where a link leads, the folder does not know
            trace.mark(path, before)
    return found


def _letter(entry: os.DirEntry[str]) -> str:
    """What an entry is, and what a link leads to."""
    try:
        inner = "d" if entry.is_dir() else "f" if entry.is_file() else "o"
    except OSError:  # a circle of links
        inner = "?"
    return inner.upper() if entry.is_symlink() else inner


def walk(top: str | os.PathLike[str]) -> Iterator[tuple[str, list[str], list[str]]]:
    """As `os.walk`, from the top: each folder with the names of the folders in it, which may be changed meanwhile, and of all else, sorted."""
    above = [os.fspath(top)]
    while above:
        folder = above.pop()
        try:
            entries = listing(folder)
        except OSError:
            continue
        inner: list[str] = []
        names: list[str] = []
        links: set[str] = set()
        for entry in entries:
            try:
                is_dir = entry.is_dir()
            except OSError:
                is_dir = False
            (inner if is_dir else names).append(entry.name)
            if is_dir and entry.is_symlink():
                links.add(entry.name)
        yield folder, inner, names
        above += [os.path.join(folder, name) for name in reversed(inner) if name not in links]  # noqa: PTH118


def head(path: str, length: int) -> bytes:
    """The first bytes of a file. Raises OSError."""
    trace = _WATCHED_BY.get()
    try:
        with open(path, "rb") as file:  # noqa: PTH123
            shown = shown_instead(path)
            if trace is not None and shown is None:
                trace.mark(path, os.fstat(file.fileno()))
            data = file.read(length) if shown is None else shown[:length]
    except OSError as error:
        if trace is not None:
            trace.note(f"head {length}", path, f"!{error.strerror}")
        raise
    if trace is not None:
        trace.note(f"head {length}", path, digest(data))
    return data


def read(path: str | os.PathLike[str], limit: int) -> bytes | Unread:
    """The bytes of a regular file, at most `limit` of them; else why not."""
    found = _read(path, limit)
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.note(f"read {limit}", os.fspath(path), _told(found))
    return found


def _told(found: bytes | Unread) -> str:
    return f"!{found.why}" if isinstance(found, Unread) else digest(found)


def _read(path: str | os.PathLike[str], limit: int) -> bytes | Unread:
    shown = shown_instead(path)
    if shown is not None:
        return shown if len(shown) <= limit else Unread(f"The file is larger than {limit:,} bytes.", too_large=True)
    try:
        kind = _not_regular(os.stat(path))  # noqa: PTH116
        if kind:
            return Unread(f"This is {kind}, not a text file.")
        descriptor = os.open(path, _OPEN_FLAGS)
        with open(descriptor, "rb", closefd=True) as stream:  # noqa: PTH123
            status = os.fstat(descriptor)
            kind = _not_regular(status)
            if kind:
                return Unread(f"This is {kind}, not a text file.")
            trace = _WATCHED_BY.get()
            if trace is not None:
                trace.mark(os.fspath(path), status)
            data = stream.read(limit + 1) if status.st_size <= limit else None
    except (OSError, ValueError) as error:
        reason = (isinstance(error, OSError) and error.strerror) or str(error)
        return Unread(f"The file cannot be read: {reason}.")
    if data is None or len(data) > limit:
        return Unread(f"The file is larger than {limit:,} bytes.", too_large=True)
    return data


def _not_regular(status: os.stat_result) -> str | None:
    """What the thing is, unless a regular file."""
    mode = status.st_mode
    if stat.S_ISREG(mode):
        return None
    for test, name in (
        (stat.S_ISDIR, "a folder"),
        (stat.S_ISFIFO, "a named pipe"),
        (stat.S_ISSOCK, "a socket"),
        (stat.S_ISCHR, "a device"),
        (stat.S_ISBLK, "a device"),
    ):
        if test(mode):
            return name
    return "something else"


def by_how(seen: Mapping[Look, str]) -> dict[str, dict[str, str]]:
    """The same as a document: what was seen, by how it was looked at, and by path."""
    found: dict[str, dict[str, str]] = {}
    for (how, path), told in seen.items():
        found.setdefault(how, {})[path] = told
    return found


def looks_of(document: Mapping[str, Mapping[str, str]]) -> dict[Look, str]:
    """The looks in such a document."""
    return {(how, path): told for how, paths in document.items() for path, told in paths.items()}


def saw_elsewhere(seen: Mapping[Look, str]) -> None:
    """Note what another process saw on behalf of this one."""
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.add(seen)


def is_torn() -> bool:
    """Whether something may have changed while it was looked at; so where nobody watches."""
    trace = _WATCHED_BY.get()
    return trace is None or trace.torn


def tear() -> None:
    """Note that what is found now may not be found again, be the disk the same: it is not to be kept."""
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.torn = True


def wrote(folder: str, name: str, content: bytes) -> None:
    """Note what was written into an output folder."""
    trace = _WATCHED_BY.get()
    if trace is not None:
        trace.written.append((folder, name, content))


def note_program(path: str) -> str:
    """Which program another process runs, by what the system says of its file."""
    trace, state = _WATCHED_BY.get(), same.state_of(path)
    if trace is not None:
        trace.note("program", path, state)
    return state


def digest(data: bytes) -> str:
    """A text that tells these bytes from any others."""
    return hashlib.blake2b(data, digest_size=20).hexdigest()


# Whether it is still the same


def holds(seen: Mapping[Look, str]) -> bool:
    """Whether each look sees what it saw then. A look that nobody knows sees something else."""
    whole: dict[str, tuple[int, str]] = {}  # files that several read, with bounds of their own, are read once
    with watching() as trace:
        for (how, path), told in seen.items():
            if how.startswith("read ") and how[5:].isdecimal():
                limit = int(how[5:])
                length, now = whole.get(path, (limit + 1, ""))
                if length > limit:
                    found = _read(path, limit)
                    now = _told(found)
                    if not isinstance(found, Unread):
                        whole[path] = len(found), now
                trace.note(how, path, now)
                if now != told:
                    return False
                continue
            with suppress(OSError, ValueError):  # that, too, was noted, if it was so then
                _look(how, path)
            if trace.seen.get((how, path)) != told:
                return False
    return not trace.torn


def _look(how: str, path: str) -> None:
    kind, _, number = how.partition(" ")
    if kind == "read":
        read(path, int(number))
    elif kind == "head":
        head(path, int(number))
    elif kind in _LOOKS:
        _LOOKS[kind](path)


_LOOKS: Final[Mapping[str, Callable[[str], object]]] = MappingProxyType(
    {
        "executable": is_executable, "kind": exists, "list": listing, "program": note_program, "real": real_path, "there": is_there,
    }
)  # fmt: skip
