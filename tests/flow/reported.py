# SPDX-License-Identifier: Apache-2.0
"""What the analysis says of one file: a row for each place that sends, in the words of `expected.json`.

reported(Path("relay.py"))    -> [Row("topic:/out", 14, data={"topic:/in"}, control=set(), trigger={"topic:/in"})]
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

from rosward.domain.certain import text_of
from rosward.engine.budget import Budget
from rosward.flow import process
from rosward.flow.flows import ProcessFlows
from rosward.pipeline import extract

STRENGTHS = ("data", "control", "trigger")


class Row(NamedTuple):
    """One place that sends, and the sources by strength, each in the strongest only."""

    sink: str
    line: int
    data: frozenset[str]
    control: frozenset[str]
    trigger: frozenset[str]


class Said(NamedTuple):
    """What is said of one sink, or of several places that send the same."""

    data: frozenset[str]
    control: frozenset[str]
    trigger: frozenset[str]


def reported(program: Path) -> list[Row]:
    """All rows of a program."""
    found: list[ProcessFlows] = []
    compute = process.flows_of

    def noted(*arguments: Any) -> ProcessFlows:
        found.append(compute(*arguments))
        return found[-1]

    with patch.object(process, "flows_of", noted):
        extract(program, budget=Budget()._replace(flow=True))
    return [
        Row(_name(f.sink), f.sink.place.line, *(frozenset(map(_name, s)) for s in (f.data, f.control, f.trigger)))
        for flows in found
        for f in flows.flows
    ]


def _name(end: Any) -> str:
    """`topic:/in`, `parameter:gain`, `clock`."""
    given = getattr(end, "given", None)
    name = getattr(end, "name", "") if given is None else text_of(given) or "?"
    if name and end.kind != "parameter" and not name.startswith("/"):
        name = f"/{name}"
    return f"{end.kind}:{name}" if name else str(end.kind)


def said_of(rows: Iterable[Row], sink: str, line: int | None = None, others: Iterable[int] = ()) -> Said | None:
    """What all rows of one sink say together (of one line, or of all but these); None where there is none."""
    lines = set(others)
    mine = [r for r in rows if r.sink == sink and (r.line == line if line else r.line not in lines)]
    if not mine:
        return None
    data, control, trigger = (frozenset().union(*(getattr(r, s) for r in mine)) for s in STRENGTHS)
    return Said(data, control - data, trigger - control - data)
