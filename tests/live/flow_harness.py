# SPDX-License-Identifier: Apache-2.0
"""Which inputs of a program really change which outputs? `Observer` runs it many times under the real rclpy.

    with Observer() as observer:
        observer.send(Path("relay.py"))
        observer.receive().changes    -> {Change("topic:/in", "topic:/out", 0, "content"), …}

Between `send` and `receive` there is time to analyse the same program.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import TracebackType
from typing import NamedTuple

from flow.reported import Row, said_of


class Change(NamedTuple):
    """An input that changes an output: by its `content`, or by its `arrival`. `line` is 0 where the output has a name."""

    source: str
    sink: str
    line: int
    how: str


class Observed(NamedTuple):
    """What was seen of a program in so many comparisons, of which some were void because of exceptions that nobody caught."""

    changes: frozenset[Change]
    sent: frozenset[tuple[str, int]]
    compared: int
    void: int
    errors: tuple[str, ...]


class Observer:
    """A process that runs programs one after another."""

    def __init__(self) -> None:
        tests = Path(__file__).parents[1]
        self._process = subprocess.Popen(
            [sys.executable, "-m", "live.flow_server"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": str(tests), "PYTHONDONTWRITEBYTECODE": "1"},
        )

    def __enter__(self) -> Observer:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.close()
        self._process.wait(timeout=60)
        self._process.stdout.close()

    def send(self, program: Path, values: Mapping[str, list[str]] | None = None) -> None:
        """Start with a program; `values` are contents that are to be delivered in turn."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps({"file": str(program), "values": dict(values or {})}) + "\n")
        self._process.stdin.flush()

    def receive(self) -> Observed:
        """What was observed of the program that was sent first and not yet received."""
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"the observer has ended ({self._process.wait()})")
        found = json.loads(line)
        return Observed(
            frozenset(Change(*c) for c in found["changes"]),
            frozenset((sink, at) for sink, at in found["sent"]),
            found["runs"],
            found["void"],
            tuple(found["errors"]),
        )


def denied(observed: Observed, rows: Iterable[Row]) -> str:
    """What really happens and is not said, a line each: outputs that are not known, and inputs that change one."""
    rows = list(rows)
    lines = {r.line for r in rows}
    told = []
    for sink, line in sorted(observed.sent):
        if said_of(rows, sink, line or None) is None:
            told.append(f"{sink}{_at(line)} is sent, which is not said (of the lines {sorted(lines)})")
    for change in sorted(observed.changes):
        said = said_of(rows, change.sink, change.line or None)
        if said is None:
            continue
        known = said.data | said.control | (said.trigger if change.how == "arrival" else frozenset())
        anything = change.source.startswith("parameter:") and "parameter:*" in known
        if change.source not in known and not anything:
            told.append(f"the {change.how} of {change.source} changes {change.sink}{_at(change.line)}")
    return "\n".join(told)


def _at(line: int) -> str:
    return f" in line {line}" if line else ""
