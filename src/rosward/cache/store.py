# SPDX-License-Identifier: Apache-2.0
"""Where is what was found out kept, and for how long?

    store = Store("/home/me/.cache/rosward")
    store.keep("result", question, answer)        .cache/rosward/1/ab/result-ab12…/3f9c…
    store.kept("result", question, read)          what `read` makes of it

An entry is one file: a line with a digest of all that follows, then the compressed answer. One that is cut short, changed or of another form is
no entry. An answer is data for `codec.py`; nothing of it is executed. Two processes may write at once, and anybody may delete anything at any time.
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Final, NamedTuple, TypeVar, final

from rosward.source import disk

__all__ = ["MOST_BYTES", "Store", "usual_folder"]

T = TypeVar("T")

_FORM: Final = "1"
"""The form of the files; another one has a folder of its own."""

MOST_BYTES: Final = 512 * 1024 * 1024
_MOST_ENTRIES: Final = 20_000
_MOST_ANSWERS: Final = 3
"""Answers to one question: what it depends on may change to and fro, as when somebody looks at two branches in turn."""

_LARGEST: Final = 128 * 1024 * 1024
_MAGIC: Final = b"rosward cache "
_MADE: Final = ".new-"


def usual_folder(environment: Mapping[str, str] = os.environ) -> str | None:
    """Where caches of a user are on this system; None where there is no such place."""
    if sys.platform == "win32":
        above = environment.get("LOCALAPPDATA", "")
    elif sys.platform == "darwin":
        above = os.path.expanduser("~/Library/Caches")  # noqa: PTH111
    else:
        above = environment.get("XDG_CACHE_HOME", "")
        if not os.path.isabs(above):  # noqa: PTH117  the specification says to ignore such a one
            above = os.path.expanduser("~/.cache")  # noqa: PTH111
    return os.path.join(above, "rosward") if os.path.isabs(above) else None  # noqa: PTH117, PTH118


class _Entry(NamedTuple):
    """A file of the store."""

    used: int
    size: int
    path: str


@final
class Store:
    """Answers by questions, below a folder."""

    def __init__(self, folder: str, *, most_bytes: int = MOST_BYTES) -> None:
        self._folder = os.path.join(folder, _FORM)  # noqa: PTH118
        self._most_bytes = most_bytes
        self._wrote = False

    def kept(self, kind: str, question: bytes, accept: Callable[[bytes], T | None]) -> T | None:
        """What `accept` makes of the latest answer to a question of which it makes something, which then counts as used; else None."""
        for entry in sorted(_entries(self._place(kind, question)), reverse=True):
            answer = _read(entry.path)
            if answer is None:
                with suppress(OSError):
                    os.unlink(entry.path)  # noqa: PTH108
                continue
            found = accept(answer)
            if found is not None:
                with suppress(OSError):  # of somebody else, or on a disk that is only read
                    os.utime(entry.path)
                return found
        return None

    def keep(self, kind: str, question: bytes, answer: bytes) -> None:
        """Keep an answer; where that is not possible, nothing happens."""
        place = self._place(kind, question)
        name = hashlib.blake2b(answer, digest_size=12).hexdigest()
        packed = zlib.compress(answer, 1)
        if len(answer) > _LARGEST:
            return
        with suppress(OSError):
            os.makedirs(place, mode=0o700, exist_ok=True)  # noqa: PTH103
            handle, made = tempfile.mkstemp(dir=place, prefix=_MADE)
            try:
                with os.fdopen(handle, "wb") as file:
                    file.write(_MAGIC + _digest(packed) + b"\n" + packed)
                os.replace(made, os.path.join(place, name))  # noqa: PTH105, PTH118
            except BaseException:
                with suppress(OSError):
                    os.unlink(made)  # noqa: PTH108
                raise
            self._wrote = True
            for old in sorted(_entries(place), reverse=True)[_MOST_ANSWERS:]:
                os.unlink(old.path)  # noqa: PTH108

    def close(self) -> None:
        """Keep within bounds: what was not used for longest goes first."""
        if not self._wrote:
            return
        self._wrote = False
        entries = sorted((e for place in self._places() for e in _entries(place)), reverse=True)
        size = 0
        for number, entry in enumerate(entries):
            size += entry.size
            if size > self._most_bytes or number >= _MOST_ENTRIES:
                with suppress(OSError):
                    os.unlink(entry.path)  # noqa: PTH108
                    os.rmdir(os.path.dirname(entry.path))  # noqa: PTH106, PTH120

    def _place(self, kind: str, question: bytes) -> str:
        name = hashlib.blake2b(question, digest_size=20).hexdigest()
        return os.path.join(self._folder, name[:2], f"{kind}-{name}")  # noqa: PTH118

    def _places(self) -> Iterator[str]:
        for above in _names(self._folder):
            yield from _names(above)


def _names(folder: str) -> list[str]:
    try:
        with os.scandir(folder) as entries:
            return [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
    except OSError:
        return []


def _entries(place: str) -> list[_Entry]:
    found: list[_Entry] = []
    with suppress(OSError), os.scandir(place) as entries:
        for entry in entries:
            with suppress(OSError):
                status = entry.stat(follow_symlinks=False)
                found.append(_Entry(status.st_mtime_ns, status.st_size, entry.path))
    return found


def _digest(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=20).hexdigest().encode()


def _read(path: str) -> bytes | None:
    """The answer in a file, None where it holds none."""
    data = disk.read(path, _LARGEST)
    if isinstance(data, disk.Unread):
        return None
    head, _, packed = data.partition(b"\n")
    if head != _MAGIC + _digest(packed):
        return None
    unpacking = zlib.decompressobj()
    try:
        answer = unpacking.decompress(packed, _LARGEST)
    except zlib.error:
        return None
    return answer if unpacking.eof else None
