# SPDX-License-Identifier: Apache-2.0
"""Which enclave did the user choose for a process?

    [[enclave]]
    path = "/sensors"
    nodes = ["/camera", "/lidar"]           every process that one of them runs in
    processes = ["demo/talker#2"]           where names of nodes do not tell processes apart

It is data: a file that `rosward enclaves suggest --write` writes, that people correct, and that `--enclaves FILE.toml` reads.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import dataclass, field
from rosward.ros.entities import Node
from rosward.ros.names import validate_enclave
from rosward.source import limits
from rosward.source.text import read_bytes
from rosward.source.toml import read_toml

__all__ = ["NOTHING_ASSIGNED", "Assignment", "AssignmentError", "read_assignment"]

_KEYS: Final = frozenset({"path", "nodes", "processes"})


class AssignmentError(Exception):
    """The file is no assignment; the message says why."""


@dataclass(frozen=True, slots=True)
class Assignment:
    """Enclaves by the full name of a node, and by the label of a process, which counts first. `file` is where they stand."""

    nodes: Mapping[str, str] = field(default_factory=dict)
    processes: Mapping[str, str] = field(default_factory=dict)
    file: str = ""

    @property
    def paths(self) -> set[str]:
        """All enclaves."""
        return {*self.nodes.values(), *self.processes.values()}

    def of(self, members: Sequence[Node]) -> tuple[str, ...]:
        """The enclave of the process with these nodes: none where nothing is said, several where what is said conflicts."""
        label = members[0].process
        if label in self.processes:
            return (self.processes[label],)
        return tuple(sorted({self.nodes[n.fqn] for n in members if n.fqn in self.nodes}))

    def unused(self, processes: Mapping[str, Sequence[Node]]) -> list[Finding]:
        """RW341 for each name that nothing has."""
        names = {n.fqn for members in processes.values() for n in members}
        place = Place(self.file, 0)
        return [
            *(Finding("RW341", f"there is no node {name}", place) for name in sorted({*self.nodes} - names)),
            *(
                Finding("RW341", f"there is no process {name}", place)
                for name in sorted({*self.processes} - {*processes})
            ),
        ]


NOTHING_ASSIGNED: Final = Assignment()


def read_assignment(path: Path) -> Assignment:
    """What a file assigns. Raises AssignmentError."""
    data = read_bytes(path, str(path), limits.ASSIGNMENT_FILE)
    if isinstance(data, Finding):
        raise AssignmentError(data.message)
    try:
        document = read_toml(data.decode("utf-8"))
    except ValueError as error:
        raise AssignmentError(f"not valid TOML: {error}") from error
    tables = document.pop("enclave", [])
    if document or not isinstance(tables, list):
        raise AssignmentError(f"only [[enclave]] tables are allowed, not: {', '.join(document) or 'enclave'}")
    nodes: dict[str, str] = {}
    processes: dict[str, str] = {}
    for table in tables:
        path_of = _path(table)
        _enter(table, "nodes", path_of, nodes)
        _enter(table, "processes", path_of, processes)
    return Assignment(nodes, processes, str(path))


def _path(table: object) -> str:
    if not isinstance(table, dict) or not isinstance(table.get("path"), str):
        raise AssignmentError('each [[enclave]] needs a path = "/…"')
    foreign = sorted({*table} - _KEYS)
    if foreign:
        raise AssignmentError(
            f"enclave {table['path']!r} has an unknown key {foreign[0]!r}; expected one of: {', '.join(sorted(_KEYS))}"
        )
    wrong = "* is not allowed in it" if "*" in table["path"] else validate_enclave(table["path"])
    if wrong is not None:
        raise AssignmentError(f"enclave {table['path']!r} is rejected by rcl: {wrong}")
    return str(table["path"])


def _enter(table: Mapping[str, object], key: str, path: str, found: dict[str, str]) -> None:
    names = table.get(key, [])
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise AssignmentError(f"{key} of enclave {path} must be a list of strings")
    for name in names:
        if found.setdefault(name, path) != path:
            raise AssignmentError(f"{name} is assigned to {found[name]} and to {path}")
