# SPDX-License-Identifier: Apache-2.0
"""Do two machines have the same rosward?

The digest of the version, of the version of Python, and of all files of the package by their content: wherever and whenever it was installed.
"""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from rosward._version import __version__

__all__ = ["identity"]

_PACKAGE: Final = Path(__file__).parent.parent
_SUFFIXES: Final = (".py", ".pyi", ".yaml", ".json")
_KNOWN: Final[list[str]] = []
"""Once it was computed: the files of the package do not change while they run."""


def identity() -> str:
    """What the results of this rosward depend on, beside sources and options."""
    if not _KNOWN:
        digest = hashlib.sha256(f"{__version__} {sys.implementation.name} {sys.version_info[:2]}".encode())
        for path in sorted(_files()):
            content = hashlib.sha256(path.read_bytes()).hexdigest()
            digest.update(f"\n{path.relative_to(_PACKAGE).as_posix()} {content}".encode())
        _KNOWN.append(digest.hexdigest())
    return _KNOWN[0]


def _files() -> Iterator[Path]:
    for folder, folders, names in os.walk(_PACKAGE):
        folders[:] = [name for name in folders if name != "__pycache__"]
        yield from (Path(folder, name) for name in names if name.endswith(_SUFFIXES))
