# SPDX-License-Identifier: Apache-2.0
"""How does a file get into the output folder whole or not at all, and nowhere else?

    write_text("out", "policies/talker/policy.xml", text)    out/policies/talker/.rosward-k3w9x2ab  ->  out/policies/talker/policy.xml

A text is written beside its place and then put there in one step, so that readers see the old content or the new, and two runs into one
folder leave a file of one of them. What a run that was killed has left beside it is taken away by a later one. A symbolic link within the
output folder is not followed: it could lead anywhere.
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import BinaryIO, Final

__all__ = ["open_whole", "write_bytes", "write_text"]

_MARK: Final = ".rosward-"
_ABANDONED: Final = 3_600.0
"""Seconds after which nobody is still writing."""


def write_text(folder: str, name: str, text: str) -> str:
    """Write one file below a folder, whole or not at all; returns its path. Raises OSError."""
    return write_bytes(folder, name, text.encode())


def write_bytes(folder: str, name: str, content: bytes) -> str:
    """The same, for what is no text."""
    with open_whole(folder, name) as file:
        file.write(content)
    return str(Path(folder, *PurePosixPath(name).parts))


@contextlib.contextmanager
def open_whole(folder: str, name: str) -> Iterator[BinaryIO]:
    """A file to write to, which is at its place when the block ends, and never is if that raises. Raises OSError."""
    parts = PurePosixPath(name).parts
    if not parts or name.startswith("/") or ".." in parts or "\0" in name:
        raise OSError(errno.EINVAL, f"{name!r} is no file below a folder")
    place = Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    for part in parts[:-1]:
        place = place / part
        place.mkdir(exist_ok=True)
        if place.is_symlink():
            raise OSError(errno.ELOOP, f"{place} is a symbolic link, which is not followed", str(place))
    _tidy(place)
    handle, temporary = tempfile.mkstemp(dir=place, prefix=_MARK)
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
        os.chmod(temporary, 0o644)  # noqa: PTH101
        os.replace(temporary, place / parts[-1])  # noqa: PTH105
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)  # noqa: PTH108
        raise


def _tidy(folder: Path) -> None:
    """Take away what runs that were killed have left."""
    now = time.time()
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_MARK):
                status = entry.stat(follow_symlinks=False)
                if stat.S_ISREG(status.st_mode) and now - status.st_mtime > _ABANDONED:
                    os.unlink(entry.path)  # noqa: PTH108
