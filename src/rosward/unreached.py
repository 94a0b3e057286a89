# SPDX-License-Identifier: Apache-2.0
"""Entities in code that no process reaches: left out of the result, and told (RW205).

    class N(Node):
        def later(self):                              # nothing calls it
            self.create_publisher(String, 'late', 10)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.findings import Finding
from rosward.ir import ops
from rosward.ir.program import Code
from rosward.processes import Run
from rosward.source.location import Place

_CREATE: Final = frozenset(
    ("create_publisher", "create_subscription", "create_service", "create_client", "create_lifecycle_publisher")
)


def unreached(runs: Iterable[Run]) -> list[Finding]:
    """One note for each call in a function that was made in some process and entered in none."""
    functions: dict[int, Code] = {}
    entered: set[int] = set()
    for run in runs:
        functions.update(run.log.functions)
        entered |= run.entered
    found: dict[Finding, None] = {}
    for key, code in functions.items():
        if key not in entered:
            for name, op in _creations(code.ops):
                place = Place(code.file, op.line, op.column)
                found[Finding("RW205", f"{code.qualname} is called by nothing: its {name} is left out", place)] = None
    return list(found)


def _creations(block: ops.Block) -> Iterator[tuple[str, ops.Op]]:
    """The calls of a method that creates an entity, in nested blocks and functions too."""
    for op in block:
        if isinstance(op, ops.LoadAttr) and op.name in _CREATE:
            yield op.name, op
        elif isinstance(op, ops.MakeFunction):
            yield from _creations(op.code.ops)
        for inner in _blocks(op):
            yield from _creations(inner)


def _blocks(op: ops.Op) -> tuple[ops.Block, ...]:
    if isinstance(op, ops.If):
        return (op.then, op.orelse)
    if isinstance(op, ops.While):
        return (op.condition, op.body, op.orelse)
    if isinstance(op, ops.ForEach):
        return (op.body, op.orelse)
    if isinstance(op, ops.Try):
        return (op.body, *(h.body for h in op.handlers), op.orelse, op.final)
    return (op.body,) if isinstance(op, ops.With) else ()
