# SPDX-License-Identifier: Apache-2.0
"""Promise: an input that really changes an output is named for it, as data or control; one that only has to arrive, at least as trigger.

Each program runs under the real rclpy, with its real nodes, many times: in a fixed order of callbacks, each time with other contents of one
input, all else equal. Sixty programs of one kind of flow each, and a hundred random ones, the same each time (`LIVE_FLOWS=500` for
more, `LIVE_FLOWS_FROM=500` for others).
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import pytest

pytest.importorskip("rclpy")

from flow.reported import reported

from .draft import Seeded
from .flow_generator import write
from .flow_harness import Change, Observer, denied

COUNT: Final = int(os.environ.get("LIVE_FLOWS", "100"))
FIRST: Final = int(os.environ.get("LIVE_FLOWS_FROM", "0"))
FOLDER: Final = Path(__file__).parents[1] / "flow"
PROGRAMS: Final = sorted((FOLDER / "programs").glob("*.py"))


@pytest.fixture(scope="module")
def observer() -> Iterator[Observer]:
    with Observer() as started:
        yield started


def _values(program: Path) -> dict[str, list[str]]:
    """`values /mode: auto manual` in the docstring: what is to be delivered in turn."""
    found = re.findall(r"^values (\S+): (.*)$", program.read_text(), re.MULTILINE)
    return {f"topic:{name}" if name.startswith("/") else name: words.split() for name, words in found}


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda p: p.stem)
def test_programs_of_one_kind_of_flow(observer: Observer, program: Path) -> None:
    observer.send(program, _values(program))
    rows = reported(program)
    observed = observer.receive()
    assert observed.void == 0, observed.errors
    assert denied(observed, rows) == ""


def test_what_flows_is_observed(observer: Observer) -> None:
    """The observer has eyes: of the flows that these programs are known to have it sees nearly all."""
    expected: dict[str, Any] = json.loads((FOLDER / "expected.json").read_text())["programs"]
    known, seen = set(), set()
    for program in PROGRAMS:
        observer.send(program, _values(program))
        changes = {(c.source, c.sink) for c in observer.receive().changes if c.how == "content"}
        for sink in expected[program.name]["sinks"]:
            pairs = {(program.name, source, sink["sink"]) for source in (*sink["explicit"], *sink["implicit"])}
            known |= pairs
            seen |= {p for p in pairs if p[1:] in changes}
    assert len(seen) >= 0.95 * len(known), sorted(known - seen)


def test_random_programs(observer: Observer, tmp_path: Path) -> None:
    """All of them are run; what is wrong with any is told, with its seed."""
    wrong, changes, compared, void = [], set[tuple[int, Change]](), 0, 0
    for seed in range(FIRST, FIRST + COUNT):
        program = tmp_path / f"{seed}.py"
        program.write_text(write(Seeded(seed)))
        observer.send(program)
        rows = reported(program)
        observed = observer.receive()
        changes |= {(seed, c) for c in observed.changes}
        compared, void = compared + observed.compared, void + observed.void
        complaint = denied(observed, rows)
        if complaint:
            wrong.append(f"{seed}:\n{complaint}")
    assert not wrong, "\n".join(wrong)
    assert len(changes) > 2 * COUNT
    assert void < 0.02 * compared
