# SPDX-License-Identifier: Apache-2.0
"""Reads the small workspaces of `tests/systems/*.md`: files, a command, and what must come out of it.

    ## A node under another name
    Why it is here.
    ```xml demo/launch/main.launch.xml
    <launch><node pkg="demo" exec="talker" name="left"/></launch>
    ```
    ```console
    $ rosward extract --launch demo:main.launch.xml
    ```
    ```expect
    process demo/talker in /left from demo/launch/main.launch.xml:1
      node /left
        pub /chatter std_msgs/msg/String
    ```

The files before the first section belong to every case of the document. The command runs in the folder with the files; that folder is `$PWD` in what
comes out. `rosward extract` is told as the reader of network.json sees it, in the words of `tests/cases`; every other command, and a refusal, by what
it prints. `exit N` stands at the end where the status is not 0. `show system` and `show findings` as first lines ask for the entities of the client
library and for messages.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final, NamedTuple

from casefile import WORDS

from rosward import EntityKind
from rosward.cli import main

KINDS: Final = {
    EntityKind.PUBLISHER: "publishers",
    EntityKind.SUBSCRIPTION: "subscriptions",
    EntityKind.SERVICE_SERVER: "service_servers",
    EntityKind.SERVICE_CLIENT: "service_clients",
    EntityKind.ACTION_SERVER: "action_servers",
    EntityKind.ACTION_CLIENT: "action_clients",
}
"""The lists of a node in network.json."""

OUTPUT: Final = "rosward-out"
_BLOCK: Final = re.compile(r"^```(\w+)[ \t]*([^\n]*)\n(.*?)^```[ \t]*$", re.MULTILINE | re.DOTALL)
_SHOW: Final = ("show system", "show findings")


class SystemCase(NamedTuple):
    """A workspace by file names, the arguments of `rosward`, and the expected lines."""

    file: Path
    title: str
    files: dict[str, str]
    command: tuple[str, ...]
    expected: list[str]

    @property
    def name(self) -> str:
        """An identifier for reports."""
        return f"{self.file.stem}: {self.title}"


class Outcome(NamedTuple):
    """What a command gave: lines as in an expectation, and the network where it wrote one."""

    lines: list[str]
    network: dict[str, Any] | None


def read_systems(file: Path) -> list[SystemCase]:
    """All cases of a document."""
    head, *sections = re.split(r"^## ", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
    common = {name.strip(): text for _, name, text in _BLOCK.findall(head)}
    cases = []
    for section in sections:
        title, _, body = section.partition("\n")
        files, command, expected = dict(common), "", []
        for kind, name, text in _BLOCK.findall(body):
            if kind == "expect":
                expected = text.splitlines()
            elif kind == "console":
                command = text.replace("\\\n", " ")
            else:
                files[name.strip()] = text
        words = shlex.split(command.removeprefix("$ rosward "))
        cases.append(SystemCase(file, title.strip(), files, tuple(words), expected))
    return cases


def run_system(case: SystemCase, folder: Path) -> Outcome:
    """Write the files, run the command in their folder, and tell what came of it. `folder` has to be the working directory."""
    for name, text in case.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    extracts = case.command[:1] == ("extract",)
    extra = ("-q", "--format", "json,policy", "-o", OUTPUT) if extracts else ()
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        status = main([*case.command, *extra])
    written = folder / OUTPUT / "network.json"
    network = json.loads(written.read_text(encoding="utf-8")) if extracts and written.exists() else None
    shown = [line for line in case.expected if line in _SHOW]
    body = printed.getvalue().rstrip("\n").splitlines() if network is None else list(_told(network, shown))
    lines = [line.replace(f"{folder}{os.sep}", "$PWD/") for line in body]
    return Outcome([*shown, *lines, *([f"exit {status}"] if status else [])], network)


def _told(network: dict[str, Any], shown: list[str]) -> Iterator[str]:
    processes: dict[str, list[dict[str, Any]]] = {}
    for node in network["nodes"]:
        processes.setdefault(node["process"], []).append(node)
    for process, members in sorted(processes.items()):
        facts = [(_inside(n), _start(n)) for n in members]
        shared = [len(set(column)) == 1 for column in zip(*facts, strict=True)]
        yield f"process {process}{''.join(fact for fact, common in zip(facts[0], shared, strict=True) if common)}"
        for node, row in zip(members, facts, strict=True):
            own = "".join(fact for fact, common in zip(row, shared, strict=True) if not common)
            yield f"  node {node['fqn']}{_doubt(node)}{own}"
            yield from _entities(node, system="show system" in shown)
    for each in network["diagnostics"]:
        message = f" {each['message']}" if "show findings" in shown else ""
        place = f" {each['file']}{':' + str(each['line']) if each['line'] else ''}" if each["file"] else ""
        yield f"finding {each['code']}{place}{message}"


def _entities(node: dict[str, Any], *, system: bool) -> Iterator[str]:
    seen = set()
    for kind, key in KINDS.items():
        for each in node[key]:
            maybe = " conditional" if each["conditional"] else ""
            line = f"    {WORDS[kind]} {each['name']} {each['type'] or '?'}{_doubt(each)}{maybe}"
            if line not in seen and (system or not each["system"]):
                seen.add(line)
                yield line


def _inside(node: dict[str, Any]) -> str:
    return f" in {node['enclave']}"


def _start(node: dict[str, Any]) -> str:
    place = node["launched_by"]
    return f" from {place['file']}:{place['line']}" if place else ""


def _doubt(named: dict[str, Any]) -> str:
    return "" if named["resolution"] == "exact" else f" {named['resolution']}"
