# SPDX-License-Identifier: Apache-2.0
"""What is the same in every run of one installed rosward is made once, and kept in the user's cache folder.

    kept("models", _made)        what `_made` gave in an earlier run, else what it gives now; None where it gives nothing

Results of analyses are kept below the same folder, by the same rules (`cache/store.py`).

Nothing that is kept is executed, and a result never depends on whether something is kept. An entry that another rosward or another Python wrote,
that is damaged, or that somebody else could have written is made anew. The folder may be deleted at any time; ROSWARD_CACHE names another one, and
an empty ROSWARD_CACHE none: then nothing is kept.
"""

from __future__ import annotations

import hashlib
import os
import stat
import sys

from rosward._version import __version__

TYPE_CHECKING = False  # neither typing nor pathlib: this decides what else is loaded
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Final

__all__ = ["cache_folder", "kept", "program_key", "read_own", "write_own"]

_PACKAGE: Final = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # noqa: PTH100, PTH120  no Path where start-up counts
_SUFFIXES: Final = (".py", ".pyi", ".hpp", ".yaml", ".js", ".css", ".html", ".json")
_LARGEST: Final = 64 * 1024**2
_OTHERS: Final = 6
"""So many entries of other versions are left in the folder."""
_FORBIDDEN: Final = stat.S_IWGRP | stat.S_IWOTH
_DIGEST: Final = 32
_BINARY: Final = getattr(os, "O_BINARY", 0)
_READING: Final = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | _BINARY
_WRITING: Final = os.O_WRONLY | os.O_CREAT | os.O_EXCL | _BINARY

_KEYS: Final[list[str]] = []
"""What tells this rosward from others, once it was computed: the files of the package do not change while they run."""


def kept(name: str, make: Callable[[], bytes | None]) -> bytes | None:
    """What `make` gave when this rosward asked for it first. None where it gives nothing, or nothing can be kept: then it is not worth making."""
    folder = cache_folder()
    if folder is None or not _is_ready(folder):
        return None
    entry = f"{name}-{program_key()}"
    found = read_own(folder, entry)
    if found is None:
        found = make()
        if found is not None and write_own(folder, entry, found):
            _forget_others(folder, name, entry)
    return found


def cache_folder() -> str | None:
    """Where rosward keeps what it need not compute again; None where there is no such place."""
    named = os.environ.get("ROSWARD_CACHE")
    if named is not None:
        return named if os.path.isabs(named) else None  # noqa: PTH117
    base = os.environ.get("XDG_CACHE_HOME", "")
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA", "")
    elif not os.path.isabs(base):  # noqa: PTH117
        home = os.path.expanduser("~")  # noqa: PTH111
        base = os.path.join(home, "Library/Caches" if sys.platform == "darwin" else ".cache")  # noqa: PTH118
    return os.path.join(base, "rosward") if os.path.isabs(base) else None  # noqa: PTH117, PTH118


def read_own(folder: str | os.PathLike[str], entry: str) -> bytes | None:
    """What this user wrote under a name; None where it is not there, is damaged, or may be from somebody else."""
    try:
        if not _is_mine(os.stat(folder)):  # noqa: PTH116
            return None
        with os.fdopen(os.open(os.path.join(folder, entry), _READING), "rb") as file:  # noqa: PTH118
            about = os.fstat(file.fileno())
            if not stat.S_ISREG(about.st_mode) or about.st_size > _LARGEST or not _is_mine(about):
                return None
            data = file.read(_LARGEST)
    except OSError:
        return None
    content = data[_DIGEST:]
    return content if data[:_DIGEST] == _digest(content) else None


def write_own(folder: str | os.PathLike[str], entry: str, content: bytes) -> bool:
    """Write under a name, whole or not at all; False where that is not possible."""
    if not _is_ready(folder):
        return False
    place = os.path.join(folder, entry)  # noqa: PTH118
    new = f"{place}.{os.getpid()}.new"
    try:
        with os.fdopen(os.open(new, _WRITING, 0o600), "wb") as file:
            file.write(_digest(content) + content)
        os.replace(new, place)  # noqa: PTH105
    except OSError:
        try:  # noqa: SIM105
            os.unlink(new)  # noqa: PTH108
        except OSError:
            pass
        return False
    return True


def _digest(content: bytes) -> bytes:
    return hashlib.sha256(content).digest()


def _is_ready(folder: str | os.PathLike[str]) -> bool:
    """Whether this user alone can write into a folder, which is made where it is not there."""
    try:
        os.makedirs(folder, mode=0o700, exist_ok=True)  # noqa: PTH103
        return _is_mine(os.stat(folder)) and os.access(folder, os.W_OK)  # noqa: PTH116
    except OSError:
        return False


def _is_mine(about: os.stat_result) -> bool:
    return sys.platform == "win32" or (about.st_uid == os.geteuid() and not about.st_mode & _FORBIDDEN)


def _forget_others(folder: str | os.PathLike[str], name: str, entry: str) -> None:
    """Delete the oldest entries of other versions."""
    try:
        with os.scandir(folder) as found:
            others = [
                (e.stat().st_mtime_ns, e.path) for e in found if e.name.startswith(f"{name}-") and e.name != entry
            ]
        for _, path in sorted(others)[:-_OTHERS]:
            os.unlink(path)  # noqa: PTH108
    except OSError:
        return


def program_key() -> str:
    """What tells this rosward, in this Python, from others."""
    if not _KEYS:
        told = [__version__, sys.version, sys.implementation.name, *_state()]
        _KEYS.append(hashlib.sha256("\0".join(told).encode("utf-8", "surrogateescape")).hexdigest()[:_DIGEST])
    return _KEYS[0]


def _state() -> Iterator[str]:
    """The state of the package: the list of files and digests that pip wrote when it installed it; else size and time of each of its files.

    By such a list, the same rosward that is installed anew (as in each run of CI) is the same.
    """
    try:
        with open(f"{_PACKAGE}-{__version__}.dist-info/RECORD", encoding="utf-8") as file:  # noqa: PTH123
            yield file.read(_LARGEST)
    except (OSError, ValueError):
        yield from sorted(_files(_PACKAGE))


def _files(folder: str) -> Iterator[str]:
    with os.scandir(folder) as found:
        for entry in found:
            if entry.name.endswith(_SUFFIXES):
                about = entry.stat()
                yield f"{entry.path} {about.st_size} {about.st_mtime_ns}"
            elif "." not in entry.name and entry.name != "__pycache__" and entry.is_dir():
                yield from _files(entry.path)
