# SPDX-License-Identifier: Apache-2.0
"""Which rows does the analysis of one repository give?

    rows_of(result)["entities"][0]      [0, "/talker", "publisher", "/chatter", "exact", "std_msgs/msg/String", False, …]

In the order of the network, which is sorted; without the column `repository`, whose name is a matter of the whole survey.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from rosward.location import Place
from rosward.network.launch_tree import LaunchEntry, LaunchSystem, Shown
from rosward.pipeline import Result
from rosward.ros.entities import Entity, Node, Qos
from rosward.safe import encodable
from rosward.surveying.columns import TABLES, Cell, Row

__all__ = ["rows_of"]

_NOWHERE: Final = Place("", 0)
_UNKNOWN: Final = Qos()
_MOST_NUMBER: Final = 2**63 - 1


def rows_of(result: Result) -> Mapping[str, list[Row]]:
    """The rows of each table but that of repositories."""
    nodes = result.network.nodes
    rows: dict[str, Iterable[Row]] = {
        "nodes": [_node(number, node) for number, node in enumerate(nodes)],
        "entities": [_entity(number, node, each) for number, node in enumerate(nodes) for each in node.entities],
        "findings": [
            [f.code, f.rule.severity.value, f.message, f.place.file, f.place.line, list(f.nodes), list(f.causes)]
            for f in result.findings
        ],
        "systems": [_entry(system, entry) for system in result.systems for entry in system.entries],
    }
    assert rows.keys() | {"repositories"} == TABLES.keys()
    return {table: [[_cell(cell) for cell in row] for row in found] for table, found in rows.items()}


def _cell(cell: Cell) -> Cell:
    """What a file of tables can hold: no half characters, no larger number."""
    if isinstance(cell, str):
        return encodable(cell)
    if isinstance(cell, list):
        return [encodable(each) for each in cell]
    if type(cell) is int:
        return max(-_MOST_NUMBER, min(cell, _MOST_NUMBER))
    return cell


def _node(number: int, node: Node) -> Row:
    return [
        number,
        node.fqn,
        node.resolution.value,
        node.namespace,
        node.package,
        node.executable,
        node.process,
        node.enclave,
        node.interface.value,
        node.conditional,
        node.assumed,
        node.defined_at.file,
        node.defined_at.line,
        node.launched_by.file if node.launched_by else None,
        list(node.reasons),
    ]


def _entity(number: int, node: Node, entity: Entity) -> Row:
    place = next(iter(entity.created_at), _NOWHERE)
    qos = entity.qos or _UNKNOWN
    return [
        number,
        node.fqn,
        entity.kind.value,
        entity.name,
        entity.resolution.value,
        entity.type,
        entity.system,
        entity.conditional,
        entity.via,
        qos.reliability,
        qos.durability,
        qos.history,
        qos.depth,
        entity.callback,
        place.file,
        place.line,
        list(entity.reasons),
    ]


def _entry(system: LaunchSystem, entry: LaunchEntry) -> Row:
    return [
        system.name,
        entry.kind,
        _text(entry.package),
        _text(entry.executable),
        _text(entry.plugin),
        _text(entry.container),
        _text(entry.name),
        _text(entry.namespace),
        [f"{origin.text}:={target.text}" for origin, target in entry.remaps],
        entry.program,
        entry.conditional,
        entry.event,
        entry.place.file,
        entry.place.line,
    ]


def _text(shown: Shown | None) -> str | None:
    return None if shown is None else shown.text
