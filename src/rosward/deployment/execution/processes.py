# SPDX-License-Identifier: Apache-2.0
"""What an ExecuteProcess starts: the node of `ros2 run`, the system of `ros2 launch`, a script, or any other program.

cmd=['ros2', 'run', 'demo', 'talker', '-v']          ->  Started(NODE, package='demo', executable='talker', words: -v)
cmd=[ExecutableInPackage('talker', 'demo'), '-v']    ->  the same
cmd=['ros2 launch demo a.launch.py x:=1'], shell     ->  Launch('demo', 'a.launch.py', {'x': '1'})
cmd=['python3', '/opt/tool.py', '--fast']            ->  Started(PROCESS, executable='/opt/tool.py', words: --fast)
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.nodes import At, environment, installed_program
from rosward.deployment.execution.word_files import word_files
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.started import Started, StartKind
from rosward.deployment.tree import StartProcess
from rosward.domain.choice import join, lift2, options
from rosward.domain.text import concat, make, origins_of, parts_of
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import EMPTY, Const, Unknown, Value
from rosward.effects.configuration import Configuration
from rosward.effects.shell import ORIGIN
from rosward.location import Place
from rosward.models.python.shell.lines import Command, of_line, started_by
from rosward.models.python.shell.words import split
from rosward.models.python.std.paths import basename
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene

_MOST: Final = 4
_PYTHON: Final = ("python3", "python", "python2")
_BLANK: Final = Const(" ")


class Launch(NamedTuple):
    """`ros2 launch`: a system of its own. `package` None: `file` is a path."""

    package: Value | None
    file: Value
    arguments: dict[str, Value]


def start_process(action: StartProcess, scene: Scene, at: At) -> list[Started | Launch]:
    """What the command line starts, for each alternative of a shell's command line."""
    words = [scene.text(word) for word in action.command]
    look = partial(_variable, scene, action.place)
    lines = _joined(words) if action.shell else [None]
    at = at.maybe("a command line with several alternatives") if len(lines) > 1 else at
    found: list[Started | Launch] = []
    for line in lines:
        plain = tuple(words) if line is None else split(line)
        commands = started_by(words, look, action.place) if line is None else of_line(line, look, action.place)
        for each in commands:
            shown = words if each.words == plain else each.words
            found.append(_process(each, shown, action, scene, at))
    return found


def _joined(words: Sequence[Value]) -> list[Value | None]:
    """The line that a shell is given; its alternatives."""
    line: Value = EMPTY
    for index, word in enumerate(words):
        line = lift2(lambda a, b: concat((a, _BLANK, b)), line, word) if index else word
    return list(options(line)) if len(options(line)) <= _MOST else [None]


def _variable(scene: Scene, place: Place, name: str, default: str | None) -> Value:
    """What a variable of the environment holds where the shell expands it."""
    held = scene.context.variable(name)
    instead = Const(default or "", frozenset({Origin(ORIGIN, name)}))
    if held is not None and held.sure:
        return instead if held.value is None else held.value
    if default is not None and held is None:
        return instead
    unknown = Unknown((Reason(Cause.ENVIRONMENT, name, place),), "str")
    return unknown if held is None or held.value is None else join(held.value, unknown)


def _process(
    started: Command, command: Sequence[Value], action: StartProcess, scene: Scene, at: At
) -> Started | Launch:
    """`command`: the words that are shown, those of the launch file where these are the same."""
    words = started.words
    program = plain_text(basename(words[0])) if len(options(words[0])) == 1 else None
    verb = plain_text(words[1]) if len(words) > 1 else None
    kind, package, rest = StartKind.PROCESS, None, tuple(words[1:])
    executable: Value = words[0]
    if program == "ros2" and verb == "run" and len(_without_prefix(words[2:])) >= 2:
        package, executable, *arguments = _without_prefix(words[2:])
        kind, rest = StartKind.NODE, tuple(arguments)
    elif program == "ros2" and verb == "launch":
        launch = _launch(words[2:])
        if launch is not None:
            return launch
    elif (of_package := installed_program(words[0])) is not None:
        kind, (package, executable) = StartKind.NODE, of_package
    elif program in _PYTHON and len(words) > 1 and not (verb or "").startswith("-"):
        executable, rest = words[1], tuple(words[2:])
    own = word_files(rest, scene, action.place)
    given = {
        **environment(action.environment, action.replaces_environment, scene, action.place),
        **dict(started.assigned),
    }
    return Started(
        kind=kind,
        place=action.place,
        configuration=Configuration(words=rest, files=own.files, missing=own.missing, environment=given),
        package=package,
        executable=executable,
        command=tuple(command),
        conditional=at.conditional,
        why=at.why,
        event=at.event,
        trail=at.trail,
    )


def _without_prefix(words: Sequence[Value]) -> list[Value]:
    """The words behind `ros2 run`, without its own option --prefix."""
    found = list(words)
    while found and (plain_text(found[0]) or "").startswith("--prefix"):
        found = found[1:] if "=" in (plain_text(found[0]) or "") else found[2:]
    return found


def _launch(words: Sequence[Value]) -> Launch | None:
    plain = [w for w in words if not (plain_text(w) or "").startswith("-")]
    targets = [w for w in plain if ":=" not in "".join(p for p in parts_of(w) if isinstance(p, str))]
    arguments: dict[str, Value] = {}
    for word in plain:
        first, *rest = parts_of(word)
        if isinstance(first, str) and ":=" in first:
            name, _, value = first.partition(":=")
            arguments[name] = make((value, *rest), origins_of(word))
    if len(targets) == 1:
        return Launch(None, targets[0], arguments)
    return Launch(targets[0], targets[1], arguments) if len(targets) > 1 else None
