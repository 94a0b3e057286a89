# SPDX-License-Identifier: Apache-2.0
"""What is there to read under the paths that a user names?

    discover([Path("my_ws")])  ->  Workspace with files, launch files, packages, executables, by name

A file that is named is taken whatever it is called; a folder is walked by the rules of `source/walk.py`. A test file
that an entry point names is no test. The package around a path is looked for above it, so that a file alone knows its
package and its executables.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.guard import guarded
from rosward.location import Place
from rosward.source import disk, limits
from rosward.source.boundary import Boundary
from rosward.source.build_script import is_build_script
from rosward.source.exclude import Exclusion, Exclusions
from rosward.source.executables import executables
from rosward.source.imports import ImportResolver
from rosward.source.launch_function import makes_launch
from rosward.source.layout import Layout
from rosward.source.left_out import left_out, named_few
from rosward.source.ros_1 import of_ros_1
from rosward.source.surroundings import ROS_2
from rosward.source.text import place_name, read_bytes
from rosward.source.walk import CPP_SOURCES, DESCRIPTIONS, Tree, walk
from rosward.source.workspace import Executable, Package, Skipped, SkipReason, SourceFile, Target, Workspace

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from rosward.source.packages import DescribedPackage

_LEVELS_ABOVE: Final = 12
_OTHERS_TOO: Final = ("_launch.yaml", "_launch.yml")
_LAUNCH_KEY: Final = re.compile(rb"^(?:\xef\xbb\xbf)?(?:---|!!map)?[\s{?]*[\"']?launch[\"']?\s*:", re.MULTILINE)


def discover(
    paths: Sequence[Path],
    *,
    launch_files: Sequence[Path] = (),
    include_tests: bool = False,
    exclude: Iterable[Exclusion] = (),
    follow_links: bool = False,
    environment: Mapping[str, str] = ROS_2,
    net: bool = True,
) -> Workspace:
    """What the files and folders `paths` hold, and `launch_files`, less what `exclude` means.

    Links that lead out of all of these are entered only with `follow_links`.
    `environment` is what build descriptions see of it; `net`: see `guard.py`.
    """
    starts = list(dict.fromkeys(os.path.abspath(path) for path in paths)) or [os.path.abspath(".")]  # noqa: PTH100
    named = {os.path.abspath(path) for path in launch_files}  # noqa: PTH100
    root = _common_folder([*starts, *sorted(named)])
    excluded = Exclusions(exclude, [*starts, *sorted(named)])
    around = {start: _package_above(start) for start in starts}
    inside = [*starts, *sorted(named), *(above[0] for above in around.values() if above is not None)]
    boundary = Boundary(inside, follow=follow_links)
    tree = Tree(excluded, boundary)
    findings: list[Finding] = []
    chosen = _look(starts, tree, root, findings, include_tests=include_tests)
    files = sorted({*tree.python.values()} - named)
    launch = {path for path in files if _is_launch(path)} | {path for path in tree.launch if _has_key(path)} | named
    both = {path for path in files if path not in launch and _may_be_launch(path)}
    named_setup = [path for path in files if path.endswith(f"{os.sep}setup.py") and path not in chosen]
    scripts = {path for path in named_setup if is_build_script(path)}
    tree.skipped += [(path, SkipReason.BUILD_SCRIPT) for path in sorted(scripts)]

    beside = [above for above in around.values() if above is not None]
    described, failed = _describe_all(tree, beside, root, environment, net=net)
    owners = _Owners(package for package, _ in described)
    layout = Layout(excluded, boundary)

    def record(path: str, *, module: bool) -> SourceFile:
        package = owners.of(path)
        return SourceFile(
            Path(path), place_name(path, root), package, layout.module_name(path, package) if module else None
        )

    sources = [record(path, module=True) for path in files if path not in launch and path not in scripts]
    packages = tuple(sorted((package for package, _ in described), key=lambda p: (p.relative, p.name)))
    before = Workspace(root, tuple(sources), packages=packages, excluded=excluded, boundary=boundary)
    started, doubts = _executables(described, ImportResolver(before, layout), set(files) if chosen else None, starts)
    known = {os.fspath(file.path) for file in sources}
    for executable in started:
        if executable.file is not None and os.fspath(executable.file.path) not in known:
            known.add(os.fspath(executable.file.path))
            sources.append(executable.file)
    return Workspace(
        root=root,
        files=tuple(sorted(sources, key=_by_name)),
        launch_files=tuple(sorted((record(path, module=False) for path in launch | both), key=_by_name)),
        packages=packages,
        executables=tuple(started),
        interface_files=tuple(sorted((record(path, module=False) for path in set(tree.interfaces)), key=_by_name)),
        cpp_sources=tuple(sorted((record(path, module=False) for path in set(tree.cpp)), key=_by_name)),
        skipped=tuple(
            Skipped(place_name(path, root), reason)
            for path, reason in sorted(set(tree.skipped), key=lambda s: s[0])
            if path not in known
        ),
        findings=tuple(
            sorted(
                dict.fromkeys(
                    [*findings, *failed, *doubts, *left_out(tree, root, named), *_twins(packages), *of_ros_1(packages)]
                ),
                key=lambda f: (f.place, f.code, f.message),
            )
        ),
        targets=_targets(described),
        excluded=excluded,
        boundary=boundary,
        environment=environment,
    )


def _twins(packages: Iterable[Package]) -> list[Finding]:
    """RW014 for each name that several packages have."""
    by_name: dict[str, list[Package]] = {}
    for package in packages:
        by_name.setdefault(package.name, []).append(package)
    return [
        Finding(
            "RW014",
            f"{len(several)} packages are named {name}: {named_few([each.relative or '.' for each in several])}.",
            Place(_description(several[0])),
        )
        for name, several in sorted(by_name.items())
        if len(several) > 1
    ]


def _description(package: Package) -> str:
    """The file that gives a package its name."""
    name = "setup.py" if package.build_type == "python" else "package.xml"
    return f"{package.relative}/{name}" if package.relative not in ("", ".") else name


def _targets(described: list[tuple[Package, DescribedPackage]]) -> tuple[Target, ...]:
    """The programs and components that CMake builds."""
    found = [
        Target(package, target.name, target.kind, target.place, target.plugin)
        for package, description in described
        for target in description.cmake.targets
    ]
    return tuple(sorted(found, key=lambda t: (t.package.relative, t.name, t.kind.value, t.plugin, t.place)))


def _common_folder(starts: list[str]) -> Path:
    """The folder that all paths have in common."""
    folders = [path if disk.is_folder(path) else os.path.dirname(path) for path in starts]  # noqa: PTH120
    try:
        return Path(os.path.commonpath(folders))
    except ValueError:  # on several drives
        return Path(folders[0])


def _look(starts: list[str], tree: Tree, root: Path, findings: list[Finding], *, include_tests: bool) -> set[str]:
    """Fill `tree` from the paths; the files that were named themselves."""
    chosen: set[str] = set()
    seen: set[str] = set()
    for path in starts:
        if disk.is_folder(path):
            walk(path, tree, seen, include_tests=include_tests)
        elif disk.is_file(path):
            chosen.add(path)
            if path.endswith(CPP_SOURCES):
                tree.cpp.append(path)
            else:
                tree.python[disk.real_path(path)] = path
        else:
            there = disk.is_there(path)
            what = (
                "This is not a regular file or folder, or it cannot be accessed."
                if there
                else "The file does not exist."
            )
            findings.append(Finding("RW002", what, Place(place_name(path, root))))
    for path in sorted(tree.linked):
        tree.python.setdefault(disk.real_path(path), path)
    for path, what in tree.not_files:
        findings.append(Finding("RW002", f"This file cannot be read: {what}.", Place(place_name(path, root))))
    return chosen


def _is_launch(path: str) -> bool:
    """Whether a Python file describes a launch and is no program: by its name, or in a launch folder by the function that makes it."""
    folder, _, name = path.rpartition(os.sep)
    if name.endswith(".launch.py"):
        return True
    if not name.endswith("launch.py") and "launch" not in Path(folder).parts[-3:]:
        return False
    return _makes_launch(path)


def _may_be_launch(path: str) -> bool:
    """Whether a Python file describes a launch by the function that makes it, and its name speaks of launch: it may be a program, too."""
    return "launch" in path.rpartition(os.sep)[2] and _makes_launch(path)


def _makes_launch(path: str) -> bool:
    data = read_bytes(path, path, limits.PYTHON_FILE)
    return isinstance(data, bytes) and makes_launch(data)


def _has_key(path: str) -> bool:
    """Whether a YAML file that is named `…_launch.yaml` is one: launch reads none without the key `launch`, and other tools have such names, too."""
    if not path.endswith(_OTHERS_TOO):
        return True
    data = read_bytes(path, path, limits.LAUNCH_YAML_TEXT)
    return not isinstance(data, bytes) or _LAUNCH_KEY.search(data) is not None


def _describe_all(
    tree: Tree, around: list[tuple[str, set[str]]], root: Path, environment: Mapping[str, str], *, net: bool
) -> tuple[list[tuple[Package, DescribedPackage]], list[Finding]]:
    """The packages below the paths and those `around` them."""
    folders = dict(tree.descriptions)
    for above in around:
        folders.setdefault(*above)
    if not folders:
        return [], []
    from rosward.source.packages import describe

    found: list[tuple[Package, DescribedPackage]] = []
    failed: list[Finding] = []
    for folder, names in sorted(folders.items()):
        place = Place(place_name(os.path.join(folder, min(names, default="")), root))  # noqa: PTH118
        missing = "the package was not read"
        each = guarded(partial(describe, folder, names, root, environment, tree.boundary), place, missing, net=net)
        if isinstance(each, Finding):
            failed.append(each)
        elif each is not None:
            found.append((each.package, each))
    return found, failed


def _package_above(start: str) -> tuple[str, set[str]] | None:
    """The nearest folder around `start` with a package.xml, and the descriptions in it; not beyond a repository."""
    folder = start if disk.is_folder(start) else os.path.dirname(start)  # noqa: PTH120
    for _ in range(_LEVELS_ABOVE):
        names = {n for n in DESCRIPTIONS if _is_file(folder, n)}
        if "package.xml" in names:
            return folder, names
        above = os.path.dirname(folder)  # noqa: PTH120
        if above == folder or disk.is_there(f"{folder}{os.sep}.git"):
            return None
        folder = above
    return None


def _is_file(folder: str, name: str) -> bool:
    return disk.is_file(f"{folder}{os.sep}{name}")


def _executables(
    described: list[tuple[Package, DescribedPackage]],
    resolver: ImportResolver,
    taken: set[str] | None,
    starts: list[str],
) -> tuple[list[Executable], list[Finding]]:
    """The executables in the order of packages and names.

    Of a package that is not itself below a path that was named, only those count whose file is among the `taken` ones.
    """
    started: list[Executable] = []
    doubts: list[Finding] = []
    for package, description in described:
        found, findings = executables(description, resolver)
        path = os.fspath(package.path)
        if any(path == start or path.startswith(start + os.sep) for start in starts):
            started += found
            doubts += [*description.findings, *findings]
        else:
            started += [e for e in found if e.file is not None and _is_taken(os.fspath(e.file.path), taken, starts)]
    return sorted(started, key=lambda e: (e.package.relative, e.name, e.place)), doubts


def _is_taken(path: str, taken: set[str] | None, starts: list[str]) -> bool:
    return path in (taken or ()) or any(path.startswith(start + os.sep) for start in starts)


def _by_name(file: SourceFile) -> str:
    return file.relative


class _Owners:
    """The package that a path belongs to: the innermost around it."""

    def __init__(self, packages: Iterable[Package]) -> None:
        self._packages = {os.fspath(package.path): package for package in packages}
        self._known: dict[str, Package | None] = {}

    def of(self, path: str) -> Package | None:
        folder = path.rpartition(os.sep)[0]
        if folder not in self._known:
            here, owner = folder, None
            while here:
                owner = self._packages.get(here)
                if owner is not None:
                    break
                here = here.rpartition(os.sep)[0]
            self._known[folder] = owner
        return self._known[folder]
