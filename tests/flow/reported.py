# SPDX-License-Identifier: Apache-2.0
"""What the analysis says of one file: a row for each place that sends, in the words of `expected.json`.

reported(Path("relay.py"))    -> [Row("topic:/out", 14, data={"topic:/in"}, control=set(), trigger={"topic:/in"})]
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from rosward.engine.budget import Budget
from rosward.pipeline import extract
from rosward.ros.flows import STRENGTHS, NodeCall


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
    result = extract(program, budget=Budget()._replace(flow=True))
    return [
        Row(str(sink.sink), sink.at.line, *(frozenset(map(str, sink.of(strength))) for strength in STRENGTHS))
        for node in result.network.nodes
        if node.flows is not None
        for sink in node.flows.sinks
    ]


def calls_of(program: Path, sink: str) -> tuple[NodeCall, ...]:
    """What is said of one output for each way to it."""
    result = extract(program, budget=Budget()._replace(flow=True))
    (found,) = (
        s for node in result.network.nodes if node.flows is not None for s in node.flows.sinks if str(s.sink) == sink
    )
    return found.calls


def said_of(rows: Iterable[Row], sink: str, line: int | None = None, others: Iterable[int] = ()) -> Said | None:
    """What all rows of one sink say together (of one line, or of all but these); None where there is none."""
    lines = set(others)
    mine = [r for r in rows if r.sink == sink and (r.line == line if line else r.line not in lines)]
    if not mine:
        return None
    data, control, trigger = (frozenset().union(*(getattr(r, s) for r in mine)) for s in STRENGTHS)
    return Said(data, control - data, trigger - control - data)


def rows_of(folder: Path, program: str) -> list[Row]:
    """All rows of a program, which is written into a folder."""
    file = folder / "robot.py"
    file.write_text(program)
    return reported(file)


def said_by(folder: Path, program: str, sink: str) -> Said:
    """What is said of one sink of a program, which is written into a folder; that the sink is there, is asserted."""
    said = said_of(rows_of(folder, program), sink)
    assert said is not None
    return said
