# SPDX-License-Identifier: Apache-2.0
"""Which package does a folder with a build description hold, and what does that declare?

    /ws/src/demo with package.xml, setup.py, setup.cfg  ->  Package("demo", …), entry points, scripts

All that is said about one package in its several files comes together here; `source/executables.py` finds the sources
for it.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.build_script import is_build_script
from rosward.source.cmake.install import below_share
from rosward.source.cmake.installed import CMakeProject, read_cmake
from rosward.source.entry_points import PythonSide, read_pyproject, read_setup_cfg
from rosward.source.generated import there
from rosward.source.manifest import Manifest, read_manifest
from rosward.source.setup_py import read_setup_py
from rosward.source.text import place_name
from rosward.source.workspace import GeneratedModule, Package, Shared

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping

    from rosward.findings import Finding


class DescribedPackage(NamedTuple):
    """A package with what its build descriptions declare."""

    package: Package
    declared: PythonSide
    cmake: CMakeProject
    findings: tuple[Finding, ...]


def describe(
    folder: str, names: Collection[str], root: Path, environment: Mapping[str, str], boundary: Boundary = EVERYWHERE
) -> DescribedPackage | None:
    """The package in `folder`, where the files `names` stand; `None` if they do not make one."""

    def file(name: str) -> tuple[str, str]:
        path = os.path.join(folder, name)  # noqa: PTH118
        return path, place_name(path, root)

    findings: list[Finding] = []
    manifest: Manifest | None = None
    if "package.xml" in names:
        manifest, problem = read_manifest(*file("package.xml"), os.path.basename(folder), environment)  # noqa: PTH119
        findings += [problem] if problem is not None else []
    elif "setup.py" not in names or not is_build_script(file("setup.py")[0]):
        return None
    declared = PythonSide()
    if "setup.py" in names:
        declared |= read_setup_py(*file("setup.py"), environment)
    if "setup.cfg" in names:
        declared |= read_setup_cfg(*file("setup.cfg"))
    if "pyproject.toml" in names:
        declared |= read_pyproject(*file("pyproject.toml"))
    if manifest is None:
        manifest = Manifest(declared.name or os.path.basename(folder), "python")  # noqa: PTH119
    builds_python = manifest.build_type in {"ament_python", "python"}
    cmake = CMakeProject()
    if "CMakeLists.txt" in names and not builds_python:
        cmake = read_cmake(folder, manifest.name, root, boundary)
        declared |= PythonSide(entry_points=cmake.entry_points)
    roots = [_root(folder, package, where) for package, where in declared.package_dir]
    roots += cmake.python_roots
    relative = place_name(folder, root)
    inside = tuple(Path(r) for r in dict.fromkeys(roots) if r == folder or r.startswith(folder + os.sep))
    shared, whole = (
        (_data(folder, manifest.name, declared), declared.all_data)
        if builds_python
        else (cmake.shared, cmake.all_shared)
    )
    if "package.xml" in names:
        shared += (Shared("package.xml", file("package.xml")[0], Place(file("package.xml")[1])),)
    made = [
        GeneratedModule(manifest.name, name, os.path.normpath(os.path.join(folder, source)), validation, place)  # noqa: PTH118
        for name, source, validation, place in declared.generated
    ]
    generated, missing = there([*made, *cmake.generated], boundary)
    findings += missing
    package = Package(
        manifest.name, Path(folder), relative, manifest.build_type, manifest.depends, inside, shared, whole, generated
    )
    return DescribedPackage(package, declared, cmake, (*findings, *declared.findings, *cmake.findings))


def _data(folder: str, package: str, declared: PythonSide) -> tuple[Shared, ...]:
    """The `data_files` that go to the share folder of the package."""
    found: list[Shared] = []
    for destination, source, place in declared.data_files:
        target = below_share(destination, package)
        path = os.path.normpath(os.path.join(folder, source))  # noqa: PTH118
        if target is not None and path.startswith(folder + os.sep):
            found.append(Shared(target, path, place))
    return tuple(dict.fromkeys(found))


def _root(folder: str, package: str, where: str) -> str:
    """The folder from which modules are imported, by an entry of `package_dir`, as `"": "src"` or `"a": "src/a"`."""
    path = os.path.normpath(os.path.join(folder, where))  # noqa: PTH118
    if package and os.path.basename(path) == package.rpartition(".")[2]:  # noqa: PTH119
        return os.path.dirname(path)  # noqa: PTH120
    return path
