# SPDX-License-Identifier: Apache-2.0
"""Which files under a folder are source, and which are made by a build, installed, hidden or tests?

    ws/build/…, ws/install/…, ws/log/…     beside ws/src, or with the marks that colcon leaves: output
    ws/src/demo/demo/build/planner.py      an ordinary folder of that name within a package: source

A folder named `build`, `install` or `log` is taken as output if it holds what colcon, CMake or setuptools write
there, if it stands beside a `src` folder, or at the top of what was named, and neither it nor the folder it stands in
is a package. Names are only looked at; only a file that is named like a test is opened: many a node is called `test_motor.py`.
"""

from __future__ import annotations

import os
import re
from typing import Final, final

from rosward.records import NamedTuple
from rosward.source import disk
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.exclude import Exclusions
from rosward.source.workspace import SkipReason

MARKERS: Final = frozenset({"COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"})
_OUTPUT_NAMES: Final = frozenset({"build", "install", "log", "devel", "logs"})
_OUTPUT_MARKS: Final = frozenset(
    {
        ".built_by", ".catkin", ".colcon_install_layout", "CMakeCache.txt", "_local_setup_util_sh.py", "_setup_util.py",
        "latest_build", "latest_list", "local_setup.bash", "setup.bash",
    }
)  # fmt: skip
_PYTHON_BUILD: Final = re.compile(r"lib|lib\.\w+.*|bdist\..+|temp\..+")
_INSTALLED: Final = frozenset({"site-packages", "dist-packages", "node_modules", "__pypackages__"})
_TEST_FOLDERS: Final = frozenset({"test", "tests"})
_TEST_FILE: Final = re.compile(r"test_.*\.py|.*_test\.py|conftest\.py")
_PROGRAM: Final = re.compile(rb"^[ \t]*(?:from|import)[ \t]+rclpy\b", re.MULTILINE)
_TESTING: Final = re.compile(
    rb"^[ \t]*(?:(?:from|import)[ \t]+(?:pytest|unittest|launch_testing\w*|launch_pytest|ament_\w+\.main)\b|(?:async[ \t]+)?def[ \t]+test_)",
    re.MULTILINE,
)
_TESTED_BYTES: Final = 1_000_000
CPP_SOURCES: Final = (".cpp", ".cc", ".cxx", ".c++", ".C", ".cp")
"""The suffixes of files that are compiled as C++."""

DESCRIPTIONS: Final = frozenset({"package.xml", "setup.py", "setup.cfg", "pyproject.toml", "CMakeLists.txt"})
_INTERFACE: Final = re.compile(r"[A-Za-z]\w*\.(?:msg|srv|action|idl)")
_LAUNCH: Final = re.compile(r".*[._]launch\.(?:xml|yaml|yml)|.*\.launch")
_FOLDER_LIMIT: Final = 200_000


@final
class Tree:
    """What a walk found: absolute paths; `python` by their real path, so that each file is there once."""

    __slots__ = (
        "boundary", "cpp", "descriptions", "excluded", "interfaces", "launch", "linked", "not_files", "outside", "python", "skipped",
    )  # fmt: skip

    def __init__(self, excluded: Exclusions | None = None, boundary: Boundary = EVERYWHERE) -> None:
        self.excluded = excluded or Exclusions()
        self.boundary = boundary
        self.python: dict[str, str] = {}
        self.linked: list[str] = []
        """Python files that are symbolic links; they count where nothing else leads to the file."""
        self.cpp: list[str] = []
        """Sources in C++."""
        self.launch: list[str] = []
        self.interfaces: list[str] = []
        self.descriptions: dict[str, set[str]] = {}
        """The build descriptions that stand in a folder, by folder."""
        self.not_files: list[tuple[str, str]] = []
        """What is named like a Python file and is something else, and what."""
        self.skipped: list[tuple[str, SkipReason]] = []
        self.outside: list[str] = []
        """Links that lead out of the boundary: what is behind them is not read."""


class _Folder(NamedTuple):
    """`top`: at the level of a workspace, where `build` is output; `chosen`: named by the user, so read in any case."""

    path: str
    real: str
    top: bool
    chosen: bool


def is_test_file(path: str) -> bool:
    """Whether a file is a test: by its name, unless it is a ROS program without any test in it, or a launch file."""
    name = os.path.basename(path)  # noqa: PTH119
    if _TEST_FILE.fullmatch(name) is None or name.endswith(".launch.py"):
        return False
    try:
        text = disk.head(path, _TESTED_BYTES)
    except OSError:
        return True
    return name == "conftest.py" or _PROGRAM.search(text) is None or _TESTING.search(text) is not None


def walk(start: str, tree: Tree, seen: set[str], *, include_tests: bool) -> None:
    """Add to `tree` what is under `start`, except folders that are in `seen` by their real path.

    What is reached without symbolic links comes first, so that a file with two ways to it has its plain name.
    """
    linked = [_Folder(start, disk.real_path(start), top=False, chosen=True)]
    position = 0
    while position < len(linked):
        plain = [linked[position]]
        position += 1
        while plain:
            folder = plain.pop()
            if folder.real in seen:
                continue
            if len(seen) >= _FOLDER_LIMIT:
                tree.not_files.append((folder.path, f"a folder beyond the first {_FOLDER_LIMIT:,}"))
                return
            seen.add(folder.real)
            inner, links = _enter(folder, tree, include_tests=include_tests)
            plain += reversed(inner)
            linked += links


def _enter(folder: _Folder, tree: Tree, *, include_tests: bool) -> tuple[list[_Folder], list[_Folder]]:
    """List one folder; the folders within, and those within that are symbolic links."""
    try:
        entries = disk.listing(folder.path)
    except OSError as error:
        tree.not_files.append((folder.path, f"a folder that cannot be listed: {error.strerror}"))
        return [], []
    names = {entry.name for entry in entries}
    if not folder.chosen:
        reason = _reason(folder, names)
        if reason is None and not include_tests and _is_test_folder(folder, names):
            reason = SkipReason.TEST
        if reason is not None:
            tree.skipped.append((folder.path, reason))
            return [], []
    outside = {e.name for e in entries if e.is_symlink() and _matters(e) and tree.boundary.leads_out(e.path)}
    descriptions = set(DESCRIPTIONS & names - outside)
    if descriptions:
        tree.descriptions[folder.path] = descriptions
    workspace = "src" in names or (folder.chosen and "__init__.py" not in names)
    workspace = workspace and "package.xml" not in names
    own = os.path.basename(folder.path) if "package.xml" in names else ""  # noqa: PTH119  demo/demo, build/build, test/test
    inner: list[_Folder] = []
    links: list[_Folder] = []
    for entry in entries:
        name = entry.name
        if tree.excluded and tree.excluded.of(entry.path) is not None:
            tree.skipped.append((entry.path, SkipReason.EXCLUDED))
            continue
        if name in outside:
            tree.outside.append(entry.path)
            continue
        try:
            is_folder, is_link = entry.is_dir(), entry.is_symlink()
        except OSError:
            is_folder, is_link = False, True
        if is_folder:
            if name.startswith(".") or name == "__pycache__":
                if name not in {"__pycache__", ".git"}:
                    tree.skipped.append((entry.path, SkipReason.HIDDEN))
                continue
            real = disk.real_path(entry.path) if is_link else f"{folder.real}{os.sep}{name}"
            (links if is_link else inner).append(_Folder(entry.path, real, top=workspace, chosen=name == own))
            if name.endswith(".py"):
                tree.not_files.append((entry.path, "a folder"))
        elif name.endswith(".py"):
            _python(entry, folder, tree, is_link=is_link, include_tests=include_tests)
        elif _LAUNCH.fullmatch(name):
            tree.launch.append(entry.path)
        elif _INTERFACE.fullmatch(name):
            tree.interfaces.append(entry.path)
        elif name.endswith(CPP_SOURCES) and not name.startswith("."):
            tree.cpp.append(entry.path)
    return inner, links


def _matters(entry: os.DirEntry[str]) -> bool:
    """Whether a link would be read, or entered, if it led inside."""
    name = entry.name
    if (
        name.endswith((".py", *CPP_SOURCES))
        or name in DESCRIPTIONS
        or _LAUNCH.fullmatch(name)
        or _INTERFACE.fullmatch(name)
    ):
        return True
    return (
        not name.startswith(".") and name != "__pycache__" and disk.is_folder(entry.path)
    )  # is_dir raises in a circle


def _is_test_folder(folder: _Folder, names: set[str]) -> bool:
    return os.path.basename(folder.path) in _TEST_FOLDERS and "package.xml" not in names  # noqa: PTH119


def _python(entry: os.DirEntry[str], folder: _Folder, tree: Tree, *, is_link: bool, include_tests: bool) -> None:
    if entry.name.startswith("."):
        tree.skipped.append((entry.path, SkipReason.HIDDEN))
        return
    try:
        regular = entry.is_file()
    except OSError:
        regular = False
    if not regular:
        tree.not_files.append((entry.path, "a broken link" if is_link else "not a regular file"))
    elif not include_tests and is_test_file(entry.path):
        tree.skipped.append((entry.path, SkipReason.TEST))
    elif is_link:
        tree.linked.append(entry.path)
    else:
        tree.python.setdefault(f"{folder.real}{os.sep}{entry.name}", entry.path)


def _reason(folder: _Folder, names: set[str]) -> SkipReason | None:
    """Why the folder holds nothing to read, judged by its name and what is in it."""
    name = os.path.basename(folder.path)  # noqa: PTH119
    if not names.isdisjoint(MARKERS):
        return SkipReason.BUILD_OUTPUT if name in _OUTPUT_NAMES else SkipReason.IGNORED
    if "pyvenv.cfg" in names or name in _INSTALLED or name.endswith(".egg-info"):
        return SkipReason.ENVIRONMENT
    if name in _OUTPUT_NAMES and "package.xml" not in names:
        if folder.top and name in {"build", "install", "log"}:
            return SkipReason.BUILD_OUTPUT
        if not names.isdisjoint(_OUTPUT_MARKS):
            return SkipReason.BUILD_OUTPUT
        if name == "build" and "__init__.py" not in names and names and all(map(_PYTHON_BUILD.fullmatch, names)):
            return SkipReason.BUILD_OUTPUT
    return None
