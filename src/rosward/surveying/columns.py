# SPDX-License-Identifier: Apache-2.0
"""Which tables does a survey write, with which columns, and what do they mean?

    TABLES["entities"].columns[3]    Column("kind", Kind.TEXT, "publisher, subscription, …")

The writer, the check of parts, the schema page and the tests all read it from here.
"""

from __future__ import annotations

import enum
from typing import Final

from rosward.records import NamedTuple

__all__ = ["COSTS", "REPOSITORY", "TABLES", "Cell", "Column", "Kind", "Row", "Table", "row_is_valid"]

Cell = str | int | bool | float | list[str] | None
Row = list[Cell]


class Kind(enum.Enum):
    """What a cell holds; the value is the type of Parquet."""

    TEXT = "string"
    NUMBER = "int64"
    FLAG = "bool"
    DECIMAL = "double"
    TEXTS = "list<string>"


class Column(NamedTuple):
    """A column; `optional`: a cell may be null."""

    name: str
    kind: Kind
    what: str
    optional: bool = False


class Table(NamedTuple):
    """A table, without its first column, which is `REPOSITORY` in each of them."""

    what: str
    columns: tuple[Column, ...]


REPOSITORY: Final = Column("repository", Kind.TEXT, "the name of the repository; it joins all tables")

_PLACE: Final = (
    Column("file", Kind.TEXT, "file in the repository; empty if it is about no single file"),
    Column("line", Kind.NUMBER, "counted from 1; 0 for a file as a whole"),
)
_RESOLUTION: Final = Column(
    "resolution", Kind.TEXT, "how the name was found: exact, default, bound, pattern or unknown; `*` is an unknown part"
)
_REASONS: Final = Column("reasons", Kind.TEXTS, "why the name or the type is not fully known")

_REPOSITORIES: Final = Table(
    "One row for each repository, whatever became of it.",
    (
        Column("path", Kind.TEXT, "the folder that was analysed"),
        Column("state", Kind.TEXT, "ok, empty (no Python, C++ or launch file), failed or timeout"),
        Column("reason", Kind.TEXT, "why it is not ok", optional=True),
        Column("fault", Kind.FLAG, "whether rosward itself failed, wholly or on a part (RW299)"),
        Column("complete", Kind.FLAG, "whether nothing is missing: ok, and no finding is an error"),
        Column("started", Kind.TEXT, "what was started: executables, or launch files", optional=True),
        Column("files", Kind.NUMBER, "files that were read"),
        Column("lines", Kind.NUMBER, "lines in them"),
        Column("processes", Kind.NUMBER, "processes that were analysed"),
        Column("launch_files", Kind.NUMBER, "launch files in the sources"),
        Column("version", Kind.TEXT, "of rosward"),
        Column("options", Kind.TEXT, "the options of the analysis, as JSON"),
    ),
)
_NODES: Final = Table(
    "One row for each node.",
    (
        Column("node", Kind.NUMBER, "number of the node in its repository, from 0"),
        Column("name", Kind.TEXT, "fully qualified"),
        _RESOLUTION,
        Column("namespace", Kind.TEXT, "its namespace"),
        Column("package", Kind.TEXT, "its package", optional=True),
        Column("executable", Kind.TEXT, "its executable", optional=True),
        Column("process", Kind.TEXT, "the process that it runs in"),
        Column("enclave", Kind.TEXT, "its enclave"),
        Column("interface", Kind.TEXT, "what is known of its entities: analysed, declared, partial or unknown"),
        Column("conditional", Kind.FLAG, "whether some execution does not have it"),
        Column("assumed", Kind.FLAG, "whether it stands for a class that nothing instantiates"),
        *_PLACE,
        Column("launch_file", Kind.TEXT, "the launch file that starts it", optional=True),
        _REASONS,
    ),
)
_ENTITIES: Final = Table(
    "One row for each publisher, subscription, service and action, server and client.",
    (
        Column("node", Kind.NUMBER, "number of its node"),
        Column("node_name", Kind.TEXT, "name of its node"),
        Column(
            "kind",
            Kind.TEXT,
            "publisher, subscription, service server, service client, action server or action client",
        ),
        Column("name", Kind.TEXT, "fully qualified, after remapping"),
        _RESOLUTION,
        Column("type", Kind.TEXT, "interface type", optional=True),
        Column("system", Kind.FLAG, "whether the client library creates it in every node"),
        Column("conditional", Kind.FLAG, "whether some execution does not have it"),
        Column("via", Kind.TEXT, "the library function that creates it on behalf of the program", optional=True),
        Column("reliability", Kind.TEXT, "QoS: reliable, best_effort, …; null if unknown", optional=True),
        Column("durability", Kind.TEXT, "QoS: volatile, transient_local, …; null if unknown", optional=True),
        Column("history", Kind.TEXT, "QoS: keep_last, keep_all, …; null if unknown", optional=True),
        Column("depth", Kind.NUMBER, "QoS: depth of the history; null if unknown", optional=True),
        Column("callback", Kind.TEXT, "the function that is called", optional=True),
        *_PLACE,
        _REASONS,
    ),
)
_FINDINGS: Final = Table(
    "One row for each finding; [findings](findings.md) explains the codes.",
    (
        Column("code", Kind.TEXT, "the code of the rule, such as RW101"),
        Column("severity", Kind.TEXT, "error, warning or note"),
        Column("message", Kind.TEXT, "what is the matter"),
        *_PLACE,
        Column("nodes", Kind.TEXTS, "names of the nodes that it is about, if known"),
        Column("causes", Kind.TEXTS, "findings with a common cause have one reason"),
    ),
)
_SYSTEMS: Final = Table(
    "One row for each node, component, container or process that a launch file starts (`--all-launch`).",
    (
        Column("system", Kind.TEXT, "the launch file"),
        Column("kind", Kind.TEXT, "node, component, container, process, …"),
        Column("package", Kind.TEXT, "its package, `*` for unknown parts", optional=True),
        Column("executable", Kind.TEXT, "its executable", optional=True),
        Column("plugin", Kind.TEXT, "the class of a component", optional=True),
        Column("container", Kind.TEXT, "the container of a component", optional=True),
        Column("name", Kind.TEXT, "the name that it is given", optional=True),
        Column("namespace", Kind.TEXT, "the namespace that it is given", optional=True),
        Column("remaps", Kind.TEXTS, "remapping rules, as `from:=to`"),
        Column("program", Kind.TEXT, "what is behind it: its source, a declaration, or why that is unknown"),
        Column("conditional", Kind.FLAG, "whether some execution does not start it"),
        Column("event", Kind.TEXT, "what has to happen first; empty if nothing"),
        *_PLACE,
    ),
)
COSTS: Final = Table(
    "What each repository cost. These numbers differ from run to run, so they are in a table of their own.",
    (
        Column("cpu_seconds", Kind.DECIMAL, "processor time of the process, user and system"),
        Column("peak_bytes", Kind.NUMBER, "its largest resident memory; null if unknown", optional=True),
    ),
)
TABLES: Final = {
    "repositories": _REPOSITORIES,
    "nodes": _NODES,
    "entities": _ENTITIES,
    "findings": _FINDINGS,
    "systems": _SYSTEMS,
}
"""The result tables: the same bits for the same sources and options, however the survey ran."""

_TYPES: Final = {Kind.TEXT: str, Kind.NUMBER: int, Kind.FLAG: bool, Kind.DECIMAL: float, Kind.TEXTS: list}


def row_is_valid(row: object, columns: tuple[Column, ...]) -> bool:
    """Whether a row has a cell of the right kind for each column."""
    if not isinstance(row, list) or len(row) != len(columns):
        return False
    return all(_cell_is_valid(cell, column) for cell, column in zip(row, columns, strict=True))


def _cell_is_valid(cell: object, column: Column) -> bool:
    if cell is None:
        return column.optional
    if type(cell) is not _TYPES[column.kind]:
        return False
    if column.kind is Kind.TEXTS:
        assert isinstance(cell, list)
        return all(type(each) is str for each in cell)
    return column.kind is not Kind.NUMBER or -(2**63) <= cell < 2**63  # type: ignore[operator]  # a number by its kind
