# SPDX-License-Identifier: Apache-2.0
"""What an ExecuteProcess starts: the node of `ros2 run`, the system of `ros2 launch`, a script, or any other program.

cmd=['ros2', 'run', 'demo', 'talker', '-v']          ->  Started(NODE, package='demo', executable='talker', words: -v)
cmd=[ExecutableInPackage('talker', 'demo'), '-v']    ->  the same
cmd=['ros2 launch demo a.launch.py x:=1'], shell     ->  Launch('demo', 'a.launch.py', {'x': '1'})
cmd=['python3', '/opt/tool.py', '--fast']            ->  Started(PROCESS, executable='/opt/tool.py', words: --fast)
"""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.nodes import At, environment
from rosward.deployment.execution.word_files import word_files
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.started import Started, StartKind
from rosward.deployment.tree import StartProcess
from rosward.domain.choice import lift2, options
from rosward.domain.text import concat, make, origins_of, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, Const, Hole, Value
from rosward.effects.configuration import Configuration
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
    lines = _shell_lines(words) if action.shell else [tuple(words)]
    at = at.maybe("a command line with several alternatives") if len(lines) > 1 else at
    return [_process(line, words, action, scene, at) for line in lines if line]


def _shell_lines(words: Sequence[Value]) -> list[tuple[Value, ...]]:
    line: Value = EMPTY
    for index, word in enumerate(words):
        line = lift2(lambda a, b: concat((a, _BLANK, b)), line, word) if index else word
    if len(options(line)) > _MOST:
        return [tuple(words)]
    return [split(option) for option in options(line)]


def split(text: Value) -> tuple[Value, ...]:
    """The words of a text as a shell splits it, holes within words."""
    holes: list[Hole] = []
    plain = ""
    for part in parts_of(text):
        if isinstance(part, Hole):
            plain += f"\0{len(holes)}\0"
            holes.append(part)
        else:
            plain += part.replace("\0", "")
    try:
        words = shlex.split(plain)
    except ValueError:
        words = plain.split()
    return tuple(make(_restored(word, holes), origins_of(text)) for word in words)


def _restored(word: str, holes: Sequence[Hole]) -> list[str | Hole]:
    return [holes[int(part)] if index % 2 else part for index, part in enumerate(word.split("\0"))]


def _process(
    words: Sequence[Value], command: Sequence[Value], action: StartProcess, scene: Scene, at: At
) -> Started | Launch:
    """`words` are those that the program gets, `command` those that the launch file gives."""
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
    elif (installed := _installed(words[0])) is not None:
        kind, (package, executable) = StartKind.NODE, installed
    elif program in _PYTHON and len(words) > 1 and not (verb or "").startswith("-"):
        executable, rest = words[1], tuple(words[2:])
    own = word_files(rest, scene, action.place)
    given = environment(action.environment, action.replaces_environment, scene, action.place)
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


def _installed(path: Value) -> tuple[Value, Value] | None:
    """The package and the name of an executable whose path leads below the prefix of its package, as `ros2 run` finds it."""
    first, *rest = parts_of(path)
    if not isinstance(first, Hole) or len(rest) != 1 or not isinstance(rest[0], str) or len(first.reasons) != 1:
        return None
    reason = first.reasons[0]
    folder, _, name = rest[0].rpartition("/")
    if reason.cause is not Cause.PREFIX or folder != f"/lib/{reason.subject}" or not name:
        return None
    return Const(reason.subject), Const(name)


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
