# SPDX-License-Identifier: Apache-2.0
"""Is a file or folder still the same, by what the system says of it alone?

    mark_of(os.stat("a.py"))       "120 1700000000000000000 …", and "" where it was changed a moment ago: by its times it may change unseen
    unsure(looks)                  the looks that have to be taken anew; None where something has changed

A mark only saves reading: where it differs, the content decides (`disk.holds`), so that a fresh checkout is the same. This module imports next to
nothing: it decides whether anything else is loaded.
"""

from __future__ import annotations

import os
import stat
import time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Final

__all__ = [
    "FILE",
    "FOLDER",
    "OTHER",
    "is_executable",
    "is_there",
    "kind_of",
    "mark_of",
    "real_path",
    "state_of",
    "unsure",
]

FILE: Final = "file"
FOLDER: Final = "folder"
OTHER: Final = "other"

_MOMENT: Final = 2 * 10**9
"""Nanoseconds: two changes that are nearer to each other may have the same times."""

_TELLS: Final = os.name == "posix"
"""Whether the system has a time of each change that nobody can set."""


def kind_of(path: str | os.PathLike[str]) -> str:
    """What is at a path, links followed; '' for nothing, or what cannot be reached."""
    try:
        mode = os.stat(path).st_mode  # noqa: PTH116
    except (OSError, ValueError):
        return ""
    return FILE if stat.S_ISREG(mode) else FOLDER if stat.S_ISDIR(mode) else OTHER


def mark_of(status: os.stat_result) -> str:
    """What tells this state of a file or folder from later ones, asked before it is read."""
    if not _TELLS or max(status.st_mtime_ns, status.st_ctime_ns) > time.time_ns() - _MOMENT:
        return ""
    return _told(status)


def _told(status: os.stat_result) -> str:
    return f"{status.st_size} {status.st_mtime_ns} {status.st_ctime_ns} {status.st_ino} {status.st_dev}"


def unsure(looks: Iterable[tuple[str, str, str, str]]) -> dict[tuple[str, str], str] | None:
    """Of looks (how, path, what was seen, mark), those of which only a new one can say whether it sees the same; None where one does not.

    Raises ValueError for a look that has no meaning.
    """
    left: dict[tuple[str, str], str] = {}
    for how, path, told, mark in looks:
        if mark:
            try:
                now = _told(os.stat(path))  # noqa: PTH116
            except (OSError, ValueError):
                now = ""
            if now != mark:
                left[how, path] = told
        elif how == "list" and told.startswith("!"):
            if _refusal(path) != told:
                return None
        elif how not in _QUICK:
            left[how, path] = told
        elif _QUICK[how](path) != told:
            return None
    return left


def _refusal(folder: str) -> str:
    """Why a folder is not listed, as that is noted; '' where it is."""
    try:
        os.scandir(folder).close()
    except OSError as error:
        return f"!{error.strerror}"
    return ""


def is_there(path: str | os.PathLike[str]) -> str:
    """'yes' where there is anything, be it a link that leads nowhere; else ''."""
    return "yes" if os.path.lexists(path) else ""


def is_executable(path: str | os.PathLike[str]) -> str:
    """'yes' for a file that may be executed, else ''."""
    return "yes" if os.access(path, os.X_OK) else ""


def state_of(path: str) -> str:
    """Size and time of a file, '' where there is none."""
    try:
        status = os.stat(path)  # noqa: PTH116
    except (OSError, ValueError):
        return ""
    return f"{status.st_size} {status.st_mtime_ns}"


def real_path(path: str | os.PathLike[str]) -> str:
    """The path without links. Raises ValueError where it holds a NUL."""
    return os.fspath(os.path.realpath(path))


_QUICK: Final[Mapping[str, Callable[[str], str]]] = {
    "executable": is_executable,
    "kind": kind_of,
    "program": state_of,
    "real": real_path,
    "there": is_there,
}
"""Looks that read nothing, as they are noted."""
