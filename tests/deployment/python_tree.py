# SPDX-License-Identifier: Apache-2.0
"""Python launch files as text, and the tree of actions that they give as lines.

def generate_launch_description(): return LaunchDescription([Node(package='demo', executable='talker')])
->  StartNode package=demo executable=talker
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from textwrap import dedent

from rosward.analysis.source_tree import SourceTree
from rosward.deployment.python.code import LaunchPython
from rosward.deployment.tree import (
    Added,
    Condition,
    Description,
    LaunchAction,
    Literal,
    OnEvent,
    Opaque,
    ParameterArgument,
    ParameterFile,
    ParameterTable,
    Several,
    Substitution,
    Template,
    Typed,
)
from rosward.domain.choice import options
from rosward.domain.compound import Partial, Tuple
from rosward.domain.text import concat, pattern
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Choice, Const, Unknown, Value
from rosward.engine.libraries.library import Library
from rosward.location import Place
from rosward.models.tables import own_models
from rosward.source.discover import discover

HEAD = """\
import os, sys
from launch import LaunchDescription, Action, Substitution, Condition
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.launch_description_sources import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import *
from launch_ros.substitutions import FindPackageShare
"""
"""What stands before each launch file here."""

HERE = Place("main.launch.py", 1)
EVENT = Unknown((Reason(Cause.INPUT, "event", HERE),))


class Launch:
    """A small execution: configurations that are given, and those that are set meanwhile."""

    def __init__(self, configurations: Mapping[str, Value] = {}, words: Sequence[str] = ()) -> None:
        self.values = dict(configurations)
        self.variables: dict[str, Value] = {}
        self.words = words
        self.python: LaunchPython | None = None

    def text(self, template: Template) -> Value:
        pieces = [self._performed(p) if isinstance(p, Substitution) else p for p in template]
        return pieces[0] if len(pieces) == 1 else concat(pieces)

    def _performed(self, piece: Substitution) -> Value:
        assert self.python is not None
        if piece.kind == "python" and piece.value is not None:
            return self.python.perform(piece.value, self)
        texts = [self.text(a) for a in piece.arguments]
        if piece.kind == "var":
            return self.values.get(pattern(texts[0])) or (
                texts[1] if len(texts) > 1 else self._unknown(pattern(texts[0]))
            )
        if piece.kind == "eval":
            return self.python.evaluate(texts[0], [pattern(t) for t in texts[1:]], self)
        return self._unknown(piece.kind)

    def _unknown(self, what: str) -> Value:
        return Unknown((Reason(Cause.ARGUMENT, what, HERE),), "str")

    def configuration(self, name: str) -> Value | None:
        return self.values.get(name)

    def configurations(self) -> Mapping[str, Value]:
        return self.values

    def add_to_configuration(self, name: str, value: Value) -> None: ...

    def rewrite_configuration(self, name: str, value: Value) -> None: ...

    def set_configuration(self, name: str, value: Value | None) -> None:
        self.values.pop(name, None)
        if value is not None:
            self.values[name] = value

    def variable(self, name: str) -> Value | None:
        return self.variables.get(name)

    def removed(self, name: str) -> bool:
        del name
        return False

    def set_variable(self, name: str, value: Value | None) -> None:
        self.variables.pop(name, None)
        if value is not None:
            self.variables[name] = value

    def new_path(self) -> Value:
        return Const("/tmp/launch_files_1")

    def write_file(self, path: Value, text: Value) -> None:
        del path, text

    def written(self, path: Value) -> Value | None:
        del path
        return None

    def given(self) -> Sequence[str]:
        return self.words


class Files:
    """Launch files in a folder, and the interpreter for them."""

    def __init__(self, folder: Path, text: str, others: Mapping[str, str] = {}) -> None:
        for name, content in {"main.launch.py": HEAD + dedent(text), **others}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(dedent(content), encoding="utf-8")
        self.tree = SourceTree(discover([folder]))
        self.python = LaunchPython(Library(self.tree, own_models()))

    def read(self, launch: Launch, file: str = "main.launch.py") -> Description:
        """One file."""
        launch.python = self.python
        return self.python.read(file, launch)

    def shown(self, launch: Launch, file: str = "main.launch.py") -> str:
        """What a file gives, as lines, and the findings."""
        lines = self.lines(self.read(launch, file).actions, launch, "")
        return "\n".join([*lines, *(f"{f.code}: {f.message}" for f in self.python.findings)])

    def lines(self, actions: Sequence[LaunchAction], launch: Launch, indent: str) -> Iterator[str]:
        """Actions as lines, but for the ends of launch descriptions; below a function stands what it gives."""
        for action in actions:
            if isinstance(action, Added):
                continue
            yield indent + " ".join([type(action).__name__, *_fields(action)])
            inner: list[LaunchAction] = []
            for name in ("actions", "body", "on_exit", "components"):
                inner += getattr(action, name, ())
            if isinstance(action, Opaque):
                inner += self.python.actions(action.function, action.args, dict(action.kwargs), launch, context=True)
            elif isinstance(action, OnEvent) and action.function is not None:
                late = Partial(action.function, (EVENT,), ())
                inner += self.python.actions(late, (), {}, launch, context=True)
            yield from self.lines(inner, launch, indent + "  ")


def _fields(action: LaunchAction) -> Iterator[str]:
    """What an action is given, without what it has anyway."""
    for field in fields(action):
        value = getattr(action, field.name)
        hidden = field.name in _HIDDEN or (field.name == "target" and isinstance(action, OnEvent))
        if not hidden and value not in (field.default, (), None):
            yield f"{field.name}={shown(value)}"


_HIDDEN = (
    "place",
    "identity",
    "several",
    "loader",
    "actions",
    "body",
    "on_exit",
    "components",
    "function",
    "args",
    "kwargs",
)


def shown(value: object) -> str:
    """A field: templates as XML has them, `*` for what is not known."""
    match value:
        case Substitution(kind, arguments, _, _, tables):
            rewrites = ["{" + ", ".join(f"{shown(k)}: {shown(v)}" for k, v in table) + "}" for table in tables if table]
            return f"$({' '.join([kind, *map(shown, arguments), *rewrites])})"
        case Condition(kind, arguments):
            return f"{kind}({' '.join(map(shown, arguments))})"
        case ParameterTable(entries):
            return "{" + ", ".join(f"{shown(name)}: {shown(data)}" for name, data in entries) + "}"
        case ParameterFile(path, _, substitutions):
            return f"file {shown(path)}{' with substitutions' if substitutions else ''}"
        case ParameterArgument(name, data):
            return f"-p {shown(name)}:={shown(data)}"
        case Literal(data):
            return constant(data)
        case Typed(text, kind):
            return f"yaml {shown(text)}" + (f" as {kind}" if kind else "")
        case Several(items):
            return f"[{', '.join(map(shown, items))}]"
        case Value():
            return " | ".join(str(o.value) if isinstance(o, Const) else pattern(o) for o in options(value))
        case tuple() if value and all(isinstance(v, (Value, Substitution)) for v in value):
            return "".join(map(shown, value))
        case tuple():
            return f"[{', '.join(map(shown, value))}]"
        case _:
            return str(value)


def constant(value: object) -> str:
    """A value as Python writes it."""
    match value:
        case Tuple():
            return f"[{', '.join(map(constant, value.items))}]"
        case Const():
            return repr(value.value)
        case Choice():
            return " | ".join(map(constant, value.options))
        case _:
            return "*"


def values(**texts: str) -> dict[str, Value]:
    """Launch configurations."""
    return {name: Const(text) for name, text in texts.items()}
