# SPDX-License-Identifier: Apache-2.0
"""What may stand next on the command line? Asked by the shell, through argcomplete, when somebody presses Tab.

    rosward extract --launch deli<Tab>           delivery_bringup:building.launch.xml  delivery_bringup:fleet.launch.py  …
    rosward explain /por<Tab>                    the names in rosward-out/network.json, and codes of findings
    rosward extract --format json,ht<Tab>        json,html

argcomplete knows commands, options and choices from the parser by itself; here stands the rest. The sources are listed, not analysed.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rosward.source.workspace import SourceFile, Workspace

__all__ = ["complete", "offer"]

_NETWORK: Final = Path("rosward-out", "network.json")

Completer = Callable[..., Iterable[str]]


def complete(parser: argparse.ArgumentParser) -> None:
    """Answer the shell and exit, where argcomplete is installed; return where it is not."""
    try:
        from argcomplete import autocomplete
    except ImportError:
        return
    offer(parser)
    autocomplete(parser, exclude=["-h", "--help"])


def offer(parser: argparse.ArgumentParser) -> None:
    """Say of each option of the parser, and of its commands, what can stand behind it."""
    from argcomplete.completers import DirectoriesCompleter, FilesCompleter

    by_dest: dict[str, Completer] = {
        "arg": _nothing,
        "enclaves": _enclaves,
        "launch": _launch_files,
        "node": _executables,
        "executable": _executables,
        "name": _names,
        "params": FilesCompleter(("yaml", "yml")),
        "POLICY_FILE_PATH": FilesCompleter(("xml",)),
    }
    for action in _actions(parser):
        completer: Completer | None = None
        if action.choices is None and action.dest in by_dest:
            completer = by_dest[action.dest]
        elif action.metavar == "DIR":
            completer = DirectoriesCompleter()
        elif action.dest == "format" and action.metavar == "LIST":
            completer = _formats
        if completer is not None:
            action.completer = completer  # type: ignore[attr-defined]  # as argcomplete has it


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    for action in parser._actions:
        yield action
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _actions(command)


def _nothing(**_: object) -> Sequence[str]:
    return ()


def _enclaves(prefix: str, **_: object) -> list[str]:
    """How they are chosen, or the file that assigns them."""
    from argcomplete.completers import FilesCompleter

    from rosward.cli.shared import MODES

    return [*MODES, *FilesCompleter(("toml",))(prefix)]


def _launch_files(parsed_args: argparse.Namespace, **_: object) -> list[str]:
    """`PKG:FILE`, with the folder where a package has two of that name."""
    by_name: dict[tuple[str, str], list[SourceFile]] = {}
    for file in _sources(parsed_args).launch_files:
        if file.package is not None:
            by_name.setdefault((file.package.name, file.path.name), []).append(file)
    return [
        f"{package}:{name if len(files) == 1 else file.path.relative_to(file.package.path).as_posix()}"
        for (package, name), files in sorted(by_name.items())
        for file in files
        if file.package is not None
    ]


def _executables(parsed_args: argparse.Namespace, **_: object) -> list[str]:
    """`PKG/EXE`."""
    return sorted({f"{each.package.name}/{each.name}" for each in _sources(parsed_args).executables})


def _sources(parsed_args: argparse.Namespace) -> Workspace:
    from rosward.source.discover import discover

    paths = [Path(path) for path in getattr(parsed_args, "paths", None) or () if os.path.lexists(path)]
    return discover(paths or [Path()])


def _names(**_: object) -> list[str]:
    """What `explain` can be asked for: what the last result has in it, and codes of findings."""
    from rosward.rules import RULES

    return sorted({*_names_of_the_last_result(), *RULES})


def _names_of_the_last_result() -> Iterator[str]:
    import json

    from rosward.source import limits
    from rosward.source.text import read_bytes

    data = read_bytes(os.fspath(_NETWORK), os.fspath(_NETWORK), limits.COMPLETED_FILE)
    try:
        network = json.loads(data) if isinstance(data, bytes) else {}
    except (ValueError, RecursionError):
        return
    for part, key in (("nodes", "fqn"), ("topics", "name"), ("services", "name"), ("actions", "name")):
        members = network.get(part) if isinstance(network, dict) else None
        for member in members if isinstance(members, list) else ():
            name = member.get(key) if isinstance(member, dict) else None
            if isinstance(name, str):
                yield name


def _formats(prefix: str, **_: object) -> list[str]:
    """The list so far with one more."""
    from rosward.cli.extract import FORMAT_NAMES

    before, comma, _last = prefix.rpartition(",")
    taken = before.split(",")
    return [f"{before}{comma}{each}" for each in FORMAT_NAMES if each not in taken]
