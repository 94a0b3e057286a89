# SPDX-License-Identifier: Apache-2.0
"""Which files and folders does `glob.glob(pattern)` name, run in the folder of a package?

    glob("/ws/demo", "launch/*.launch.py", recursive=False)  ->  ["launch/robot.launch.py", "launch/sim.launch.py"]

As Python's own: a leading dot must be written, `**` means any depth only if `recursive`. Nothing outside of the folder is looked at, and only so
much of it.
"""

from __future__ import annotations

import fnmatch
import os
from collections.abc import Iterator
from typing import Final

from rosward.source import disk

_LIMIT: Final = 20_000
_MAGIC: Final = frozenset("*?[")


def glob(top: str, pattern: str, *, recursive: bool) -> list[str] | None:
    """The paths relative to `top`, sorted; None where the pattern leads outside, or to more than is looked at."""
    parts = [part for part in pattern.split("/") if part not in ("", ".")]
    if pattern.startswith("/") or ".." in parts or "\0" in pattern or len(parts) > 50:
        return None
    found = [""]
    looked_at = 0
    for index, part in enumerate(parts):
        last = index == len(parts) - 1
        following: dict[str, None] = {}
        for folder in found:
            for name in _matches(os.path.join(top, folder), part, recursive=recursive):  # noqa: PTH118
                looked_at += 1
                if looked_at > _LIMIT:
                    return None
                path = f"{folder}/{name}" if folder and name else folder or name
                if last or disk.is_folder(os.path.join(top, path)):  # noqa: PTH118
                    following[path] = None
        found = list(following)
    return sorted(path for path in found if path)


def _matches(folder: str, part: str, *, recursive: bool) -> Iterator[str]:
    if part == "**" and recursive:
        yield ""
        for inner, folders, names in disk.walk(folder):
            folders[:] = sorted(name for name in folders if not name.startswith("."))
            relative = os.path.relpath(inner, folder)
            for name in (*folders, *names):
                if not name.startswith("."):
                    yield name if relative == "." else f"{relative}/{name}"
    elif _MAGIC.isdisjoint(part):
        if disk.is_there(os.path.join(folder, part)):  # noqa: PTH118
            yield part
    else:
        try:
            names = [entry.name for entry in disk.listing(folder)]
        except OSError:
            return
        yield from (
            name
            for name in names
            if fnmatch.fnmatchcase(name, part) and (part.startswith(".") or not name.startswith("."))
        )
