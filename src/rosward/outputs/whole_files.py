# SPDX-License-Identifier: Apache-2.0
"""How does a file get into the output folder whole or not at all, and nowhere else?

    write_text("out", "policies/talker/policy.xml", text)    out/policies/talker/.rosward-k3w9x2ab  ->  out/policies/talker/policy.xml

A text is written beside its place and then put there in one step, so that readers see the old content or the new, and two runs into one
folder leave a file of one of them. What a run that was killed has left beside it is taken away by a later one. A symbolic link within the
output folder is not followed: it could lead anywhere.
"""

from __future__ import annotations

import errno
import os
import stat
import time

TYPE_CHECKING = False  # neither typing nor pathlib: a command that says again what it said before loads little
if TYPE_CHECKING:
    from typing import Final

__all__ = ["WholeFile", "write_bytes", "write_text"]

_MARK: Final = ".rosward-"
_ABANDONED: Final = 3_600.0
"""Seconds after which nobody is still writing."""
_MODE: Final = 0o644
_READING: Final = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
_WRITING: Final = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)


def write_text(folder: str, name: str, text: str) -> str:
    """Write one file below a folder, whole or not at all; returns its path. Raises OSError."""
    return write_bytes(folder, name, text.encode())


def write_bytes(folder: str, name: str, content: bytes) -> str:
    """The same with what is no text, or is one as it stands in the file."""
    place = _place(folder, name)
    if not _holds(place[1], content):
        with WholeFile(folder, name, place) as file:
            file.target.write(content)
    return place[1]


class WholeFile:
    """A file to write to, which is at its place when the block ends, and never is if that raises. Raises OSError."""

    def __init__(self, folder: str, name: str, known: tuple[str, str] | None = None) -> None:
        place, self.path = known or _place(folder, name)
        self._temporary = os.path.join(place, f"{_MARK}{os.urandom(8).hex()}")  # noqa: PTH118
        self.target = os.fdopen(os.open(self._temporary, _WRITING, 0o600), "wb")

    def __enter__(self) -> WholeFile:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            self.target.close()
            if kind is None:
                os.chmod(self._temporary, _MODE)  # noqa: PTH101
                os.replace(self._temporary, self.path)  # noqa: PTH105
        except BaseException:
            self._remove()
            raise
        if kind is not None:
            self._remove()

    def _remove(self) -> None:
        try:  # noqa: SIM105
            os.unlink(self._temporary)  # noqa: PTH108
        except OSError:
            pass


def _holds(path: str, content: bytes) -> bool:
    """Whether a file has this content already, and is as if it had been written now, which its times then say.

    To put a file in the place of another one makes some file systems wait for the disk, which takes longer than to write it.
    """
    try:
        with os.fdopen(os.open(path, _READING), "rb") as file:
            status = os.fstat(file.fileno())
            if (
                not stat.S_ISREG(status.st_mode)
                or stat.S_IMODE(status.st_mode) != _MODE
                or status.st_nlink != 1
                or status.st_uid != _own_user()
                or status.st_size != len(content)
                or file.read(len(content) + 1) != content
            ):
                return False
            os.utime(path, follow_symlinks=False)
    except (OSError, NotImplementedError):
        return False
    return True


def _own_user() -> int:
    return os.geteuid() if hasattr(os, "geteuid") else 0


def _place(folder: str, name: str) -> tuple[str, str]:
    """The folder of a file, which is made, and its path."""
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if not parts or name.startswith("/") or ".." in parts or "\0" in name:
        raise OSError(errno.EINVAL, f"{name!r} is no file below a folder")
    place = os.path.normpath(folder) if folder else "."
    os.makedirs(place, exist_ok=True)  # noqa: PTH103
    for part in parts[:-1]:
        place = os.path.join(place, part)  # noqa: PTH118
        try:
            os.mkdir(place)  # noqa: PTH102
        except FileExistsError:
            if not os.path.isdir(place):  # noqa: PTH112
                raise
        if os.path.islink(place):  # noqa: PTH114
            raise OSError(errno.ELOOP, f"{place} is a symbolic link, which is not followed", place)
    _tidy(place)
    path = os.path.join(place, parts[-1]) if place != "." else parts[-1]  # noqa: PTH118
    return place, path


def _tidy(folder: str) -> None:
    """Take away what runs that were killed have left."""
    now = time.time()
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name.startswith(_MARK):
                    status = entry.stat(follow_symlinks=False)
                    if stat.S_ISREG(status.st_mode) and now - status.st_mtime > _ABANDONED:
                        os.unlink(entry.path)  # noqa: PTH108
    except OSError:  # somebody else has taken it away
        pass
