# SPDX-License-Identifier: Apache-2.0
"""What lies in a folder, and under which dotted name is a file imported?

    /ws/src/demo/package.xml, /ws/src/demo/demo/__init__.py, /ws/src/demo/demo/nodes/talker.py   ->  demo.nodes.talker
    /ws/src/demo/scripts/talker.py                                                                ->  talker

A `Layout` lists each folder at most once and remembers it for the length of an analysis.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from rosward.records import NamedTuple
from rosward.source import disk
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.exclude import Exclusions

if TYPE_CHECKING:
    from rosward.source.workspace import Package

_EMPTY: Final = frozenset[str]()
_MOST_FOLDERS: Final = 200
"""So many folders are looked at for a module, at most."""


class Listing(NamedTuple):
    """The modules (files named `*.py`, without suffix) and the folders in a folder."""

    modules: frozenset[str] = _EMPTY
    folders: frozenset[str] = _EMPTY

    @property
    def is_package(self) -> bool:
        """Whether the folder is a regular Python package."""
        return "__init__" in self.modules


@final
class Layout:
    """Folders as the file system has them, each listed once."""

    __slots__ = ("_boundary", "_excluded", "_listings")

    def __init__(self, excluded: Exclusions | None = None, boundary: Boundary = EVERYWHERE) -> None:
        self._listings: dict[str, Listing] = {}
        self._boundary = boundary
        self._excluded = excluded or Exclusions()

    def listing(self, folder: str) -> Listing:
        """What lies in `folder`; nothing, if it cannot be listed."""
        found = self._listings.get(folder)
        if found is None:
            found = self._listings[folder] = _list(folder, self._excluded, self._boundary)
        return found

    def holds_python(self, folder: str, *, inner: bool = False) -> bool:
        """Whether the folder, or one directly in it, holds Python modules, and so can be a namespace package.

        `inner`: it lies within a package, so modules further down are enough.
        """
        here = self.listing(folder)
        if here.modules or any(self.listing(f"{folder}{os.sep}{name}").is_package for name in sorted(here.folders)):
            return True
        return inner and self._holds_further_down(folder)

    def _holds_further_down(self, folder: str) -> bool:
        waiting = [folder]
        for seen in waiting:
            here = self.listing(seen)
            if here.modules:
                return True
            waiting += [f"{seen}{os.sep}{name}" for name in sorted(here.folders)][: _MOST_FOLDERS - len(waiting)]
        return False

    def python_root(self, folder: str, package: Package | None) -> str:
        """The folder from which a module in `folder` is imported.

        The outermost Python package below the ROS package decides; a folder with the name of its ROS package is one,
        with or without an `__init__.py`. Without a ROS package the chain of `__init__.py` upwards decides.
        """
        if package is None:
            while self.listing(folder).is_package and os.path.dirname(folder) != folder:  # noqa: PTH120
                folder = os.path.dirname(folder)  # noqa: PTH120
            return folder
        top = os.fspath(package.path)
        root = folder
        while folder != top and len(folder) > len(top):
            above = os.path.dirname(folder)  # noqa: PTH120
            named = above == top and os.path.basename(folder) == package.name  # noqa: PTH119
            if named or self.listing(folder).is_package:
                root = above
            folder = above
        return root

    def module_name(self, path: str, package: Package | None) -> str | None:
        """The dotted name of the file at `path`."""
        folder, _, name = path.rpartition(os.sep)
        stem, dot, suffix = name.rpartition(".")
        if not dot or suffix != "py":
            return None
        root = self.python_root(folder, package)
        parts = list(Path(folder[len(root) :].lstrip(os.sep)).parts)
        if stem != "__init__" or not parts:
            parts.append(stem)
        return ".".join(parts)


def _list(folder: str, excluded: Exclusions, boundary: Boundary) -> Listing:
    modules: set[str] = set()
    folders: set[str] = set()
    try:
        for entry in disk.listing(folder):
            if excluded and excluded.of(entry.path) is not None:
                continue
            if entry.is_symlink() and boundary.leads_out(entry.path):
                continue
            if entry.name.endswith(".py"):
                if entry.is_file():
                    modules.add(entry.name[:-3])
            elif entry.name.isidentifier() and entry.is_dir():
                folders.add(entry.name)
    except (OSError, ValueError):
        pass
    return Listing(frozenset(modules), frozenset(folders))
