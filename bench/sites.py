# SPDX-License-Identifier: Apache-2.0
"""The third witness: the calls that create entities, found by their names in the syntax alone.

Nothing is resolved here, neither imports nor names: `x.create_publisher(...)` is a publisher whatever `x` is.
"""

from __future__ import annotations

import ast
import functools
import os
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from facts import Spot

# callee -> kind, position of the name among the arguments, keyword of the name
_CALLS = {
    "create_publisher": ("publisher", 1, "topic"),
    "create_lifecycle_publisher": ("publisher", 1, "topic"),
    "create_subscription": ("subscription", 1, "topic"),
    "create_service": ("service", 1, "srv_name"),
    "create_client": ("client", 1, "srv_name"),
    "ActionServer": ("action_server", 2, "action_name"),
    "ActionClient": ("action_client", 2, "action_name"),
}

_CPP_STATEMENTS = ("_statement", "declaration", "field_initializer", "function_definition")

LIBRARIES = {
    "TransformListener": "tf2",
    "TransformBroadcaster": "tf2",
    "StaticTransformBroadcaster": "tf2",
    "BufferClient": "tf2",
    "BufferServer": "tf2",
    "Subscriber": "message_filters",
    "Updater": "diagnostic_updater",
    "BasicNavigator": "nav2_simple_commander",
    "wait_for_message": "rclpy.wait_for_message",
    "ParameterEventHandler": "rclpy.parameter_event_handler",
    "AsyncParameterClient": "rclpy.parameter_client",
}
"""Calls of libraries that create entities on behalf of the user's code, and the library of each."""

_IGNORED_FOLDERS = {"build", "install", "log", "test", "tests", "venv", "node_modules", "site-packages", "__pycache__"}


@dataclass(frozen=True, slots=True)
class Site:
    """One call in the source. `name` is the text of a literal name, `written` the name argument as it is written."""

    kind: str
    file: str
    line: int
    end: int
    name: str | None
    written: str
    is_fstring: bool

    def covers(self, spot: Spot) -> bool:
        """Whether a place lies within this call."""
        return spot[0] == self.file and self.line <= spot[1] <= self.end

    def __str__(self) -> str:
        return f"{self.file}:{self.line}"


@dataclass(frozen=True, slots=True)
class Scan:
    """All calls of a folder: those that create an entity, those of the `LIBRARIES`, those that may create a node."""

    files: tuple[str, ...]
    unreadable: tuple[str, ...]
    entities: tuple[Site, ...]
    libraries: tuple[Site, ...]
    nodes: tuple[Site, ...]


def scan(root: Path) -> Scan:
    """Look through all Python files below `root` but those of tests, builds and hidden folders."""
    files: list[str] = []
    unreadable: list[str] = []
    found: dict[str, list[Site]] = {"entities": [], "libraries": [], "nodes": []}
    for path in _python_files(root):
        file = path.relative_to(root).as_posix()
        files.append(file)
        tree = _tree(path)
        if tree is None:
            unreadable.append(file)
            continue
        for call in ast.walk(tree):
            if isinstance(call, ast.Call):
                _sort(call, file, found)
    return Scan(
        tuple(files), tuple(unreadable), tuple(found["entities"]), tuple(found["libraries"]), tuple(found["nodes"])
    )


def parses(path: Path) -> bool:
    """Whether the running Python can parse a file."""
    return _tree(path) is not None


def _tree(path: Path) -> ast.Module | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(path.read_bytes())
    except (SyntaxError, ValueError, OSError, RecursionError, MemoryError):
        return None


def statement(path: Path, line: int) -> range:
    """The lines of the smallest statement around a line; the line alone where the file cannot be read."""
    around = [lines for lines in _statements(path) if line in lines]
    return min(around, key=len, default=range(line, line + 1))


@functools.lru_cache(maxsize=16)
def _statements(path: Path) -> tuple[range, ...]:
    if path.suffix != ".py":
        return tuple(_cpp_statements(path))
    tree = _tree(path)
    statements = [] if tree is None else [node for node in ast.walk(tree) if isinstance(node, ast.stmt)]
    return tuple(range(node.lineno, (node.end_lineno or node.lineno) + 1) for node in statements)


def _cpp_statements(path: Path) -> Iterator[range]:
    """The lines of the statements, members and first values of members in a C++ file."""
    import tree_sitter
    import tree_sitter_cpp

    parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))
    waiting = [parser.parse(path.read_bytes()).root_node] if path.is_file() else []
    while waiting:
        node = waiting.pop()
        waiting += node.named_children
        if node.type.endswith(_CPP_STATEMENTS) and node.type != "compound_statement":
            yield range(node.start_point[0] + 1, node.end_point[0] + 2)


def _python_files(root: Path) -> Iterator[Path]:
    for folder, subfolders, names in os.walk(root):
        if {"COLCON_IGNORE", "AMENT_IGNORE"} & set(names):
            subfolders.clear()
            continue
        subfolders[:] = sorted(s for s in subfolders if s not in _IGNORED_FOLDERS and not s.startswith("."))
        paths = (Path(folder, name) for name in sorted(names) if name.endswith(".py"))
        yield from (path for path in paths if path.is_file())


def _sort(call: ast.Call, file: str, found: dict[str, list[Site]]) -> None:
    callee = _callee(call.func)
    if callee in _CALLS:
        kind, position, keyword = _CALLS[callee]
        found["entities"].append(_site(kind, call, file, _argument(call, position, keyword)))
    elif callee in LIBRARIES:
        found["libraries"].append(_site(callee, call, file, None))
    elif callee in ("create_node", "Node", "LifecycleNode", "__init__"):
        found["nodes"].append(_site(callee, call, file, _argument(call, 0, "node_name")))


def _callee(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _argument(call: ast.Call, position: int, keyword: str) -> ast.expr | None:
    for given in call.keywords:
        if given.arg == keyword:
            return given.value
    return call.args[position] if position < len(call.args) else None


def _site(kind: str, call: ast.Call, file: str, name: ast.expr | None) -> Site:
    literal = name.value if isinstance(name, ast.Constant) and isinstance(name.value, str) else None
    fstring = isinstance(name, ast.JoinedStr) and any(isinstance(part, ast.FormattedValue) for part in name.values)
    written = "" if name is None else ast.unparse(name)
    return Site(kind, file, call.lineno, call.end_lineno or call.lineno, literal, written, fstring)
