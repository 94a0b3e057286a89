# SPDX-License-Identifier: Apache-2.0
"""How was each source compiled, where a build has left its `compile_commands.json`?

    {"directory": …, "command": "c++ -DSIDE=\\"left\\" -I/ws/demo/include -o CMakeFiles/left_node.dir/src/side.cpp.o -c /ws/demo/src/side.cpp"}
    ->  side.cpp of left_node: folders of headers (/ws/demo/include), macros SIDE="left"

The commands are read, never run. What they say of macros is what happened; folders of headers are added to those of the CMakeLists.txt,
since a build looks into the installed copies of other packages.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Final

from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.cmake.standards import macros, of_options
from rosward.source.cmake.targets import Definition
from rosward.source.text import read_bytes

_WORD: Final = re.compile(r"""(?:[^\s"'\\]|\\.|"(?:[^"\\]|\\.)*"|'[^']*')+""", re.DOTALL)
_QUOTED: Final = re.compile(r""""((?:[^"\\]|\\.)*)"|'([^']*)'|\\(.)""", re.DOTALL)
_ESCAPE: Final = re.compile(r'\\(["\\$`])')
_TARGET: Final = re.compile(r"CMakeFiles/([^/]+)\.dir/")
_COMMAND_LIMIT: Final = 100_000  # characters


class Compiled(NamedTuple):
    """How one target compiled a source."""

    includes: tuple[str, ...]
    definitions: tuple[Definition, ...]


CompileCommands = Mapping[tuple[str, str], Compiled]
"""By the path of the source, and the name of the target."""


def read_compile_commands(folders: Iterable[str], boundary: Boundary = EVERYWHERE) -> CompileCommands:
    """All that the `compile_commands.json` of these folders say, and those in a folder `build` within."""
    found: dict[tuple[str, str], Compiled] = {}
    for folder in folders:
        for path in (f"{folder}{os.sep}compile_commands.json", f"{folder}{os.sep}build{os.sep}compile_commands.json"):
            if disk.is_file(path) and not boundary.leads_out(path):
                for source, target, compiled in _entries(path):
                    found.setdefault((source, target), compiled)
    return found


def _entries(path: str) -> Iterator[tuple[str, str, Compiled]]:
    data = read_bytes(path, path, limits.COMPILE_COMMANDS_FILE)
    try:
        entries = json.loads(data) if isinstance(data, bytes) else []
    except (ValueError, RecursionError):
        return
    for entry in entries if isinstance(entries, list) else []:
        if not isinstance(entry, dict) or not isinstance(entry.get("file"), str):
            continue
        folder = entry.get("directory")
        folder = os.path.join(os.path.dirname(path), folder if isinstance(folder, str) else "")  # noqa: PTH118, PTH120
        words = list(_words(entry))
        output = entry.get("output")
        target = _TARGET.search(output if isinstance(output, str) else " ".join(words[-12:]))
        source = os.path.normpath(os.path.join(folder, entry["file"]))  # noqa: PTH118
        yield source, target[1] if target else "", _compiled(words, folder)


def _words(entry: dict[str, object]) -> Iterator[str]:
    arguments, command = entry.get("arguments"), entry.get("command")
    if isinstance(arguments, list):
        yield from (a for a in arguments if isinstance(a, str))
    elif isinstance(command, str) and len(command) <= _COMMAND_LIMIT:
        for word in _WORD.findall(command):
            yield _QUOTED.sub(lambda m: _ESCAPE.sub(r"\1", m[1]) if m[1] is not None else m[2] or m[3] or "", word)


def _compiled(words: list[str], folder: str) -> Compiled:
    includes: dict[str, None] = {}
    definitions: dict[str, Definition] = {}
    rest = iter(words)
    for word in rest:
        option = next((o for o in ("-isystem", "-iquote", "-I", "-D", "-U") if word.startswith(o)), "")
        value = (word[len(option) :] or next(rest, "")) if option else ""
        if option in {"-D", "-U"}:
            name, equals, text = value.partition("=")
            definitions.pop(name, None)
            if option == "-D" and name.isidentifier():
                definitions[name] = Definition(name, text if equals else "1")
        elif option:
            includes[os.path.normpath(os.path.join(folder, value))] = None  # noqa: PTH118
    of_version = [Definition(*each) for each in macros(list(of_options(words)))]
    return Compiled(tuple(includes), (*of_version, *definitions.values()))
