# SPDX-License-Identifier: Apache-2.0
"""Checks small programs, each alone, against what must be found in it.

    python bench/patterns.py DIR [--supply] [--only TEXT]

DIR holds programs in Python or C++, or packages, and `expected.json`: for each program lines such as `pub /chatter` (`sub`, `ss`, `sc`,
`as`, `ac`, `node`), or `nosys rosout`, `nosys params` for what the client library must not be said to create; `may pub /x` is allowed and
not required. What is not listed must not be reported.
Exit status 1 where a program is wrong.
"""

from __future__ import annotations

import argparse
import fnmatch
import json
import re
import shutil
import sys
import tempfile
import traceback
from collections.abc import Iterator
from pathlib import Path

import rosward
from rosward.findings import Finding
from rosward.network.graph import Network
from rosward.ros.entities import Entity, EntityKind

_WORDS = {
    "pub": EntityKind.PUBLISHER,
    "sub": EntityKind.SUBSCRIPTION,
    "ss": EntityKind.SERVICE_SERVER,
    "sc": EntityKind.SERVICE_CLIENT,
    "as": EntityKind.ACTION_SERVER,
    "ac": EntityKind.ACTION_CLIENT,
}

_SUPPLIED = {
    "constants": "TOPIC = 'chatter'\n",
    "nodes": (
        "from rclpy.node import Node\n\n\n"
        "class MyNode(Node):\n    def __init__(self):\n        super().__init__('n1')\n"
    ),
}
"""The modules of `my_pkg` that programs import and that are not among them."""

# Programs of which the rules say more than a list of entities can
_FURTHER_CLIENTS = {"76_use_sim_time_remote_params": "/other/", "57_parameter_client_and_events": "/other/"}
_FINDINGS = {"52_method_never_called": "RW205", "43_method_never_called": "RW205"}


def main() -> int:
    """Analyse each program and print right or wrong."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--supply", action="store_true", help="put the modules of my_pkg beside their importers")
    parser.add_argument("--only", default="", help="only programs whose name contains this text")
    options = parser.parse_args()
    expected: dict[str, list[str]] = json.loads((options.folder / "expected.json").read_text(encoding="utf-8"))
    right = 0
    programs = [name for name in sorted(expected) if options.only in name]
    for name in programs:
        with tempfile.TemporaryDirectory() as folder:
            copied = _copy(options.folder, name, Path(folder))
            supplied = _supply(copied) if options.supply else []
            wrong = list(_check(name, copied.parent if supplied else copied, expected[name]))
        right += not wrong
        note = f" (with {', '.join(supplied)} supplied)" if supplied else ""
        print(f"{'WRONG' if wrong else 'right'} {name}{note}")
        for line in wrong:
            print(f"      {line}")
    print(f"{right} of {len(programs)} right")
    return 0 if right == len(programs) else 1


def _copy(folder: Path, name: str, into: Path) -> Path:
    """The program or package in a folder of its own."""
    program = next(p for p in (folder / f"{name}.py", folder / f"{name}.cpp", folder / name) if p.exists())
    if program.is_dir():
        return Path(shutil.copytree(program, into / name))
    return Path(shutil.copy(program, into))


def _supply(program: Path) -> list[str]:
    """Write the modules of my_pkg that the program imports beside it; their names."""
    text = program.read_text(encoding="utf-8") if program.suffix == ".py" else ""
    wanted = re.findall(r"\bmy_pkg\.(\w+)", text)
    if wanted:
        package = program.with_name("my_pkg")
        package.mkdir()
        (package / "__init__.py").touch()
        for module in wanted:
            (package / f"{module}.py").write_text(_SUPPLIED[module], encoding="utf-8")
    return [f"my_pkg/{module}.py" for module in wanted]


def _check(name: str, path: Path, expected: list[str]) -> Iterator[str]:
    """What is wrong with the result for one program, line by line."""
    try:
        result = rosward.extract(path)
    except Exception:  # a crash is a result of this bench, too
        yield traceback.format_exc()
        return
    further = {tuple(line.split()[1:]) for line in expected if line.startswith("may ")}
    lines = [line.split() for line in expected if not line.startswith("may ")]
    nodes = {target for word, target in lines if word == "node"}
    found = {node.fqn for node in result.network.nodes}
    if nodes and found != nodes:
        yield f"nodes {sorted(found)}, expected {sorted(nodes)}"
    for word, kind in _WORDS.items():
        required = {t for w, t in lines if w == word}
        allowed = [t for w, t in further if w == word]
        yield from _compare(name, word, _entities(result.network, kind), required, allowed)
    for what in (target for word, target in lines if word == "nosys"):
        yield from _present(result.network, what)
    yield from _findings(name, result.findings)


def _entities(network: Network, kind: EntityKind) -> list[Entity]:
    return [entity for node in network.nodes for entity in node.of_kind(kind)]


def _compare(name: str, word: str, entities: list[Entity], expected: set[str], may: list[str]) -> Iterator[str]:
    further = _FURTHER_CLIENTS.get(name) if word == "sc" else None
    for missing in sorted(expected - {entity.name for entity in entities}):
        yield f"missing {word} {missing}"
    for entity in entities:
        allowed = entity.system or entity.name in expected or (further and entity.name.startswith(further))
        allowed = allowed or any(fnmatch.fnmatchcase(entity.name, each) for each in may)
        if not allowed:
            places = ", ".join(map(str, entity.created_at))
            yield f"not expected: {word} {entity.name} ({entity.resolution.value}, {places})"


def _present(network: Network, what: str) -> Iterator[str]:
    kind, name = (
        (EntityKind.PUBLISHER, "/rosout") if what == "rosout" else (EntityKind.SERVICE_SERVER, "/set_parameters")
    )
    for entity in _entities(network, kind):
        if entity.name.endswith(name):
            yield f"not expected: {entity.name} by the client library"


def _findings(name: str, findings: tuple[Finding, ...]) -> Iterator[str]:
    code = _FINDINGS.get(name)
    if code and not any(finding.code == code for finding in findings):
        yield f"missing finding {code}"
    for finding in findings:
        if finding.code in ("RW201", "RW206"):
            yield f"{finding.place}: {finding.code} {finding.message}"


if __name__ == "__main__":
    sys.exit(main())
