# SPDX-License-Identifier: Apache-2.0
"""What flows through programs in C++: each of `cpp_programs` says in its first lines what is in each of its outputs, by reading it.

// flow: topic:/out: data topic:/in; trigger timer      what is published there holds /in, and is published when a timer fires

A name stands once, in the strongest way in which it counts.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from rosward.domain.certain import text_of
from rosward.engine.budget import Budget
from rosward.flow import process
from rosward.pipeline import extract

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter
    from rosward.engine.watch import Watch
    from rosward.flow.flows import ProcessFlows
    from rosward.flow.marks import Source
    from rosward.flow.sinks import Sink

PROGRAMS = sorted((Path(__file__).parent / "cpp_programs").glob("*.cpp"))
WORD = "// flow: "


def named(thing: Source | Sink) -> str:
    """A kind, and the name that is used here: all are relative to the root."""
    name = text_of(thing.given) if thing.given is not None else getattr(thing, "name", "")
    if name and thing.kind in {"topic", "service", "request", "response"} and not name.startswith("/"):
        name = f"/{name}"
    return f"{thing.kind}:{name}" if name else thing.kind


def line(sink: str, ways: dict[str, list[str]]) -> str:
    """One output."""
    return f"{sink}: " + "; ".join(f"{way} {' '.join(sorted(names))}" for way, names in sorted(ways.items()) if names)


def expected(path: Path) -> Counter[str]:
    """What the program says of itself."""
    found = Counter[str]()
    for text in path.read_text().splitlines():
        if text.startswith(WORD):
            sink, _, rest = text.removeprefix(WORD).partition(": ")
            ways = {words[0]: words[1:] for each in rest.split("; ") if (words := each.split())}
            found[line(sink, ways)] += 1
    return found


def flows(path: Path, monkeypatch: pytest.MonkeyPatch) -> list[ProcessFlows]:
    """What is found."""
    found: list[ProcessFlows] = []
    follow = process.flows_of

    def kept(machine: Interpreter, watch: Watch) -> ProcessFlows:
        found.append(follow(machine, watch))
        return found[-1]

    monkeypatch.setattr(process, "flows_of", kept)
    extract(str(path), budget=Budget()._replace(flow=True, net=False))
    return found


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda p: p.stem)
def test_what_flows(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = flows(path, monkeypatch)
    lines = Counter(
        line(
            named(flow.sink),
            {
                "data": list(map(named, flow.data)),
                "control": list(map(named, flow.control)),
                "trigger": list(map(named, flow.trigger)),
            },
        )
        for each in found
        for flow in each.flows
    )
    assert lines == expected(path)
    assert all(each.complete for each in found)


def test_there_are_programs() -> None:
    assert len(PROGRAMS) >= 30
    assert all(expected(path) for path in PROGRAMS)
