# SPDX-License-Identifier: Apache-2.0
"""What a user asks to be started.

--launch bringup:robot.launch.py,sim:=true     LaunchRequest('robot.launch.py', 'bringup', (('sim', 'true'),))
--node demo/talker:left                        NodeRequest('demo', 'talker', 'left')
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from rosward.records import NamedTuple

_ARGUMENT: Final = re.compile(r"\w[\w.-]*:=")
"""How an argument begins: names have dots (`rgb_camera.profile`), and no slash, which those of remap rules have."""


class RequestError(ValueError):
    """A request that cannot be read; the message says why."""


class UnknownRequestError(Exception):
    """What is asked for is not there; the message says what."""


class LaunchRequest(NamedTuple):
    """A launch file, by path (`package` None) or by package and name, and arguments for it alone."""

    file: str
    package: str | None = None
    arguments: tuple[tuple[str, str], ...] = ()

    def __str__(self) -> str:
        return f"{self.package}:{self.file}" if self.package else self.file


class NodeRequest(NamedTuple):
    """An executable, started once more than the launch files say, under another name where one is given."""

    package: str
    executable: str
    name: str | None = None


class Request(NamedTuple):
    """All that is to be started. Empty: every executable, as `ros2 run` would start it."""

    launches: tuple[LaunchRequest, ...] = ()
    nodes: tuple[NodeRequest, ...] = ()
    params: tuple[str, ...] = ()
    arguments: tuple[tuple[str, str], ...] = ()
    all_launch: bool = False

    @property
    def deploys(self) -> bool:
        """Whether something particular is to be started."""
        return bool(self.launches or self.nodes or self.all_launch)


def parse_assignment(text: str) -> tuple[str, str]:
    """`name:=value`. Raises `RequestError`."""
    name, mark, value = text.partition(":=")
    if not mark or not name:
        raise RequestError(f"{text!r} is not of the form NAME:=VALUE")
    return name, value


def parse_launch(text: str) -> LaunchRequest:
    """`FILE`, `PKG:FILE`, each with `,name:=value` behind it any number of times. Raises `RequestError`."""
    target, *rest = _split(text)
    package, mark, file = target.partition(":")
    if not mark:
        package, file = "", target
    if not file or "/" in package:
        raise RequestError(f"{text!r} is not of the form FILE or PKG:FILE")
    return LaunchRequest(file, package or None, tuple(parse_assignment(each) for each in rest))


def _split(text: str) -> list[str]:
    """At commas that a `name:=` follows: a value may hold commas itself."""
    parts: list[str] = []
    for part in text.split(","):
        if parts and not _ARGUMENT.match(part):
            parts[-1] += f",{part}"
        else:
            parts.append(part)
    return parts


def parse_node(text: str) -> NodeRequest:
    """`PKG/EXE` or `PKG/EXE:name`. Raises `RequestError`."""
    target, mark, name = text.partition(":")
    package, slash, executable = target.partition("/")
    if not slash or not package or not executable or (mark and not name):
        raise RequestError(f"{text!r} is not of the form PKG/EXE or PKG/EXE:NAME")
    return NodeRequest(package, executable, name or None)


def assignments(texts: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Several `name:=value`, each name once, the last one wins."""
    return tuple(dict(parse_assignment(text) for text in texts).items())


Wanted = str | os.PathLike[str]
"""A launch file: `PKG:FILE` or a path, with arguments of its own behind it; what is no str is a path and nothing else."""


def launching(wanted: Wanted | Sequence[Wanted], arguments: Mapping[str, str]) -> Request:
    """The request of somebody who names launch files, and arguments for all of them. Raises `RequestError`."""
    several = [wanted] if isinstance(wanted, (str, os.PathLike)) else wanted
    launches = tuple(parse_launch(w) if isinstance(w, str) else LaunchRequest(os.fspath(w)) for w in several)
    if arguments and not launches:
        raise RequestError("launch arguments need a launch file, and none was given")
    for name, value in arguments.items():
        if not isinstance(value, str):
            raise RequestError(f"the launch argument {name!r} must be a string, not {value!r}")
    return Request(launches, arguments=tuple(arguments.items()))
