# SPDX-License-Identifier: Apache-2.0
"""Which keys may stand in rosward.toml, and which values has each?

    params = ["config/robot.yaml"]   ->  a list of paths, relative to the folder of the file
    output = "../elsewhere"          ->  refused: a folder below that of the file

The keys are the long options of the commands, and a few that the command line cannot say. What must not come with the sources is in `NEVER`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeAlias

from rosward.cli.shared import MODES
from rosward.records import NamedTuple
from rosward.ros.distro import DISTROS
from rosward.rules import RULES
from rosward.source.exclude import Exclusion, PatternError, pattern_of
from rosward.source.surroundings import SurroundingsError, checked_variable
from rosward.suppression.ignore_in import IgnoreIn

if TYPE_CHECKING:
    from rosward.influence.policy import Policy

__all__ = ["KEYS", "NEVER", "Key", "Value", "WrongValueError"]

Value: TypeAlias = "str | bool | list[str] | list[tuple[str, str]] | list[Exclusion] | list[IgnoreIn] | Policy"
Reader: TypeAlias = "Callable[[object, Path], Value]"


class WrongValueError(Exception):
    """A value of the wrong kind; the message says which is right."""


class Key(NamedTuple):
    """How the value of a key is read, what it means for people, and the one command that it is for at the top of the file.

    `file_alone`: the command line has no such option. `added`: what the command line says is added to it, instead of replacing it.
    """

    read: Reader
    kind: str
    command: str = ""
    file_alone: bool = False
    added: bool = False


def _text(value: object, _folder: Path) -> str:
    if not isinstance(value, str):
        raise WrongValueError("a string")
    return value


def _flag(value: object, _folder: Path) -> bool:
    if not isinstance(value, bool):
        raise WrongValueError("true or false")
    return value


def _number(value: object, _folder: Path) -> str:
    """As the command line has it: its option says which numbers are right."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise WrongValueError("a number")
    return str(value)


def _texts(value: object, _folder: Path) -> list[str]:
    if not isinstance(value, list) or not all(isinstance(v, str) for v in value):
        raise WrongValueError("a list of strings")
    return [str(v) for v in value]


def _one_of(*choices: str) -> Reader:
    def read(value: object, _folder: Path) -> str:
        if not isinstance(value, str) or value not in choices:
            raise WrongValueError(f"one of {', '.join(choices)}")
        return value

    return read


def _enclaves(value: object, folder: Path) -> str:
    text = _text(value, folder)
    if text not in MODES and not text.endswith(".toml"):
        raise WrongValueError(f"one of {', '.join(MODES)}, or a file that ends in .toml")
    return text if text in MODES else _path(text, folder)


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
    """A place to write to: below the folder of the file, also where a symbolic link leads."""
    path = Path(_path(value, folder))
    try:
        inside = path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError, ValueError):
        inside = False
    if not inside:
        raise WrongValueError("below the folder of the file (use -o for any other folder)")
    return str(path)


def _codes(value: object, folder: Path) -> list[str]:
    codes = _texts(value, folder)
    wrong = [code for code in codes if code not in RULES]
    if wrong:
        raise WrongValueError(f"a list of codes, and these are unknown: {', '.join(wrong)}")
    return codes


def _formats(value: object, folder: Path) -> str:
    return value if isinstance(value, str) else ",".join(_texts(value, folder))


def _exclusions(value: object, folder: Path) -> list[Exclusion]:
    return [Exclusion(str(folder), _pattern(text)) for text in _texts(value, folder)]


def _ignore_in(value: object, folder: Path) -> list[IgnoreIn]:
    if not isinstance(value, dict):
        raise WrongValueError('a table, as in "legacy/**" = ["RW102"]')
    return [
        IgnoreIn(Exclusion(str(folder), _pattern(str(glob))), frozenset(_codes(codes, folder)))
        for glob, codes in value.items()
    ]


def _flow(value: object, _folder: Path) -> Policy:
    from rosward.influence.policy import PolicyError, read_policy

    try:
        return read_policy(value)
    except PolicyError as error:
        raise WrongValueError(str(error)) from error


def _variables(value: object, _folder: Path) -> list[tuple[str, str]]:
    if not isinstance(value, dict) or not all(isinstance(v, str) for v in value.values()):
        raise WrongValueError('a table of strings, as in ROBOT = "r1"')
    try:
        return [checked_variable(str(name), text) for name, text in value.items()]
    except SurroundingsError as error:
        raise WrongValueError(f"a table of variables: {error}") from error


def _pattern(text: str) -> str:
    try:
        return pattern_of(text)
    except PatternError as error:
        raise WrongValueError(f"made of valid patterns: {error}") from error


KEYS: Final[Mapping[str, Key]] = {
    "distro": Key(_one_of(*DISTROS), "a distribution, as `--distro` lists them"),
    "models": Key(_paths, "list of folders"),
    "underlay": Key(_paths, "list of folders"),
    "ament-prefix-path": Key(_flag, "true, false"),
    "env": Key(_variables, "table: name = text", added=True),
    "tests": Key(_flag, "true, false"),
    "exclude": Key(_exclusions, "list of patterns"),
    "no-assumed": Key(_flag, "true, false"),
    "budget": Key(_number, "number"),
    "launch": Key(_launches, 'list of `"FILE"` or `"PKG:FILE"`, with arguments'),
    "all-launch": Key(_flag, "true, false"),
    "arg": Key(_texts, 'list of `"NAME:=VALUE"`'),
    "node": Key(_texts, 'list of `"PKG/EXE:NAME"`'),
    "params": Key(_paths, "list of files"),
    "enclaves": Key(_enclaves, "`node`, `process`, `launch`, or a file that ends in `.toml`"),
    "unknown": Key(_one_of("deny", "wildcard"), "`deny` or `wildcard`"),
    "baseline": Key(_path, "file"),
    "ignore": Key(_codes, "list of codes", file_alone=True),
    "ignore-in": Key(_ignore_in, "table: pattern = list of codes", file_alone=True),
    "accepted": Key(_codes, "list of codes", file_alone=True),
    "flow": Key(_flow, "tables `[[flow.rule]]` and `[[flow.release]]`", file_alone=True),
    "format": Key(_formats, "text, or a list", command="extract"),
    "output": Key(_below, "folder or file below that of the file", command="extract"),
    "system": Key(_flag, "true, false", command="extract"),
    "types": Key(_flag, "true, false", command="extract"),
    "flows": Key(_flag, "true, false", command="extract"),
    "loose-ends": Key(_flag, "true, false", command="extract"),
    "compact": Key(_flag, "true, false", command="extract"),
    "quiet": Key(_flag, "true, false", command="extract"),
    "verbose": Key(_flag, "true, false", command="extract"),
    "fail-on": Key(_text, "as the command has it", command="extract"),
    "allow": Key(_texts, "list of names", command="audit"),
    "accept": Key(_path, "file", command="audit"),
    "max": Key(_number, "number", command="enclaves"),
    "price": Key(_number, "number", command="enclaves"),
    "ignore-given": Key(_flag, "true, false", command="enclaves"),
    "influence": Key(_flag, "true, false", command="enclaves"),
    "git": Key(_text, "`REV..REV` or `REV`", command="diff"),
}
"""The keys, in the order of the documentation."""

NEVER: Final[Mapping[str, str]] = {
    "help": "it is none",
    "no-config": "it refers to the file itself",
    "write-baseline": "every run would write it",
    "write": "every run would write it",
    "json": "it is `format`",
    "stdio": "the editor decides how it speaks",
    "worker": "it is for the server, which starts its workers",
    "follow-links": "the file is part of the sources, and only the person running rosward decides where links may lead",
    "env-from-shell": "the file is part of the sources, and only the person running rosward decides what they learn about the shell",
    "jobs": "it is a matter of the machine",
    "no-cache": "the file is part of the sources, and only the person running rosward decides where results are kept",
    **dict.fromkeys(("to", "from", "check", "suggest-private", "data-only", "made-of"), "it is what one run asks"),
    **dict.fromkeys(
        ("snapshot", "node-info", "network", "seconds", "domain-id", "enclave"), "it refers to what runs at the moment"
    ),
}
"""The long options that are no keys, and why."""
