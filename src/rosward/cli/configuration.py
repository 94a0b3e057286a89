# SPDX-License-Identifier: Apache-2.0
"""Which options does the analysed workspace set for itself?

    # rosward.toml, or [tool.rosward] in pyproject.toml
    distro = "humble"
    launch = ["bringup:robot.launch.py"]        as if `--distro humble --launch bringup:robot.launch.py` were given
    ignore = ["RW302"]

The nearest file above the first PATH counts. An option of the command line replaces that of the file. The file comes with the sources, so it
is not trusted: it can have outputs written below its own folder only, and `--no-config` leaves it unread.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final, NamedTuple

from rosward.cli.shared import DISTROS, WrongUseError
from rosward.findings import RULES, Finding
from rosward.source.text import read_bytes

__all__ = ["OPTIONS", "apply", "unset"]

_LIMIT: Final = 1_000_000

_Value = str | bool | list[str]
_Reader = Callable[[object, Path], _Value]


class _WrongValueError(Exception):
    """A value of the wrong kind; the message says which is right."""


class _Option(NamedTuple):
    """How the value of a key is read, and what holds where nobody sets it."""

    read: _Reader
    default: object


def _text(value: object, _folder: Path) -> str:
    if not isinstance(value, str):
        raise _WrongValueError("a string")
    return value


def _flag(value: object, _folder: Path) -> bool:
    if not isinstance(value, bool):
        raise _WrongValueError("true or false")
    return value


def _texts(value: object, _folder: Path) -> list[str]:
    if not isinstance(value, list) or not all(isinstance(v, str) for v in value):
        raise _WrongValueError("a list of strings")
    return [str(v) for v in value]


def _one_of(*choices: str) -> _Reader:
    def read(value: object, _folder: Path) -> str:
        if not isinstance(value, str) or value not in choices:
            raise _WrongValueError(f"one of {', '.join(choices)}")
        return value

    return read


def _path(value: object, folder: Path) -> str:
    return os.path.join(folder, _text(value, folder))  # noqa: PTH118


def _paths(value: object, folder: Path) -> list[str]:
    return [_path(v, folder) for v in _texts(value, folder)]


def _launches(value: object, folder: Path) -> list[str]:
    """`PKG:FILE` stays; a path is one below the folder of the file."""
    return [
        text if ":" in text.partition(",")[0] else os.path.join(folder, text)  # noqa: PTH118
        for text in _texts(value, folder)
    ]


def _below(value: object, folder: Path) -> str:
    """A folder to write to: below that of the file, also where a symbolic link leads."""
    path = Path(_path(value, folder))
    try:
        inside = path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError, ValueError):
        inside = False
    if not inside:
        raise _WrongValueError("a folder below that of the file (use -o for any other)")
    return str(path)


def _codes(value: object, folder: Path) -> list[str]:
    codes = _texts(value, folder)
    wrong = [code for code in codes if code not in RULES]
    if wrong:
        raise _WrongValueError(f"a list of codes, and there is no {', '.join(wrong)}")
    return codes


def _formats(value: object, folder: Path) -> str:
    return value if isinstance(value, str) else ",".join(_texts(value, folder))


OPTIONS: Final[Mapping[str, _Option]] = {
    "distro": _Option(_one_of(*DISTROS), "jazzy"),
    "unknown": _Option(_one_of("deny", "wildcard"), "deny"),
    "enclaves": _Option(_one_of("node", "process", "launch"), None),
    "models": _Option(_paths, ()),
    "underlay": _Option(_paths, ()),
    "ament-prefix-path": _Option(_flag, False),
    "tests": _Option(_flag, False),
    "launch": _Option(_launches, ()),
    "all-launch": _Option(_flag, False),
    "arg": _Option(_texts, ()),
    "node": _Option(_texts, ()),
    "params": _Option(_paths, ()),
    "format": _Option(_formats, None),
    "output": _Option(_below, "rosward-out"),
    "system": _Option(_flag, False),
    "types": _Option(_flag, False),
    "baseline": _Option(_path, None),
    "ignore": _Option(_codes, ()),
    "accepted": _Option(_codes, ()),
}
"""The keys, which are the long options of `extract`, and `ignore` and `accepted`, which are in the file alone."""


def unset() -> dict[str, None]:
    """The defaults of the parser, so that what the command line does not say can be told from what it says."""
    return {key.replace("-", "_"): None for key in OPTIONS}


def apply(options: argparse.Namespace) -> None:
    """Give each option that the command line left open its value: of the file, else the default. Raises WrongUseError."""
    given, source = ({}, None) if options.no_config else _of_file(Path(next(iter(options.paths), ".")))
    options.configuration = source
    for key, option in OPTIONS.items():
        name = key.replace("-", "_")
        if getattr(options, name) is None:
            default = list(option.default) if isinstance(option.default, tuple) else option.default
            setattr(options, name, given.get(key, default))


def _of_file(start: Path) -> tuple[dict[str, _Value], str | None]:
    """What the nearest file above a path says, and its path."""
    folder = start.absolute()
    for above in (folder, *folder.parents):
        for name in ("rosward.toml", "pyproject.toml"):
            path = above / name
            table = _table(path) if os.path.isfile(path) else None  # noqa: PTH113
            if table is not None:
                return _values(table, path), str(path)
    return {}, None


def _table(path: Path) -> dict[str, object] | None:
    """The settings in a file; None where it is a pyproject.toml that has none."""
    whole = path.name == "rosward.toml"
    data = read_bytes(path, str(path), _LIMIT)
    if not isinstance(data, Finding) and not whole and b"rosward" not in data:
        return None
    if isinstance(data, Finding):
        if not whole:
            return None
        raise WrongUseError(f"{path}: {data.message}")
    tomllib = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document = tomllib.loads(data.decode("utf-8"))
    except (ValueError, RecursionError) as error:
        raise WrongUseError(f"{path}: this is no TOML: {error} (--no-config leaves it unread)") from error
    if whole:
        return dict(document)
    tool = document.get("tool")
    table = tool.get("rosward") if isinstance(tool, dict) else None
    if table is not None and not isinstance(table, dict):
        raise WrongUseError(f"{path}: tool.rosward must be a table")
    return table


def _values(table: Mapping[str, object], path: Path) -> dict[str, _Value]:
    values: dict[str, _Value] = {}
    for key, value in table.items():
        if key not in OPTIONS:
            raise WrongUseError(f"{path}: there is no option {key!r}; choose out of {', '.join(OPTIONS)}")
        try:
            values[key] = OPTIONS[key].read(value, path.parent)
        except _WrongValueError as error:
            raise WrongUseError(f"{path}: {key} must be {error}") from error
    return values
