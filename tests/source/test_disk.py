# SPDX-License-Identifier: Apache-2.0
"""What an analysis sees of the disk is noted, whatever it is, and told from anything else."""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from rosward import extract
from rosward.source import disk

SOURCE = Path(disk.__file__).parent.parent
READING = (
    "source",
    "analysis",
    "deployment",
    "frontends",
    "engine",
    "models",
    "naming",
    "network",
    "effects",
    "flow",
    "ros",
    "policies",
    "suppression",
    "influence",
    "enclaves",
    "explanation",
    "outputs",
    "cli/check.py",
    "cli/configuration.py",
    "cli/configuration_file.py",
    "cli/extract.py",
    "cli/reviewing.py",
    "cli/shared.py",
)
"""The folders and modules of what runs while sources are analysed, or in a run that is said again."""

LOOKS = {
    "os.path": {
        "exists",
        "getmtime",
        "getsize",
        "isdir",
        "isfile",
        "islink",
        "ismount",
        "lexists",
        "realpath",
        "samefile",
    },
    "os": {"access", "listdir", "lstat", "open", "readlink", "scandir", "stat", "walk"},
}
METHODS = {
    "exists", "glob", "is_dir", "is_file", "is_symlink", "iterdir", "lstat", "read_bytes", "read_text", "resolve", "rglob", "samefile", "stat",
}  # fmt: skip
OF_ENTRIES = {"is_dir", "is_file", "is_symlink"}
"""What an entry of a listing knows: that was noted with the listing."""

OWN = {
    "source/interfaces.py",
    "source/kept.py",
    "source/same.py",
    "outputs/whole_files.py",
    "frontends/cpp/flow_marks.py",
    "frontends/cpp/model_headers.py",
}
"""They read files of rosward itself, or write; `same.py` is how `disk.py` looks."""


def _looks_past(tree: ast.Module) -> list[str]:
    found: list[str] = []
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = ast.unparse(node.func)
        owner, _, method = name.rpartition(".")
        if name == "open" or method in LOOKS.get(owner, ()):
            found.append(f"{node.lineno}: {name}")
        elif (
            isinstance(node.func, ast.Attribute)
            and method in METHODS
            and not (method in OF_ENTRIES and owner == "entry")
        ):
            receiver = ast.unparse(node.func.value)
            if any(word in receiver.lower() for word in ("path", "folder", "file", "/")) and "files" not in receiver:
                found.append(f"{node.lineno}: {name}")
    return found


@pytest.mark.slow
def test_nobody_looks_past_it() -> None:
    """A look that is not noted would let an old result stand for new sources."""
    wrong = [
        f"{name}:{each}"
        for folder in READING
        for path in ([SOURCE / folder] if folder.endswith(".py") else sorted((SOURCE / folder).rglob("*.py")))
        if (name := path.relative_to(SOURCE).as_posix()) != "source/disk.py" and name not in OWN
        for each in _looks_past(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert wrong == []


FILES = {
    "src/demo/package.xml": "<package format='3'><name>demo</name><export><build_type>ament_python</build_type></export></package>",
    "src/demo/setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
    "    entry_points={'console_scripts': ['talker = demo.talker:main']})\n",
    "src/demo/resource/demo": "",
    "src/demo/demo/__init__.py": "",
    "src/demo/demo/talker.py": "import rclpy\nfrom rclpy.node import Node\nfrom demo import names\n\n\ndef main():\n    Node(names.NAME)\n",
    "src/demo/demo/names.py": "NAME = 'talker'\n",
    "src/pump/package.xml": "<package format='3'><name>pump</name></package>",
    "src/pump/CMakeLists.txt": "project(pump)\nadd_executable(pump src/pump.cpp)\ninstall(TARGETS pump DESTINATION lib/pump)\n",
    "src/pump/src/pump.cpp": '#include "rclcpp/rclcpp.hpp"\n#include "name.hpp"\nint main() { auto n = rclcpp::Node::make_shared(NAME); }\n',
    "src/pump/src/name.hpp": '#define NAME "pump"\n',
    "src/launching/package.xml": "<package format='3'><name>launching</name></package>",
    "src/launching/launch/all.launch.xml": "<launch><node pkg='demo' exec='talker'/></launch>\n",
    "src/notes.txt": "nobody reads this",
}


def _written(folder: Path) -> Path:
    for name, text in FILES.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


class Opened:
    """What the interpreter opens and lists, once it is asked to tell; a hook cannot be taken away again."""

    def __init__(self) -> None:
        self.found: list[tuple[str, str]] | None = None

    def __call__(self, event: str, arguments: tuple[object, ...]) -> None:
        if self.found is None or event not in ("open", "os.listdir", "os.scandir"):
            return
        if isinstance(arguments[0], (str, os.PathLike)):
            self.found.append((event, os.fspath(arguments[0])))


@pytest.fixture(scope="module")
def opened() -> Opened:
    found = Opened()
    sys.addaudithook(found)
    return found


@pytest.mark.parametrize("launched", [False, True])
def test_all_that_is_opened_or_listed_is_noted(tmp_path: Path, opened: Opened, launched: bool) -> None:
    """The interpreter itself tells what is opened."""
    folder = _written(tmp_path)
    told: list[tuple[str, str]] = []
    opened.found = told
    with disk.watching() as trace:
        extract(folder, launch=["launching:all.launch.xml"] if launched else [])
    opened.found = None
    below = {(event, path) for event, path in told if path.startswith(str(folder))}
    noted = {path for how, path in trace.seen if how.partition(" ")[0] in ("read", "head")}
    listed = {path for how, path in trace.seen if how == "list"}
    assert {path for event, path in below if event == "open"} <= noted
    assert {path for event, path in below if event != "open"} <= listed
    assert noted
    assert disk.holds(trace.seen)
    assert not trace.torn


def _replace(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")


def _folder_instead(ws: Path) -> None:
    (ws / "src/demo/demo/names.py").unlink()
    (ws / "src/demo/demo/names.py").mkdir()


def _link_instead(ws: Path) -> None:
    (ws / "src/demo/demo/names.py").rename(ws / "names.txt")
    (ws / "src/demo/demo/names.py").symlink_to(ws / "names.txt")


def _nearer(ws: Path) -> None:
    (ws / "src/pump/src/rclcpp").mkdir()
    _replace(ws / "src/pump/src/rclcpp/rclcpp.hpp", "")


CHANGES: dict[str, Callable[[Path], object]] = {
    "a line": lambda ws: _replace(ws / "src/demo/demo/names.py", "NAME = 'other'\n"),
    "a header": lambda ws: _replace(ws / "src/pump/src/name.hpp", '#define NAME "other"\n'),
    "a module in the place of a model": lambda ws: _replace(ws / "src/demo/rclpy.py", "class Node: pass\n"),
    "a module where none was": lambda ws: _replace(ws / "src/demo/demo/more.py", ""),
    "a file that is gone": lambda ws: (ws / "src/demo/demo/names.py").unlink(),
    "a mark": lambda ws: _replace(ws / "src/demo/COLCON_IGNORE", ""),
    "a folder in the place of a file": _folder_instead,
    "a link in the place of a file": _link_instead,
    "a header nearer": _nearer,
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_is_seen(tmp_path: Path, change: str) -> None:
    folder = _written(tmp_path)
    with disk.watching() as trace:
        extract(folder)
    assert disk.holds(trace.seen)
    CHANGES[change](folder)
    assert not disk.holds(trace.seen)


def test_what_nobody_looked_at_may_change(tmp_path: Path) -> None:
    folder = _written(tmp_path)
    with disk.watching() as trace:
        extract(folder)
    _replace(folder / "src/notes.txt", "nor this")
    os.utime(folder / "src/demo/demo/talker.py", (1, 1))
    assert disk.holds(trace.seen)


def test_what_changes_meanwhile_is_told(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("a", encoding="utf-8")
    with disk.watching() as trace:
        disk.read(path, 10)
        path.write_text("b", encoding="utf-8")
        disk.read(path, 10)
    assert trace.torn


@pytest.mark.parametrize(
    "look", [("unknown", "/"), ("read x", "/"), ("read", "/"), ("kind", "a\0b"), ("list", "a\0b"), ("real", "a\0b")]
)
def test_a_look_that_makes_no_sense_does_not_hold(look: disk.Look) -> None:
    assert not disk.holds({look: "something"})
