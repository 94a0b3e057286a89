# SPDX-License-Identifier: Apache-2.0
"""Which files of a repository are in another one that was not fetched?

.gitmodules with `path = esw/fw`, and nothing in esw/fw   ->  nobody knows whether there is an esw/fw/lib
"""

from __future__ import annotations

import os
import re
from typing import Final

from rosward.source import disk

__all__ = ["is_not_fetched"]

_PATH: Final = re.compile(rb"^[ \t]*path[ \t]*=(.*)$", re.MULTILINE)
_LIMIT: Final = 1_000_000


def is_not_fetched(path: str, top: str) -> bool:
    """Whether a path leads into a submodule of a repository within `top` of which nothing is there."""
    folder = os.path.dirname(path)  # noqa: PTH120
    while True:
        file = os.path.join(folder, ".gitmodules")  # noqa: PTH118
        if disk.is_file(file):
            return any(_is_empty(each) for each in _named(file, folder) if (path + os.sep).startswith(each + os.sep))
        above = os.path.dirname(folder)  # noqa: PTH120
        if folder in (top, above):
            return False
        folder = above


def _named(file: str, folder: str) -> list[str]:
    """The folders of the submodules that a file names."""
    data = disk.read(file, _LIMIT)
    found = filter(None, map(bytes.strip, _PATH.findall(data))) if isinstance(data, bytes) else ()
    return [os.path.normpath(os.path.join(folder, os.fsdecode(each))) for each in found]  # noqa: PTH118


def _is_empty(folder: str) -> bool:
    return not disk.is_folder(folder) or not disk.listing(folder)
