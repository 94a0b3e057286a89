# SPDX-License-Identifier: Apache-2.0
"""Which files of a package does a pattern or a folder in its CMakeLists.txt name?

    glob("/ws/demo/scripts/*.py", recurse=False)  ->  ["/ws/demo/scripts/listener.py", "/ws/demo/scripts/talker.py"]

Nothing outside of the package is looked at, and only so many files within.
"""

from __future__ import annotations

import fnmatch
import os
import re
from typing import TYPE_CHECKING, Final, final

from rosward.source import disk

if TYPE_CHECKING:
    from collections.abc import Iterator

_LIMIT: Final = 20_000


@final
class PackageFiles:
    """The files below `top`; `exhausted` once more of them were asked for than are looked at."""

    __slots__ = ("_looked_at", "_top", "exhausted")

    def __init__(self, top: str) -> None:
        self._top = top
        self._looked_at = 0
        self.exhausted = False

    def inside(self, path: str, folder: str) -> str | None:
        """The absolute form of `path` as written in `folder`, if it is within the package."""
        full = os.path.normpath(os.path.join(folder, path))  # noqa: PTH118
        return full if "\0" not in full and (full == self._top or full.startswith(self._top + os.sep)) else None

    def glob(self, pattern: str, *, recurse: bool) -> list[str]:
        """The files that `file(GLOB)` or `file(GLOB_RECURSE)` gives for an absolute pattern within the package."""
        head, _, last = pattern.rpartition(os.sep)
        wildcard = re.search(r"[*?\[]", head)
        start = head[: head.rfind(os.sep, 0, wildcard.start())] if wildcard else head
        accepts = re.compile(fnmatch.translate(last)).match
        accepts_folder = re.compile(fnmatch.translate(head)).match
        found: list[str] = []
        for folder, inner, names in self._walk(start):
            depth = folder.count(os.sep) - head.count(os.sep)
            fits = accepts_folder(folder) is not None and (recurse or depth == 0)
            if fits or (recurse and folder.startswith(head + os.sep)):
                found += [f"{folder}{os.sep}{name}" for name in names if accepts(name)]
            if not recurse and depth >= 0:
                inner.clear()
        return found

    def file_glob(self, arguments: list[str], current: str, *, recurse: bool) -> list[str]:
        """What `file(GLOB name [RELATIVE folder] pattern…)` finds, where `current` is the folder of the description."""
        relative: str | None = None
        found: set[str] = set()
        rest = iter(arguments)
        for argument in rest:
            if argument == "RELATIVE":
                relative = os.path.normpath(os.path.join(current, next(rest, "")))  # noqa: PTH118
            elif argument == "LIST_DIRECTORIES":
                next(rest, None)
            elif argument not in {"CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"}:
                full = self.inside(argument, current)
                found.update(self.glob(full, recurse=recurse) if full is not None else ())
        return [os.path.relpath(path, relative) if relative else path for path in sorted(found)]

    def below(
        self, start: str, *, matching: list[str], unwanted: list[str], executable: bool
    ) -> Iterator[tuple[str, str]]:
        """Name and path of the files below `start` that fit a pattern, if there are any, and are not unwanted."""
        for folder, _, names in self._walk(start):
            for name in names:
                full = f"{folder}{os.sep}{name}"
                fits = not matching or any(fnmatch.fnmatchcase(name, pattern) for pattern in matching)
                fits = fits and not any(fnmatch.fnmatchcase(name, pattern) for pattern in unwanted)
                if fits and (not executable or disk.is_executable(full)):
                    yield name, full

    def _walk(self, start: str) -> Iterator[tuple[str, list[str], list[str]]]:
        for folder, inner, names in disk.walk(start):
            self._looked_at += len(inner) + len(names)
            if self._looked_at > _LIMIT:
                self.exhausted = True
                return
            inner.sort()
            yield folder, inner, sorted(names)
