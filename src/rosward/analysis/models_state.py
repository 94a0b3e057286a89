# SPDX-License-Identifier: Apache-2.0
"""Which stubs of the user are there? What they say decides what every process adds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Final

from rosward.source import disk, limits

__all__ = ["models_state", "stub_name"]

_MOST_FILES: Final = 10_000


class _NotSeenError(Exception):
    """Stubs may be found where nobody has looked."""


def models_state(folders: Sequence[str | PathLike[str]]) -> list[list[str]] | None:
    """What tells the stubs in some folders from any others; None where that is too much, or there are linked folders."""
    try:
        return [list(_stubs(Path(folder))) for folder in folders]
    except _NotSeenError:
        return None


def _stubs(folder: Path) -> Iterator[str]:
    wanted, entered, count = {fspath(folder)}, set[str](), 0
    for above, inner, names in disk.walk(folder):
        entered.add(above)
        wanted.update(fspath(Path(above, name)) for name in inner)
        for name in sorted(names):
            if name.endswith(".pyi"):
                count += 1
                if count > _MOST_FILES:
                    raise _NotSeenError
                file = Path(above, name)
                data = disk.read(file, limits.STUB_FILE)
                yield file.relative_to(folder).as_posix()
                yield data.why if isinstance(data, disk.Unread) else disk.digest(data)
    if wanted != entered:
        raise _NotSeenError


def stub_name(file: str) -> str:
    """The module that a stub file describes: 'models:demo/__init__.pyi' -> 'demo'."""
    return file.rpartition(":")[2].removesuffix(".pyi").removesuffix("/__init__").replace("/", ".")
