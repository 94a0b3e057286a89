# SPDX-License-Identifier: Apache-2.0
"""Python launch files as text, and the tree of actions that they give as lines.

    def generate_launch_description(): return LaunchDescription([Node(package='demo', executable='talker')])
    ->  4: StartNode package=demo executable=talker
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from textwrap import dedent, indent

from deployment.markup_tree import told
from rosward.deployment.python_code import LaunchPython
from rosward.deployment.tree import Action, Description, OnEvent, Opaque, Substitution, Template
from rosward.domain.text import concat, pattern
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.engine.library import Library
from rosward.models.tables import natives
from rosward.source.discover import discover
from rosward.source.location import Place
from rosward.sources import SourceTree

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
"""What stands before each launch file here; line numbers count from behind it."""

HERE = Place("main.launch.py", 1)
EVENT = Unknown((Reason(Cause.INPUT, "event", HERE),))


class Launch:
    """A small execution: configurations that are given, and those that are set meanwhile."""

    def __init__(self, configurations: Mapping[str, Value] = {}, words: Sequence[str] = ()) -> None:  # noqa: B006
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
            return self.values.get(pattern(texts[0])) or (texts[1] if len(texts) > 1 else self._unknown(pattern(texts[0])))
        if piece.kind == "eval":
            return self.python.evaluate(texts[0], [pattern(t) for t in texts[1:]], self)
        return self._unknown(piece.kind)

    def _unknown(self, what: str) -> Value:
        return Unknown((Reason(Cause.ARGUMENT, what, HERE),), "str")

    def configuration(self, name: str) -> Value | None:
        return self.values.get(name)

    def configurations(self) -> Mapping[str, Value]:
        return self.values

    def set_configuration(self, name: str, value: Value | None) -> None:
        self.values.pop(name, None)
        if value is not None:
            self.values[name] = value

    def variable(self, name: str) -> Value | None:
        return self.variables.get(name)

    def set_variable(self, name: str, value: Value | None) -> None:
        self.variables.pop(name, None)
        if value is not None:
            self.variables[name] = value

    def given(self) -> Sequence[str]:
        return self.words


class Files:
    """Launch files in a folder, and the interpreter for them."""

    def __init__(self, folder: Path, text: str, others: Mapping[str, str] = {}) -> None:  # noqa: B006
        for name, content in {"main.launch.py": HEAD + dedent(text), **others}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(dedent(content), encoding="utf-8")
        self.tree = SourceTree(discover([folder]))
        self.python = LaunchPython(Library(self.tree, natives()))

    def read(self, launch: Launch, file: str = "main.launch.py") -> Description:
        """One file."""
        launch.python = self.python
        return self.python.read(file, launch)

    def shown(self, actions: Sequence[Action], launch: Launch) -> str:
        """Actions as lines; below a function stands what it gives."""
        lines: list[str] = []
        for action in actions:
            lines.append(told((_counted(action),), []))
            given: tuple[Action, ...] = ()
            if isinstance(action, Opaque):
                given = self.python.actions(action.function, action.args, dict(action.kwargs), launch, context=True)
            elif isinstance(action, OnEvent) and action.function is not None:
                given = self.python.actions(action.function, (EVENT,), {}, launch, context=False)
            if given:
                lines.append(indent(self.shown(given, launch), "    "))
        return "\n".join(lines)


def _counted(action: Action) -> Action:
    """The function of an action is shown by what it gives."""
    return action


def values(**texts: str) -> dict[str, Value]:
    """Launch configurations."""
    return {name: Const(text) for name, text in texts.items()}
