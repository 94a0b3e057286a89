# SPDX-License-Identifier: Apache-2.0
"""Which file does an import mean?

    from demo.nodes import helper   in /ws/src/other/other/main.py  ->  demo.nodes: /ws/src/demo/demo/nodes/__init__.py
    from . import helper            in /ws/src/demo/demo/talker.py  ->  demo: /ws/src/demo/demo/__init__.py
    import rclpy                                                    ->  None, it is not among the sources

The rules are those of the run: a script's own folder and what is installed beside it, the folders from which its
package is imported, then the other packages, the nearest first where two copies have one name. What only a change of
`sys.path` can explain is found by its file name, if that leaves one possibility, and marked as a guess.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from rosward.records import NamedTuple
from rosward.source.generated import GeneratedModules
from rosward.source.layout import Layout
from rosward.source.standard_library import BUILT_IN, STANDARD_LIBRARY
from rosward.source.text import place_name
from rosward.source.workspace import ExecutableKind, Package, SourceFile

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rosward.source.workspace import Workspace

_NEVER_GUESSED: Final = STANDARD_LIBRARY | {
    "action_msgs", "ament_index_python", "builtin_interfaces", "cv2", "cv_bridge", "geometry_msgs", "launch",
    "launch_ros", "matplotlib", "message_filters", "nav_msgs", "numpy", "pandas", "pytest", "rcl_interfaces", "rclpy",
    "requests", "rospy", "scipy", "sensor_msgs", "serial", "setuptools", "std_msgs", "std_srvs", "tf2_ros",
    "tf_transformations", "torch", "yaml",
}  # fmt: skip


class ImportTarget(NamedTuple):
    """What a module name means: its whole dotted `name`, its `file` (of a package, its `__init__.py`), its `folder`.

    A namespace package has a folder and no file, a plain module a file and no folder. A `guess` holds only if the
    program changes `sys.path`, or is started in another way than installed.
    """

    name: str
    file: SourceFile | None
    folder: str | None
    guess: bool = False

    @property
    def is_package(self) -> bool:
        """Whether it can have submodules."""
        return self.folder is not None


@final
class ImportResolver:
    """Maps names to files for one workspace; files outside of it are found too where an import leads there."""

    def __init__(self, workspace: Workspace, layout: Layout | None = None) -> None:
        self._root = workspace.root
        self._layout = layout or Layout(workspace.excluded, workspace.boundary)
        self._excluded = workspace.excluded
        self._boundary = workspace.boundary
        self._files = {os.fspath(file.path): file for file in workspace.files}
        self._packages = workspace.packages
        self._scripts = _installed_scripts(workspace)
        self._roots: dict[Package | None, dict[str, None]] = {}
        """The folders from which the modules of a package are imported, once it is installed."""
        self._odd_roots: dict[Package | None, dict[str, None]] = {}
        """Other folders of a package that hold modules: scripts, and what only a change of `sys.path` reaches."""
        self._tops: dict[str, dict[str, None]] = {}
        self._by_stem: dict[str, list[SourceFile]] = {}
        self._generated = GeneratedModules(workspace)
        self._cache: dict[tuple[str, str], ImportTarget | None] = {}
        self._index(workspace)

    def resolve(self, module: str, level: int, importer: SourceFile) -> ImportTarget | None:
        """What `import module`, or with `level` dots `from ..module import x`, means; `None` if it leads outside."""
        name = "." * level + module
        key = (name, os.fspath(importer.path))
        if key not in self._cache:
            self._cache[key] = self._relative(module, level, importer) if level else self._absolute(module, importer)
        return self._cache[key]

    def submodule(self, parent: ImportTarget, name: str) -> ImportTarget | None:
        """The module `name` in the package `parent`."""
        if parent.folder is None:
            return None
        found = self._descend(parent.folder, [name], parent.file.package if parent.file else None, within=True)
        return found and found._replace(name=f"{parent.name}.{name}", guess=parent.guess)

    def entry_module(self, name: str, package: Package) -> ImportTarget | None:
        """What the entry point module `name` of an installed `package` means."""
        parts = name.split(".")
        for roots in (self._roots[package], self._other_roots(parts[0], package.path)):
            found = self._first(roots, parts, package=package)
            if found is not None and found.file is not None:
                return found
        return self._guess(parts, package, package.path)

    def in_folder(self, folder: str, name: str) -> ImportTarget | None:
        """What `import name` means, where a folder below that of all sources is the first in `sys.path`."""
        path = self._inside(folder)
        found = None if path is None else self._descend(path, name.split("."), None)
        return found if found is not None and found.file is not None else None

    def named(self, name: str) -> list[tuple[str, ImportTarget]]:
        """All files of the sources that the absolute `name` may mean, each with the folder that `sys.path` would hold."""
        if name.partition(".")[0] in _NEVER_GUESSED:
            return []
        parts = name.split(".")
        up = len(parts)
        return [
            (
                place_name(os.fspath(file.path.parents[up if file.is_package else up - 1]), self._root),
                ImportTarget(name, file, os.fspath(file.path.parent) if file.is_package else None, guess=True),
            )
            for file in self._that_end_with(parts)
        ]

    def _inside(self, folder: str) -> str | None:
        """The path of a folder below that of all sources; None where a link leads out."""
        path = os.path.normpath(os.path.join(self._root, folder))  # noqa: PTH118
        return None if self.is_left_out(path) else path

    def is_script(self, file: SourceFile) -> bool:
        """Whether a file is installed to be run by its path."""
        return os.fspath(file.path) in self._scripts

    def is_left_out(self, path: str) -> bool:
        """Whether the file is not to be read: the user excludes it, or a link leads out of the sources."""
        return self._excluded.of(path) is not None or self._boundary.leads_out(path)

    def file_at(self, path: str, package: Package | None) -> SourceFile:
        """The record of a file, made where an import is the first to need it."""
        found = self._files.get(path)
        if found is None:
            owner = (
                package
                if package is not None and path.startswith(f"{package.path}{os.sep}")
                else self._package_of(path)
            )
            name = self._layout.module_name(path, owner)
            found = self._files[path] = SourceFile(Path(path), place_name(path, self._root), owner, name)
        return found

    def _index(self, workspace: Workspace) -> None:
        for package in workspace.packages:
            path = os.fspath(package.path)
            self._roots[package] = dict.fromkeys([path, *map(os.fspath, package.python_roots), f"{path}{os.sep}src"])
            for top in self._generated.add(package, self._roots[package]):
                self._tops.setdefault(top, {}).update(self._roots[package])
        self._roots[None] = {os.fspath(workspace.root): None}
        for file in workspace.files:
            if file.module is None:
                continue
            path = os.fspath(file.path)
            self._by_stem.setdefault(_stem(path), []).append(file)
            depth = file.module.count(".") + (1 if file.is_package and file.module != "__init__" else 0)
            root = path.rsplit(os.sep, depth + 1)[0]
            if depth and (file.package is None or root in self._roots[file.package]):
                self._tops.setdefault(file.module.partition(".")[0], {})[root] = None
            else:
                self._odd_roots.setdefault(file.package, {})[root] = None

    def _other_roots(self, top: str, near: Path) -> list[str]:
        """The folders from which `top` can be imported, those that share more of their path with `near` first."""
        roots = list(self._tops.get(top, ()))
        if len(roots) > 1:
            roots.sort(key=lambda root: (-_common(Path(root).parts, near.parts), root))
        return roots

    def _absolute(self, name: str, importer: SourceFile) -> ImportTarget | None:
        parts = name.split(".")
        top = parts[0]
        if top in BUILT_IN or not all(parts):
            return None
        folder = os.fspath(importer.path.parent)
        own = self._layout.python_root(folder, importer.package)
        inside = own != folder  # a module of a Python package
        script = os.fspath(importer.path) in self._scripts or not inside
        nearest: ImportTarget | None = None
        if script:
            nearest = self._first([folder], parts, package=importer.package)
            if nearest is None or nearest.file is None:
                nearest = self._beside(parts, importer) or nearest
            if nearest is not None and nearest.file is not None:
                return nearest
        itself = [own] if inside and folder[len(own) + 1 :].partition(os.sep)[0] == top else []  # its own package
        roots = [*self._roots[importer.package], *itself, *self._other_roots(top, importer.path)]
        if importer.package is None:  # a single file, say: what lies around it
            roots = [self._layout.python_root(folder, None), *roots]
        found = self._first(dict.fromkeys(roots), parts, package=importer.package)
        if found is None or found.file is None:
            found = nearest or found
        if found is not None:
            return found
        if top in _NEVER_GUESSED:
            return None
        odd = [*([] if script else [folder]), *self._odd_roots.get(importer.package, ())]
        found = self._first(odd, parts, package=importer.package, guess=True)
        if found is not None and found.file is importer:
            return None
        return found or self._guess(parts, importer.package, importer.path)

    def _relative(self, module: str, level: int, importer: SourceFile) -> ImportTarget | None:
        folder = os.fspath(importer.path.parent)
        root = self._layout.python_root(folder, importer.package)
        for _ in range(level - 1):
            if folder == os.path.dirname(folder):  # noqa: PTH120
                return None
            folder = os.path.dirname(folder)  # noqa: PTH120
        beyond = len(folder) <= len(root)  # Python refuses: no package is left to import from
        base = Path(folder[len(root) :].lstrip(os.sep)).parts
        found = self._descend(folder, module.split(".") if module else [], importer.package, within=True)
        if found is None:
            return None
        name = ".".join([*base, found.name]).rstrip(".")
        if found.file is not None and found.file.module:
            name = found.file.module
        return found._replace(name=name, guess=beyond)

    def _first(
        self, roots: Iterable[str], parts: list[str], *, package: Package | None = None, guess: bool = False
    ) -> ImportTarget | None:
        """The first root that has the whole name; a namespace package counts only if no root has a file."""
        namespace: ImportTarget | None = None
        for root in roots:
            found = self._descend(root, parts, package)
            if found is None:
                continue
            if found.file is not None:
                return found._replace(guess=guess)
            namespace = namespace or found._replace(guess=guess)
        return namespace

    def _descend(
        self, folder: str, parts: list[str], package: Package | None, *, within: bool = False
    ) -> ImportTarget | None:
        """The module that `parts` name below `folder`; as at run time a package goes before a module of its name.

        `within`: the folder is one of a package.
        """
        layout = self._layout
        for index, part in enumerate(parts):
            listing = layout.listing(folder)
            inner = f"{folder}{os.sep}{part}"
            if part in listing.folders and (part not in listing.modules or layout.listing(inner).is_package):
                folder = inner
            elif part in listing.modules and index == len(parts) - 1:
                return ImportTarget(".".join(parts), self.file_at(f"{inner}.py", package), None)
            elif index >= len(parts) - 2 and (made := self._generated.at(inner, parts[index + 1 :])) is not None:
                return ImportTarget(".".join(parts), made.file, made.folder)
            else:
                return None
        if layout.listing(folder).is_package:
            return ImportTarget(".".join(parts), self.file_at(f"{folder}{os.sep}__init__.py", package), folder)
        held = layout.holds_python(folder, inner=within or len(parts) > 1) or self._generated.at(folder, []) is not None
        return ImportTarget(".".join(parts), None, folder) if held else None

    def _beside(self, parts: list[str], importer: SourceFile) -> ImportTarget | None:
        """A script that is installed into the same folder, whatever folder it comes from."""
        if importer.package is None or len(parts) > 1 or os.fspath(importer.path) not in self._scripts:
            return None
        for file, name in self._scripts.values():
            if file.package is importer.package and name == f"{parts[0]}.py":
                return ImportTarget(parts[0], file, None)
        return None

    def _guess(self, parts: list[str], package: Package | None, near: Path) -> ImportTarget | None:
        """The one file that could be meant if `sys.path` held its folder."""
        if parts[0] in _NEVER_GUESSED:
            return None
        found = [file for file in self._that_end_with(parts) if file.path != near]
        own = [file for file in found if package is not None and file.package is package]
        for candidates in (own, found):
            if len(candidates) == 1:
                file = candidates[0]
                return ImportTarget(
                    ".".join(parts), file, os.fspath(file.path.parent) if file.is_package else None, guess=True
                )
        return None

    def _that_end_with(self, parts: list[str]) -> list[SourceFile]:
        """The files whose paths end as an import of these parts spells them."""
        wanted = "".join(f"{os.sep}{part}" for part in parts)
        files = self._by_stem.get(parts[-1], ())
        return [file for file in files if _without_suffix(os.fspath(file.path)).endswith(wanted)]

    def _package_of(self, path: str) -> Package | None:
        owners = [package for package in self._packages if path.startswith(f"{package.path}{os.sep}")]
        return max(owners, key=lambda package: len(os.fspath(package.path)), default=None)


def _installed_scripts(workspace: Workspace) -> dict[str, tuple[SourceFile, str]]:
    """The files that are installed as scripts, with the name that each gets, by path."""
    return {
        os.fspath(executable.file.path): (executable.file, executable.name)
        for executable in workspace.executables
        if executable.kind is ExecutableKind.SCRIPT and executable.file is not None
    }


def _common(one: tuple[str, ...], other: tuple[str, ...]) -> int:
    count = 0
    for a, b in zip(one, other, strict=False):
        if a != b:
            break
        count += 1
    return count


def _without_suffix(path: str) -> str:
    """The path as an import spells it: without `.py`, and without `/__init__.py`."""
    return path[:-3].removesuffix(f"{os.sep}__init__")


def _stem(path: str) -> str:
    return _without_suffix(path).rpartition(os.sep)[2]
