# SPDX-License-Identifier: Apache-2.0
"""Which programs does a case hold, and what do they need to run?

setup.py with console_scripts `a = demo.nodes:main_a`    -> Program(start="demo.nodes:main_a")
main.py with `if __name__ == "__main__"`                 -> Program(start="main.py")
robot.py with a node class and nothing that starts it    -> Program(start="class:robot")
"""

from __future__ import annotations

import ast
import configparser
import re
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import Final

from .harness import Program

STAND_INS: Final = {"example_interfaces": "test_msgs"}
"""Packages of interfaces that no wheel is made of, and the one that holds the same types."""

_SKIPPED: Final = re.compile(r"(^|/)(build|install|log|\.[^/]*)/")


def runnable(files: Mapping[str, str]) -> dict[str, str]:
    """The files with interfaces that are there."""
    changed = dict(files)
    for missing, there in STAND_INS.items():
        changed = {name: re.sub(rf"\b{missing}\b", there, text) for name, text in changed.items()}
    return changed


def programs_of(files: Mapping[str, str], folder: Path) -> list[Program]:
    """What of a case is to be run, by the rules of ROS 2 and Python, not by those of the analysis."""
    marks = [str(PurePosixPath(name).parent) + "/" for name in files if name.endswith("COLCON_IGNORE")]
    read = {
        name: text
        for name, text in files.items()
        if not _SKIPPED.search(name) and not any(name.startswith(mark) for mark in marks)
    }
    path = tuple(sorted({str(PurePosixPath(n).parent) for n in read if n.endswith("setup.py")} | {"."}))
    scripts = [start for name, text in sorted(read.items()) for start in _scripts(name, text)]
    if scripts:
        return [Program(folder, start, path=path) for start in scripts]
    modules = {name: ast.parse(text) for name, text in read.items() if name.endswith(".py") and "/" not in name}
    imported = {name for tree in modules.values() for name in _imports(tree)}
    starts = [name for name, tree in modules.items() if _acts(tree)]
    if not starts:
        starts = [f"class:{name[:-3]}" for name in modules if name[:-3] not in imported or len(modules) > 1]
    return [Program(folder, start) for start in starts if start[:-3] not in imported]


def _scripts(name: str, text: str) -> Iterator[str]:
    if name.endswith("setup.py"):
        yield from re.findall(r"[\"']\s*[\w-]+\s*=\s*([\w.]+:\w+)\s*[\"']", text)
    if name.endswith("setup.cfg"):
        config = configparser.ConfigParser()
        config.read_string(text)
        for line in config.get("options.entry_points", "console_scripts", fallback="").split("\n"):
            if "=" in line:
                yield line.partition("=")[2].strip()


def _imports(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module


def _acts(tree: ast.Module) -> bool:
    """Whether the file does something with rclpy by itself."""
    rest = [
        node for node in tree.body if not isinstance(node, (ast.Import, ast.ImportFrom, ast.FunctionDef, ast.ClassDef))
    ]
    return any(
        "rclpy" in ast.dump(node) or "__name__" in ast.dump(node) or "'main'" in ast.dump(node)
        for node in rest
        if any(isinstance(inner, (ast.Call, ast.If)) for inner in ast.walk(node))
    )
