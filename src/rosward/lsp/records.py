# SPDX-License-Identifier: Apache-2.0
"""What an editor is told of an analysis: plain records, which a worker sends and the server keeps.

    View("bringup/launch/robot.launch.py", "launch", nodes=(Seen("/talker", …, ends=(End("publisher", "/chatter", …),)),), findings=(Told(…),))

A view is one launched system, or all executables as `ros2 run` starts them (its kind is then `sources`). Files are relative to the folder of the
workspace. `written` and `read` turn records into JSON and back; what has not the form of the record is refused.
"""

from __future__ import annotations

import json
import typing
from typing import Any, Final, NamedTuple, TypeVar

from rosward.location import Place

__all__ = ["LAUNCH", "SOURCES", "End", "Given", "MalformedError", "Seen", "Setting", "Started", "Told", "View", "read", "written"]  # fmt: skip

LAUNCH: Final = "launch"
SOURCES: Final = "sources"


class End(NamedTuple):
    """One endpoint of a node. `kind` is a value of `EntityKind`; `whole`: all of its name is known."""

    kind: str
    name: str
    type: str | None
    places: tuple[Place, ...]
    qos: tuple[tuple[str, str], ...] = ()
    callback: str | None = None
    whole: bool = True
    conditional: bool = False
    reasons: tuple[str, ...] = ()
    via: str | None = None


class Setting(NamedTuple):
    """A parameter that a node declares, and its values as text."""

    name: str
    type: str | None
    default: str
    value: str
    place: Place | None


class Seen(NamedTuple):
    """A node, with what the user's code gives it; what the client library adds is left out."""

    name: str
    fqn: str
    package: str | None
    executable: str | None
    process: str
    place: Place
    launched_by: Place | None
    ends: tuple[End, ...]
    settings: tuple[Setting, ...]
    conditional: bool = False
    assumed: bool = False


class Given(NamedTuple):
    """A parameter, or a parameter file, that a launch file gives; see `network.launch_tree.GivenParameter`. `file` is that file, if it is found."""

    kind: str
    name: str
    value: str
    place: Place | None
    file: str = ""


class Started(NamedTuple):
    """What a launch file starts: the file of its program ('' where there is none among the sources), and its remappings."""

    label: str
    program: str
    place: Place
    remaps: tuple[tuple[str, str], ...]
    given: tuple[Given, ...]


class Told(NamedTuple):
    """A finding as an editor shows it."""

    code: str
    severity: str
    message: str
    help: str
    place: Place
    path: tuple[Place, ...] = ()


class View(NamedTuple):
    """What was found of one system. `texts` says of which state of the open files: their numbers, as the server gave them."""

    name: str
    kind: str
    nodes: tuple[Seen, ...]
    started: tuple[Started, ...]
    findings: tuple[Told, ...]
    files: tuple[str, ...]
    versions: tuple[tuple[str, int], ...] = ()


class MalformedError(ValueError):
    """What a worker sent is no record."""


_T = TypeVar("_T")


def written(record: tuple[Any, ...]) -> str:
    """A record as JSON, in one line."""
    return json.dumps(record, ensure_ascii=True, separators=(",", ":"))


def read(kind: type[_T], document: object) -> _T:
    """The record that a document of JSON is. Raises MalformedError."""
    found: _T = _read(kind, document)
    return found


def _read(kind: Any, value: object) -> Any:
    if kind in (str, int, bool):
        if value.__class__ is not kind:
            raise MalformedError(f"{kind.__name__} expected")
        return value
    arguments = typing.get_args(kind)
    if type(None) in arguments:
        return None if value is None else _read(arguments[0], value)
    if not isinstance(value, list):
        raise MalformedError("list expected")
    if arguments and arguments[-1] is Ellipsis:
        return tuple(_read(arguments[0], each) for each in value)
    parts = arguments or tuple(_FIELDS[kind])
    if len(parts) != len(value):
        raise MalformedError(f"{len(parts)} parts expected")
    made = (_read(part, each) for part, each in zip(parts, value, strict=True))
    return tuple(made) if arguments else kind(*made)


_PLACE: Final = (str, int, int)
_FIELDS: Final[dict[Any, tuple[Any, ...]]] = {
    Place: _PLACE,
    **{each: tuple(typing.get_type_hints(each).values()) for each in (End, Setting, Seen, Given, Started, Told, View)},
}
