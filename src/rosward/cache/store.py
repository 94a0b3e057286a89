# SPDX-License-Identifier: Apache-2.0
"""Where is what was found out kept, and for how long?

    store = Store("/home/me/.cache/rosward")
    store.keep("result", question, answer)        .cache/rosward/results-1/ab/result-ab12…/3f9c…
    store.kept("result", question, read)          what `read` makes of it

An entry is one file with a digest of its content, which is the compressed answer; `source/kept.py` writes and reads it, and refuses one that is cut
short, changed, or may be from somebody else. An answer is data for `codec.py`; nothing of it is executed. Two processes may write at once, and
anybody may delete anything at any time.
"""

from __future__ import annotations

import hashlib
import os
import zlib

from rosward.source.kept import read_own, write_own

TYPE_CHECKING = False  # not from typing: this decides what else is loaded
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Final, TypeAlias, TypeVar

    T = TypeVar("T")
    _Entry: TypeAlias = tuple[int, int, str]
    """When a file of the store was used, its size and its path."""

__all__ = ["MOST_BYTES", "Store"]

_FORM: Final = "results-1"
"""The form of the files; another one has a folder of its own."""

MOST_BYTES: Final = 512 * 1024 * 1024
_MOST_ENTRIES: Final = 20_000
_MOST_ANSWERS: Final = 3
"""Answers to one question: what it depends on may change to and fro, as when somebody looks at two branches in turn."""

_LARGEST: Final = 128 * 1024 * 1024


class Store:
    """Answers by questions, below a folder."""

    def __init__(self, folder: str, *, most_bytes: int = MOST_BYTES) -> None:
        self._folder = os.path.join(folder, _FORM)  # noqa: PTH118
        self._most_bytes = most_bytes
        self._wrote = False

    def kept(self, kind: str, question: bytes, accept: Callable[[bytes], T | None]) -> T | None:
        """What `accept` makes of the latest answer to a question of which it makes something, which then counts as used; else None."""
        for _, _, path in sorted(_entries(self._place(kind, question)), reverse=True):
            answer = _read(path)
            if answer is None:
                _forget(path)
                continue
            found = accept(answer)
            if found is not None:
                try:  # noqa: SIM105
                    os.utime(path)
                except OSError:  # of somebody else, or on a disk that is only read
                    pass
                return found
        return None

    def keep(self, kind: str, question: bytes, answer: bytes) -> None:
        """Keep an answer; where that is not possible, nothing happens."""
        if len(answer) > _LARGEST:
            return
        place = self._place(kind, question)
        if write_own(place, hashlib.blake2b(answer, digest_size=12).hexdigest(), zlib.compress(answer, 1)):
            self._wrote = True
            for _, _, path in sorted(_entries(place), reverse=True)[_MOST_ANSWERS:]:
                _forget(path)

    def close(self) -> None:
        """Keep within bounds: what was not used for longest goes first."""
        if not self._wrote:
            return
        self._wrote = False
        entries = sorted((e for place in self._places() for e in _entries(place)), reverse=True)
        size = 0
        for number, (_, length, path) in enumerate(entries):
            size += length
            if size > self._most_bytes or number >= _MOST_ENTRIES:
                _forget(path)
                try:  # noqa: SIM105
                    os.rmdir(os.path.dirname(path))  # noqa: PTH106, PTH120
                except OSError:  # there are others in it
                    pass

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
    try:
        with os.scandir(place) as entries:
            for entry in entries:
                status = entry.stat(follow_symlinks=False)
                found.append((status.st_mtime_ns, status.st_size, entry.path))
    except OSError:  # it is not there, or somebody deletes it
        pass
    return found


def _forget(path: str) -> None:
    try:  # noqa: SIM105
        os.unlink(path)  # noqa: PTH108
    except OSError:
        pass


def _read(path: str) -> bytes | None:
    """The answer in a file, None where it holds none."""
    folder, name = os.path.split(path)
    packed = read_own(folder, name)
    if packed is None:
        return None
    unpacking = zlib.decompressobj()
    try:
        answer = unpacking.decompress(packed, _LARGEST)
    except zlib.error:
        return None
    return answer if unpacking.eof else None
