# SPDX-License-Identifier: Apache-2.0
"""Which options does the analysed workspace set for itself?

    # rosward.toml, or [tool.rosward] in pyproject.toml
    distro = "humble"
    launch = ["bringup:robot.launch.py"]        as if `--distro humble --launch bringup:robot.launch.py` were given
    [command.check]
    format = "github"                           for `rosward check` alone

The nearest file above the first PATH counts, for every command that reads sources. An option of the command line replaces that of the file; that of
`env` adds to it.
The file comes with the sources, so it is not trusted: it can have outputs written below its own folder only, and `--no-config` leaves it unread.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Final

from rosward.cli.configuration_file import ConfigurationFile, read_configuration
from rosward.cli.configuration_keys import KEYS, Value
from rosward.cli.shared import WrongUseError
from rosward.records import NamedTuple
from rosward.source import disk

__all__ = ["apply", "leave_open"]

_STARTING: Final = frozenset({"launch", "all_launch", "node"})
"""If the command line says what is started, the file does not add to it."""


_AS: Final = {"watch": "extract"}
"""Commands for which what is said of another one holds as well."""


class _Open(NamedTuple):
    """An option that the command line may leave to the file, and what holds where nobody sets it."""

    action: argparse.Action | None
    default: object
    added: bool = False


def leave_open(parser: argparse.ArgumentParser) -> None:
    """Let what the command line does not say be told from what it says. For parsers with all their options, and those within."""
    own: dict[str, argparse.Action] = {}
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for inner in action.choices.values():
                leave_open(inner)
        if action.option_strings:
            own.setdefault(action.dest, action)  # --json is another word for one value of --format
    if "no_config" not in own:
        return
    found = {
        dest: _Open(action, action.default, KEYS[_key(dest)].added)
        for dest, action in own.items()
        if _key(dest) in KEYS
    }
    for key, option in KEYS.items():
        if option.file_alone:
            found[_dest(key)] = _Open(None, [])
    parser.set_defaults(left_open=found, **dict.fromkeys(found))


def apply(options: argparse.Namespace) -> None:
    """Give each option that the command line left open its value: of the file, else the default. Raises WrongUseError."""
    left_open: Mapping[str, _Open] = getattr(options, "left_open", {})
    if not left_open:
        return
    read = (
        ConfigurationFile()
        if options.no_config or getattr(options, "worker", "") is None  # the server of editors: its workers read it
        else read_configuration(_start(options), frozenset(options.commands))
    )
    options.configuration = read.path
    given = _given(read, options.command, left_open)
    if any(getattr(options, dest, None) is not None for dest in _STARTING):
        given = {dest: value for dest, value in given.items() if dest not in _STARTING | {"arg"}}
    for dest, option in left_open.items():
        if getattr(options, dest) is None:
            default = list(option.default) if isinstance(option.default, list) else option.default
            setattr(options, dest, given.get(dest, default))
        elif option.added:
            before = given.get(dest)
            setattr(options, dest, [*(before if isinstance(before, list) else ()), *getattr(options, dest)])


def _start(options: argparse.Namespace) -> Path:
    """Where the search begins: the first PATH that is no document to compare."""
    paths = [p for p in options.paths if disk.is_folder(p) or not p.lower().endswith((".xml", ".json"))]
    return Path(next(iter(paths), "."))


def _given(read: ConfigurationFile, command: str, left_open: Mapping[str, _Open]) -> dict[str, object]:
    """What the file says for a command: its own table over the common keys."""
    wide = _AS.get(command, command)
    own = {**(read.commands.get(wide, {}) if wide != command else {}), **read.commands.get(command, {})}
    foreign = [key for key in own if _dest(key) not in left_open]
    if foreign:
        raise WrongUseError(f"{read.path}: {command} has no option {foreign[0]!r}")
    common = {k: v for k, v in read.common.items() if wide in (KEYS[k].command or wide)}
    merged = {_dest(k): v for k, v in {**common, **own}.items() if _dest(k) in left_open}
    return {dest: _taken(read, dest, value, left_open[dest].action) for dest, value in merged.items()}


def _taken(read: ConfigurationFile, dest: str, value: Value, action: argparse.Action | None) -> object:
    """The value as the command line would take it: by the type and the choices of its option."""
    if action is None:
        return value
    try:
        if callable(action.type) and isinstance(value, str):
            taken: object = action.type(value)
            return taken
    except (argparse.ArgumentTypeError, TypeError, ValueError) as error:
        raise WrongUseError(f"{read.path}: {_key(dest)}: {error}") from error
    values = value if isinstance(value, list) else [value]
    if action.choices is not None and any(v not in action.choices for v in values):
        raise WrongUseError(f"{read.path}: {_key(dest)} must be one of {', '.join(map(str, action.choices))}")
    return value


def _dest(key: str) -> str:
    return key.replace("-", "_")


def _key(dest: str) -> str:
    return dest.replace("_", "-")
