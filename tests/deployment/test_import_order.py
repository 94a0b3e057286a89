# SPDX-License-Identifier: Apache-2.0
"""Promise: neither the order of imports in a launch file nor the order of launch files changes what is started.

ROSWARD_CORPUS names a folder of checkouts: all their launch files are read in both orders.
"""

from __future__ import annotations

import itertools
import os
from pathlib import Path

import pytest

from deployment.python_tree import Files, Launch
from rosward.analysis.source_tree import SourceTree
from rosward.deployment.python.code import LaunchPython
from rosward.engine.libraries.library import Library
from rosward.models.tables import own_models
from rosward.source.discover import discover

IMPORTS = (
    "from launch_ros.actions import Node",
    "from launch import LaunchDescription",
    "from launch.conditions import IfCondition",
    "from launch.substitutions import LaunchConfiguration",
)
BODY = """

def generate_launch_description():
    on = IfCondition(LaunchConfiguration('on'))
    return LaunchDescription([Node(package='p', executable='x'), Node(package='p', executable='y', condition=on)])
"""


def _text(imports: tuple[str, ...]) -> str:
    return "\n".join(imports) + BODY


def test_imports_in_any_order(tmp_path: Path) -> None:
    """All orders of four imports give one tree, with its condition."""
    orders = list(itertools.permutations(IMPORTS))
    shown = set()
    for number, imports in enumerate(orders):
        files = Files(tmp_path / str(number), "", {"a.launch.py": _text(imports)})
        shown.add(files.shown(Launch(), "a.launch.py").replace(f"/{number}/", "/"))
    assert len(shown) == 1
    assert "condition=" in shown.pop()


def test_files_in_any_order(tmp_path: Path) -> None:
    """A file is the same whichever was read before it."""
    others = {"a.launch.py": _text(IMPORTS), "b.launch.py": _text(IMPORTS[::-1])}
    first, second = (Files(tmp_path / name, "", others) for name in ("one", "two"))
    one = [first.shown(Launch(), name) for name in ("a.launch.py", "b.launch.py")]
    two = [second.shown(Launch(), name) for name in ("b.launch.py", "a.launch.py")]
    assert one == two[::-1]


def _checkouts() -> list[Path]:
    folder = os.environ.get("ROSWARD_CORPUS")
    return sorted(p for p in Path(folder).iterdir() if p.is_dir()) if folder else []


@pytest.mark.skipif(not _checkouts(), reason="ROSWARD_CORPUS names no folder of checkouts")
@pytest.mark.parametrize("checkout", _checkouts(), ids=lambda p: p.name)
def test_launch_files_of_real_repositories(checkout: Path) -> None:
    """Forwards and backwards, each launch file gives the same tree."""
    names = [f.relative for f in discover([checkout]).launch_files if f.relative.endswith(".py")]
    read = []
    for order in (names, names[::-1]):
        files = Files.__new__(Files)
        files.tree = SourceTree(discover([checkout]))
        files.python = LaunchPython(Library(files.tree, own_models()))
        found = {}
        for name in order:
            launch = Launch()
            found[name] = list(files.lines(files.read(launch, name).actions, launch, ""))
        read.append(found)
    assert read[0] == read[1]
