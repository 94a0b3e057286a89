# SPDX-License-Identifier: Apache-2.0
"""What does the nearest rosward.toml, or pyproject.toml, say?

    read_configuration(Path("ws/src"))  ->  Configuration("/ws/rosward.toml", {"distro": "humble"}, {"check": {"format": "github"}})

Everything that is not understood is refused, with the key that was probably meant.
"""

from __future__ import annotations

import difflib
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Final

from rosward.cli.configuration_keys import KEYS, Value, WrongValueError
from rosward.cli.shared import WrongUseError
from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.text import read_bytes
from rosward.source.toml import read_toml

__all__ = ["ConfigurationFile", "read_configuration"]

_COMMANDS: Final = "command"
_NOTHING: Final[Mapping[str, Value]] = {}


class ConfigurationFile(NamedTuple):
    """What a file says: for all commands, and for some; `path` is None where there is no file."""

    path: str | None = None
    common: Mapping[str, Value] = _NOTHING
    commands: Mapping[str, Mapping[str, Value]] = {}


def read_configuration(start: Path, commands: Collection[str]) -> ConfigurationFile:
    """The nearest file at or above a path. `commands` are those that there are. Raises WrongUseError."""
    folder = start.absolute()
    for above in (folder, *folder.parents):
        for name in ("rosward.toml", "pyproject.toml"):
            path = above / name
            table = _table(path) if disk.is_file(path) else None
            if table is not None:
                return _configuration(table, path, commands)
    return ConfigurationFile()


def _table(path: Path) -> dict[str, object] | None:
    """The settings in a file; None where it is a pyproject.toml that has none."""
    whole = path.name == "rosward.toml"
    data = read_bytes(path, str(path), limits.CONFIGURATION_FILE)
    if not isinstance(data, Finding) and not whole and b"rosward" not in data:
        return None
    if isinstance(data, Finding):
        if not whole:
            return None
        raise WrongUseError(f"{path}: {data.message}")
    try:
        document = read_toml(data.decode("utf-8"))
    except ValueError as error:
        raise WrongUseError(f"{path}: not valid TOML: {error} (--no-config ignores the file)") from error
    if whole:
        return dict(document)
    tool = document.get("tool")
    table = tool.get("rosward") if isinstance(tool, dict) else None
    if table is not None and not isinstance(table, dict):
        raise WrongUseError(f"{path}: tool.rosward must be a table")
    return table


def _configuration(table: dict[str, object], path: Path, known: Collection[str]) -> ConfigurationFile:
    commands: dict[str, dict[str, Value]] = {}
    tables = table.pop(_COMMANDS, {})
    if not isinstance(tables, dict):
        raise WrongUseError(f"{path}: {_COMMANDS} must be a table, as in [command.check]")
    for command, own in tables.items():
        if command not in known:
            raise WrongUseError(f"{path}: there is no command {command!r}{_meant(command, known)}")
        if not isinstance(own, dict):
            raise WrongUseError(f"{path}: {_COMMANDS}.{command} must be a table")
        commands[command] = _values(own, path)
    return ConfigurationFile(str(path), _values(table, path), commands)


def _values(table: Mapping[str, object], path: Path) -> dict[str, Value]:
    values: dict[str, Value] = {}
    for key, value in table.items():
        if key not in KEYS:
            raise WrongUseError(f"{path}: there is no option {key!r}{_meant(key, (*KEYS, _COMMANDS))}")
        try:
            values[key] = KEYS[key].read(value, path.parent)
        except WrongValueError as error:
            raise WrongUseError(f"{path}: {key} must be {error}") from error
    return values


def _meant(word: str, known: Collection[str]) -> str:
    """What was probably meant, else all that there is."""
    close = difflib.get_close_matches(word.replace("_", "-"), known, n=1, cutoff=0.5)
    return f"; did you mean {close[0]!r}?" if close else f"; choose from {', '.join(known)}"
