# SPDX-License-Identifier: Apache-2.0
"""How are folders made and taken away that are nested as deep as somebody likes? One after the other: nothing here recurses."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator

__all__ = ["make_folders", "scratch_folder"]


def make_folders(path: str) -> None:
    """A folder and those around it, where they are missing. Raises OSError."""
    missing: list[str] = []
    while not os.path.isdir(path):  # noqa: PTH112
        missing.append(path)
        path = os.path.dirname(path)  # noqa: PTH120
    for each in reversed(missing):
        os.mkdir(each)  # noqa: PTH102


@contextlib.contextmanager
def scratch_folder() -> Iterator[str]:
    """A new folder that is gone behind the block, with all that is in it."""
    folder = tempfile.mkdtemp(prefix="rosward-")
    try:
        yield folder
    finally:
        _take_away(folder)


def _take_away(top: str) -> None:
    work, folders = [top], []
    while work:
        folder = work.pop()
        folders.append(folder)
        with contextlib.suppress(OSError), os.scandir(folder) as entries:
            for entry in entries:
                if entry.is_dir(follow_symlinks=False):
                    work.append(entry.path)
                else:
                    os.unlink(entry.path)  # noqa: PTH108
    for folder in reversed(folders):
        with contextlib.suppress(OSError):
            os.rmdir(folder)  # noqa: PTH106
