# SPDX-License-Identifier: Apache-2.0
"""What may stand next on the command line? Asked by the shell, through argcomplete, when somebody presses Tab.

    rosward extract --launch deli<Tab>           delivery_bringup:building.launch.xml  delivery_bringup:fleet.launch.py  …
    rosward explain /por<Tab>                    the names in rosward-out/network.json, and codes of findings
    rosward flow --to /cmd<Tab>                  the same names, those in rosward-out/flow.json, and kinds such as network
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
_FLOWS: Final = Path("rosward-out", "flow.json")
_SERVICES: Final = ("service", "request", "response")
_ACTIONS: Final = ("action", "goal", "cancel", "feedback", "result")
_PLAIN: Final = ("topic", *_SERVICES, *_ACTIONS)
"""Kinds whose names stand for themselves."""
_MEANT: Final = {**dict.fromkeys(_SERVICES, _SERVICES), **dict.fromkeys(_ACTIONS, _ACTIONS)}

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
        "origin": _ends,
        "params": FilesCompleter(("yaml", "yml")),
        "to": _ends,
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

    return sorted({*(name for kind, name in _last_result() if kind != "parameter"), *RULES})


def _ends(prefix: str, **_: object) -> list[str]:
    """What `flow` can be asked for: names, kinds that have none, and behind `KIND:` what is of that kind."""
    from rosward.influence.select import KINDS, OUTSIDE

    found = [*_last_result(), *_last_flows()]
    kind, colon, _name = prefix.partition(":")
    if not colon:
        names = {name for each, name in found if each in _PLAIN}
        return sorted(names | set(OUTSIDE)) + [f"{each}:" for each in KINDS if each not in OUTSIDE]
    return sorted({f"{kind}:{name}" for each, name in found if each in _MEANT.get(kind, (kind,)) and name})


def _last_result() -> Iterator[tuple[str, str]]:
    """Kind and name of what stands in network.json."""
    network = _document(_NETWORK)
    for part, key in (("nodes", "fqn"), ("topics", "name"), ("services", "name"), ("actions", "name")):
        yield from ((part[:-1], name) for name in _texts(network, part, key))
    for node in _objects(network, "nodes"):
        yield from (("parameter", name) for name in _texts(node, "parameters", "name"))


def _last_flows() -> Iterator[tuple[str, str]]:
    """The same of flow.json, as it has kinds: each output, and what it is made of."""
    for node in _objects(_document(_FLOWS), "nodes"):
        for sink in _objects(node, "sinks"):
            lists = [sink.get(strength) for strength in ("data", "control", "trigger")]
            for end in (sink.get("sink"), *(end for each in lists if isinstance(each, list) for end in each)):
                kind, _, name = end.partition(":") if isinstance(end, str) else ("", "", "")
                yield kind, name


def _document(path: Path) -> object:
    import json

    from rosward.source import limits
    from rosward.source.text import read_bytes

    data = read_bytes(os.fspath(path), os.fspath(path), limits.COMPLETED_FILE)
    try:
        return json.loads(data) if isinstance(data, bytes) else {}
    except (ValueError, RecursionError):
        return {}


def _objects(document: object, key: str) -> Iterator[dict[str, object]]:
    """The objects of a list of a document, which anybody may have written."""
    members = document.get(key) if isinstance(document, dict) else None
    yield from (member for member in (members if isinstance(members, list) else ()) if isinstance(member, dict))


def _texts(document: object, part: str, key: str) -> Iterator[str]:
    for member in _objects(document, part):
        name = member.get(key)
        if isinstance(name, str):
            yield name


def _formats(prefix: str, **_: object) -> list[str]:
    """The list so far with one more."""
    from rosward.cli.extract import FORMAT_NAMES

    before, comma, _last = prefix.rpartition(",")
    taken = before.split(",")
    return [f"{before}{comma}{each}" for each in FORMAT_NAMES if each not in taken]
