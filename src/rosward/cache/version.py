# SPDX-License-Identifier: Apache-2.0
"""Which rosward is this, and on what does it run? A result of another one says nothing of what this one would find.

An installed rosward is told by the list of its files that the installer left, with a digest of each. A checkout is told by the names, sizes and
times of its files: whoever works on it changes it without a new version.
"""

from __future__ import annotations

import hashlib
import os
import re
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from typing import Final

from rosward._version import __version__

__all__ = ["version_digest"]

_PACKAGE: Final = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # noqa: PTH100, PTH120
_LIBRARIES: Final = ("catkin_pkg", "yaml", "tomli", "tree_sitter", "tree_sitter_cpp", "jinja2", "graphviz_pure")
"""The modules of other projects on which results depend, or what is written of them."""

_THEIR_NAMES: Final = re.compile(
    r"(?:catkin.pkg|pyyaml|tomli|tree.sitter(?:.cpp)?|jinja2|graphviz.pure)-.*\.(?:dist|egg)-info", re.IGNORECASE
)
_RECORD: Final = re.compile(r"rosward-.*\.dist-info")


def version_digest() -> bytes:
    """What tells this program, its libraries and its Python from others."""
    found = hashlib.blake2b(digest_size=20)
    for part in (__version__, sys.version, sys.platform, *_libraries(), *(_installed() or _files(_PACKAGE))):
        found.update(f"{len(part)} {part}".encode("utf-8", "surrogateescape"))
    return found.digest()


def _libraries() -> Iterator[str]:
    """Names and versions of libraries, as they are installed."""
    folders: dict[str, None] = {}
    for name in _LIBRARIES:
        spec = find_spec(name)
        if spec is None or spec.origin is None:
            yield f"no {name}"
        else:
            folder = os.path.dirname(spec.origin)  # noqa: PTH120
            folders[os.path.dirname(folder) if spec.submodule_search_locations else folder] = None  # noqa: PTH120
    for folder in folders:
        yield from sorted(name for name in _names(folder) if _THEIR_NAMES.fullmatch(name))


def _installed() -> list[str]:
    """The record of the installer, where it is about this package."""
    above = os.path.dirname(_PACKAGE)  # noqa: PTH120
    for name in _names(above):
        if _RECORD.fullmatch(name):
            try:
                with open(os.path.join(above, name, "RECORD"), encoding="utf-8") as file:  # noqa: PTH118, PTH123
                    text = file.read()
            except (OSError, ValueError):
                continue
            if "\nrosward/" in f"\n{text}":
                return [text]
    return []


def _names(folder: str) -> list[str]:
    try:
        return os.listdir(folder)  # noqa: PTH208
    except OSError:
        return []


def _files(folder: str) -> Iterator[str]:
    """Name, size and time of each file below a folder."""
    with os.scandir(folder) as entries:
        ordered = sorted(entries, key=lambda entry: entry.name)
    for entry in ordered:
        if entry.is_dir(follow_symlinks=False):
            if entry.name != "__pycache__":
                yield from _files(entry.path)
        else:
            status = entry.stat()
            yield f"{entry.path} {status.st_size} {status.st_mtime_ns}"
