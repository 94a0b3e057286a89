# SPDX-License-Identifier: Apache-2.0
"""Makes folders of files for the tests: one dictionary from names to contents."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosward.source.discover import discover
from rosward.source.workspace import SourceFile, Workspace


def write(root: Path, files: Mapping[str, str | bytes]) -> Path:
    """Write `files` below `root`; a name that ends with `/` makes an empty folder."""
    for name, content in files.items():
        path = root / name
        if name.endswith("/"):
            path.mkdir(parents=True, exist_ok=True)
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    return root


def manifest(name: str, build_type: str = "ament_python", extra: str = "") -> str:
    """A package.xml that the ROS tools accept."""
    return (
        f'<?xml version="1.0"?>\n<package format="3">\n<name>{name}</name><version>0.1.0</version>\n'
        "<description>x</description>\n"
        '<maintainer email="a@b.org">a</maintainer><license>Apache-2.0</license>\n'
        f"{extra}<export><build_type>{build_type}</build_type></export>\n</package>\n"
    )


def setup(name: str, *commands: str, more: str = "") -> str:
    """A setup.py with console scripts."""
    return (
        f"from setuptools import setup\npackage_name = {name!r}\n"
        f"setup(name=package_name, packages=[package_name], {more}\n"
        f"    entry_points={{'console_scripts': {list(commands)!r}}})\n"
    )


def python_package(name: str, *modules: str, commands: tuple[str, ...] = ()) -> dict[str, str]:
    """The files of an ament_python package, below a folder of its name."""
    files = {
        f"{name}/package.xml": manifest(name),
        f"{name}/setup.py": setup(name, *commands),
        f"{name}/{name}/__init__.py": "",
    }
    return files | {f"{name}/{name}/{module}.py": "" for module in modules}


def read(root: Path, files: Mapping[str, str | bytes], *, include_tests: bool = False) -> Workspace:
    """Write the files and discover what they are."""
    return discover([write(root, files)], include_tests=include_tests)


def names(workspace: Workspace) -> list[str]:
    """The relative names of the files."""
    return [file.relative for file in workspace.files]


def file(workspace: Workspace, name: str) -> SourceFile:
    """The file of that relative name."""
    return next(file for file in workspace.files if file.relative == name)


def codes(workspace: Workspace) -> list[tuple[str, str]]:
    """Code and place of each finding."""
    return [(finding.code, str(finding.place)) for finding in workspace.findings]
