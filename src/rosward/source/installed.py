# SPDX-License-Identifier: Apache-2.0
"""Which file stands at a path below the share folder of a package?

    setup.py: data_files=[("share/demo/launch", glob("start/*.launch.py"))]
    Installed(workspace).share("demo", "launch/robot.launch.py")    ->  src/demo/start/robot.launch.py

The build descriptions say what is installed where. Where they say nothing of a path, the same path in the package's folder is taken, and at last
the only file of that name in the package: many packages are installed by means that cannot be told without running them. Packages that are not
among the sources are looked for in the underlays, nearest first: other workspaces, or install prefixes as /opt/ros/jazzy, in which a file is looked
for when it is asked for, and not before.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final, Protocol, final

from rosward.findings import Finding
from rosward.location import names_of_path
from rosward.source import disk, limits
from rosward.source.discover import discover
from rosward.source.text import place_name, read_bytes
from rosward.source.workspace import Package, SourceFile, Workspace

_PACKAGE: Final = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,200}")
_LIMIT: Final = 20_000
_PATH_LIMIT: Final = 4096

_PREFIX_MARKS: Final = (
    ".colcon_install_layout",
    "local_setup.bash",
    "local_setup.sh",
    "share/ament_index",
    "setup.bash",
)


class _Layer(Protocol):
    """A workspace or an install prefix."""

    def has(self, package: str) -> bool:
        """Whether the package is there."""

    def share(self, package: str, relative: str) -> SourceFile | None:
        """The file at `relative` below the package's share folder."""

    def is_folder(self, package: str, relative: str) -> bool:
        """Whether there is surely a folder at `relative`."""

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """The names in that folder, sorted; None where they are not all known."""


@final
class Installed:
    """The share folders of all packages, as if the workspace were installed over its underlays."""

    def __init__(self, workspace: Workspace, underlays: Sequence[Path] = ()) -> None:
        self._workspace = workspace
        self._sources = _SourceWorkspace(workspace, absolute=False)
        self._environment = workspace.environment
        self._underlays = [Path(os.path.abspath(path)) for path in underlays]  # noqa: PTH100
        self._layers: list[_Layer] | None = None
        self._handed_out: dict[str, SourceFile] = {}
        self._places: dict[str, tuple[str, str]] = {}

    def has_package(self, name: str) -> bool:
        """Whether a package is in the workspace or an underlay."""
        return self._layer(name) is not None

    def share(self, package: str, relative: str) -> SourceFile | None:
        """The file at `relative` (`launch/a.launch.py`) below the share folder of a package."""
        layer, path = self._layer(package), _normal(relative)
        found = layer.share(package, path) if layer is not None and path else None
        if found is not None:
            self._handed_out.setdefault(found.relative, found)
            self._places.setdefault(found.relative, (package, path or ""))
        return found

    def is_folder(self, package: str, relative: str) -> bool:
        """Whether a package surely has a folder at `relative`."""
        layer, path = self._layer(package), _normal(relative)
        return layer is not None and path is not None and layer.is_folder(package, path)

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """The names of what is in a folder below the share folder, sorted; None where they are not all known."""
        layer, path = self._layer(package), _normal(relative)
        return layer.listing(package, path) if layer is not None and path else None

    def modules(self, relative: str) -> tuple[str, ...]:
        """The files in Python, and the folders with such, in a folder below that which all sources have in common, sorted."""
        path = _normal(relative)
        return () if path is None else self._sources.modules(path)

    def source(self, relative: str) -> SourceFile | None:
        """The file at `relative` below the folder that all sources have in common."""
        path = _normal(relative)
        found = self._sources.at(os.path.join(self._workspace.root, path)) if path else None  # noqa: PTH118
        if found is not None:
            self._handed_out.setdefault(found.relative, found)
        return found

    def is_file(self, package: str, relative: str) -> bool:
        """Whether there surely is a file at `relative`; `package` is '' for the folder of the sources, as in `read`."""
        return self._find(package, relative) is not None

    def read(self, package: str, relative: str) -> str | None:
        """The text of a file; None where there is none, or it is too large or no text."""
        file = self._find(package, relative)
        return None if file is None else self.text(file)

    @staticmethod
    def text(file: SourceFile) -> str | None:
        """The text of a file as `open` reads it; None where it is too large or no text."""
        data = read_bytes(file.path, file.relative, limits.DATA_FILE)
        if isinstance(data, Finding) or b"\0" in data:
            return None
        try:
            return data.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
        except UnicodeDecodeError:
            return None

    def _find(self, package: str, relative: str) -> SourceFile | None:
        return self.share(package, relative) if package else self.source(relative)

    def name_of(self, package: str, relative: str) -> str | None:
        """The name of a file as `file` knows it; None where there is none."""
        found = self._find(package, relative)
        return None if found is None else found.relative

    def file(self, name: str) -> SourceFile | None:
        """The file of a name that was handed out before, or that is a file of the workspace."""
        return self._handed_out.get(name) or self._sources.named(name)

    def place_of(self, name: str) -> tuple[str, str] | None:
        """The package and the path below its share folder at which the file of that name is installed."""
        known = self._places.get(name)
        if known is not None:
            return known
        file = self._sources.named(name)
        return None if file is None else self._sources.place_of(file)

    def _layer(self, package: str) -> _Layer | None:
        if not _PACKAGE.fullmatch(package):
            return None
        if self._sources.has(package):
            return self._sources
        if self._layers is None:
            self._layers = [_layer(path, self._environment) for path in self._underlays]
        return next((layer for layer in self._layers if layer.has(package)), None)


def _normal(relative: str) -> str | None:
    """The path without `.` and `..`; None where it leads outside."""
    names = names_of_path(relative)
    try:
        too_long = len(os.fsencode(relative)) > _PATH_LIMIT
    except UnicodeEncodeError:
        return None
    return None if names is None or "\0" in relative or too_long else "/".join(names)


def _layer(path: Path, environment: Mapping[str, str]) -> _Layer:
    if any(disk.exists(path / mark) for mark in _PREFIX_MARKS):
        return _Prefix(path)
    return _SourceWorkspace(discover([path], environment=environment), absolute=True)


@final
class _SourceWorkspace:
    """A workspace of sources; the files of another one than that which is analysed have absolute names."""

    def __init__(self, workspace: Workspace, *, absolute: bool) -> None:
        self._root = os.fspath(workspace.root)
        self._real_root = disk.real_path(self._root)
        self._absolute = absolute
        self._excluded = workspace.excluded
        self._packages: dict[str, list[Package]] = {}
        for package in workspace.packages:
            self._packages.setdefault(package.name, []).append(package)
        known = (*workspace.files, *workspace.launch_files, *workspace.interface_files)
        self._files = {} if absolute else {os.fspath(file.path): file for file in known}
        self._names = {file.relative: file for file in self._files.values()}
        self._by_name: dict[Package, dict[str, list[str]]] = {}

    def has(self, package: str) -> bool:
        """Whether the package is there."""
        return package in self._packages

    def modules(self, folder: str) -> tuple[str, ...]:
        """The files in Python, and the folders with such, in a folder of the sources, sorted."""
        inside = f"{folder}/" if folder else ""
        found = (
            name[len(inside) :].partition("/")[0]
            for name in self._names
            if name.startswith(inside) and name.endswith(".py")
        )
        return tuple(sorted(set(found)))

    def share(self, package: str, relative: str) -> SourceFile | None:
        """The file at `relative` below the package's share folder."""
        for each in self._packages.get(package, ()):
            for path in (*_installed(each, relative), os.path.join(each.path, relative)):  # noqa: PTH118
                found = self.at(path, each)
                if found is not None:
                    return found
        for each in self._packages.get(package, ()):
            same = self._same_names(each).get(relative.rpartition("/")[2], ())
            found = self.at(same[0], each) if len(same) == 1 else None
            if found is not None:
                return found
        return None

    def is_folder(self, package: str, relative: str) -> bool:
        """Whether there is surely a folder at `relative`."""
        if not relative:
            return package in self._packages
        return any(
            any(shared.target.startswith(f"{relative}/") for shared in each.shared)
            or any(self._inside(path, each) and disk.is_folder(path) for path in _installed(each, relative))
            for each in self._packages.get(package, ())
        )

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """The names in that folder, sorted; None where they are not all known."""
        packages = self._packages.get(package, ())
        if len(packages) != 1 or not packages[0].all_shared or not relative:
            return None
        names: set[str] = set()
        for shared in packages[0].shared:
            if shared.target.startswith(f"{relative}/"):
                names.add(shared.target[len(relative) + 1 :].partition("/")[0])
                continue
            rest = _rest(shared.target, relative)
            folder = shared.source if not rest else f"{shared.source}/{rest}"
            if rest is None or not self._inside(folder, packages[0]):
                continue
            inside = _names_in(folder)
            if inside is None:
                continue
            if not shared.whole or len(inside) > _LIMIT:
                return None
            names.update(inside)
        return tuple(sorted(names)) or None

    def at(self, path: str, package: Package | None = None) -> SourceFile | None:
        """The file at a path, unless it (or what it links to) is outside of the workspace."""
        if path not in self._files:
            if not self._inside(path, package) or not disk.is_file(path):
                return None
            if self._excluded.of(path) is not None:
                return None
            name = "/" + place_name(path, "/") if self._absolute else place_name(path, self._root)
            file = SourceFile(Path(path), name, package or self._owner(path))
            self._files[path] = self._names[name] = file
        return self._files[path]

    def named(self, name: str) -> SourceFile | None:
        """The file of that name."""
        return self._names.get(name)

    def place_of(self, file: SourceFile) -> tuple[str, str] | None:
        """The package and the path below its share folder at which a file is installed."""
        if file.package is None:
            return None
        path = os.fspath(file.path)
        for shared in file.package.shared:
            if path == shared.source:
                return file.package.name, shared.target
            if path.startswith(f"{shared.source}/"):
                rest = path[len(shared.source) + 1 :]
                return file.package.name, f"{shared.target}/{rest}" if shared.target else rest
        return file.package.name, os.path.relpath(path, file.package.path)

    def _inside(self, path: str, package: Package | None) -> bool:
        real = f"{disk.real_path(path)}/"
        if real.startswith(f"{self._real_root.rstrip('/')}/"):
            return True
        return package is not None and real.startswith(f"{disk.real_path(package.path)}/")

    def _owner(self, path: str) -> Package | None:
        around = [
            package
            for several in self._packages.values()
            for package in several
            if path.startswith(f"{os.fspath(package.path)}/")
        ]
        return max(around, key=lambda package: len(os.fspath(package.path)), default=None)

    def _same_names(self, package: Package) -> dict[str, list[str]]:
        if package not in self._by_name:
            found = self._by_name[package] = {}
            for path in _walk(os.fspath(package.path)):
                found.setdefault(path.rpartition(os.sep)[2], []).append(path)
        return self._by_name[package]


def _rest(target: str, relative: str) -> str | None:
    """What stands in `relative` behind `target`; None where it is not at or below it."""
    if not target or target == relative:
        return "" if target else relative
    return relative[len(target) + 1 :] if relative.startswith(f"{target}/") else None


def _installed(package: Package, relative: str) -> Iterator[str]:
    """The paths of what the build puts at `relative`, if these are there."""
    for shared in package.shared:
        rest = _rest(shared.target, relative)
        if rest is not None:
            yield f"{shared.source}/{rest}" if rest else shared.source


def _names_in(folder: str) -> list[str] | None:
    try:
        return [entry.name for entry in disk.listing(folder)]
    except OSError:
        return None


def _walk(top: str) -> Iterator[str]:
    """The files of a package, without those of packages within, and of hidden folders."""
    looked_at = 0
    for folder, inner, names in disk.walk(top):
        looked_at += len(inner) + len(names)
        if looked_at > _LIMIT:
            return
        if folder != top and "package.xml" in names:
            inner.clear()
            continue
        inner[:] = sorted(name for name in inner if not name.startswith("."))
        yield from (f"{folder}{os.sep}{name}" for name in sorted(names))


@final
class _Prefix:
    """An install prefix, merged (`prefix/share/PACKAGE`) or isolated (`prefix/PACKAGE/share/PACKAGE`)."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._folders: dict[str, Path | None] = {}

    def has(self, package: str) -> bool:
        """Whether the package is there."""
        return self._folder(package) is not None

    def share(self, package: str, relative: str) -> SourceFile | None:
        """The file at `relative` below the package's share folder."""
        folder = self._folder(package)
        path = "" if folder is None else f"{folder}/{relative}"
        if not disk.is_file(path):
            return None
        return SourceFile(Path(path), "/" + place_name(path, "/"))

    def is_folder(self, package: str, relative: str) -> bool:
        """Whether there is a folder at `relative`."""
        folder = self._folder(package)
        return folder is not None and disk.is_folder(f"{folder}/{relative}")

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """The names in that folder, sorted."""
        folder = self._folder(package)
        names = None if folder is None else _names_in(f"{folder}/{relative}")
        return None if names is None or len(names) > _LIMIT else tuple(sorted(names))

    def _folder(self, package: str) -> Path | None:
        if package not in self._folders:
            candidates = (self._path / "share" / package, self._path / package / "share" / package)
            self._folders[package] = next((path for path in candidates if disk.is_folder(path)), None)
        return self._folders[package]
