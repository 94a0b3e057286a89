# SPDX-License-Identifier: Apache-2.0
"""Which launch files do the sources have, and which arguments do they declare?

    ->  (LaunchFile('bringup/launch/robot.launch.py', 'bringup', (Argument('sim', 'false', ('true', 'false'), 'Simulate'),)),)

The files are read, not executed: arguments that a function adds, and those of included files, are not among them (`ros2 launch
--show-args` differs in that).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.source_tree import SourceTree
from rosward.deployment import tree
from rosward.deployment.execution.findings import FindingLog
from rosward.deployment.execution.generated import GeneratedFiles
from rosward.deployment.execution.includes import Descriptions
from rosward.deployment.execution.scene import Scene
from rosward.deployment.execution.substitutions import SUBSTITUTIONS
from rosward.deployment.files import WorkspaceFiles
from rosward.deployment.python.code import LaunchPython
from rosward.domain.text import readable
from rosward.effects.shell import shell
from rosward.engine.budget import Budget
from rosward.engine.libraries.library import Library
from rosward.models.tables import own_models
from rosward.records import NamedTuple
from rosward.ros.distro import Distro
from rosward.source.discover import discover
from rosward.source.surroundings import surroundings
from rosward.source.workspace import SourceFile

__all__ = ["LaunchFile", "OfferedArgument", "launch_files"]

_MOST_FILES: Final = 200
_MOST_ARGUMENTS: Final = 100
_LONGEST: Final = 500
_SMALL: Final = Budget(steps=50_000, entry_steps=10_000, seconds=3.0)


class OfferedArgument(NamedTuple):
    """A launch argument; `default` is None where it has to be given, `*` stands for what is not known of it."""

    name: str
    default: str | None
    choices: tuple[str, ...]
    description: str


class LaunchFile(NamedTuple):
    """A launch file as it is named in the sources, and its package."""

    file: str
    package: str
    arguments: tuple[OfferedArgument, ...]


def launch_files(root: Path, distro: str, env: Mapping[str, str] | None = None) -> tuple[LaunchFile, ...]:
    """The launch files below a folder, or the one that is named, as they are in an environment."""
    return with_deep_stack(lambda: _launch_files(root, Distro(distro), surroundings(distro, env)))


def _launch_files(root: Path, distro: Distro, variables: Mapping[str, str]) -> tuple[LaunchFile, ...]:
    workspace = discover([root], environment=variables)
    sources = SourceTree(workspace)
    library = Library(sources, own_models(), environment=shell(variables))
    known = sorted(workspace.launch_files, key=lambda f: f.relative)[:_MOST_FILES]
    return tuple(_read(file, library, WorkspaceFiles(sources.files), distro) for file in known)


def _read(file: SourceFile, library: Library, files: WorkspaceFiles, distro: Distro) -> LaunchFile:
    findings = FindingLog()
    python = LaunchPython(library, _SMALL)
    scene = Scene(files, python, findings, GeneratedFiles(files, findings), distro, SUBSTITUTIONS, library.environment)
    description = Descriptions(files, python, findings).read(file.relative, "any", scene)
    arguments: dict[str, OfferedArgument] = {}
    for declared in _declared(description.actions if description is not None else ()):
        name = _text_of(declared.name, scene)
        if name and "*" not in name and len(arguments) < _MOST_ARGUMENTS:
            arguments.setdefault(name, _argument(name, declared, scene))
    return LaunchFile(file.relative, file.package.name if file.package is not None else "", tuple(arguments.values()))


def _declared(actions: Sequence[tree.LaunchAction]) -> Iterator[tree.Declare]:
    """The declarations, also those in groups and behind conditions of the Python around them."""
    waiting = list(reversed(actions))
    while waiting:
        action = waiting.pop()
        if isinstance(action, tree.Declare):
            yield action
        elif isinstance(action, (tree.Group, tree.Maybe)):
            waiting += reversed(action.actions)


def _argument(name: str, declared: tree.Declare, scene: Scene) -> OfferedArgument:
    default = None if declared.default is None else _text_of(declared.default, scene)
    choices = tuple(_text_of(choice, scene) for choice in declared.choices or ())
    return OfferedArgument(name, default, choices, _text_of(declared.description, scene))


def _text_of(template: tree.Template, scene: Scene) -> str:
    """The text of a template without the context of a launch."""
    return readable(scene.text(template))[:_LONGEST]
