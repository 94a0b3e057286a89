# SPDX-License-Identifier: Apache-2.0
"""What flows through programs in C++: each of `cpp_programs` says in its first lines what is in each of its outputs, by reading it.

// flow: topic:/out: data topic:/in; trigger timer      what is published there holds /in, and is published when a timer fires

A name stands once, in the strongest way in which it counts.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from sampling import sample

from rosward.engine.budget import Budget
from rosward.flow.cpp import outside
from rosward.pipeline import extract
from rosward.ros.flows import STRENGTHS, NodeFlows

PROGRAMS = sorted((Path(__file__).parent / "cpp_programs").glob("*.cpp"))
WORD = "// flow: "


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


def flows(path: Path) -> list[NodeFlows]:
    """What is found."""
    result = extract(str(path), budget=Budget()._replace(flow=True, net=False))
    return [node.flows for node in result.network.nodes if node.flows is not None]


@pytest.mark.parametrize("path", sample(PROGRAMS, 4), ids=lambda p: p.stem)
def test_what_flows(path: Path) -> None:
    found = flows(path)
    lines = Counter(
        line(str(sink.sink), {strength: list(map(str, sink.of(strength))) for strength in STRENGTHS})
        for each in found
        for sink in each.sinks
    )
    assert lines == expected(path)
    assert all(each.complete for each in found)


def told(text: str) -> set[tuple[str, int, str]]:
    """What one output holds, each name in its way and in all that are weaker."""
    sink, _, rest = text.partition(": ")
    several = [each.split() for each in rest.split("; ") if each]
    return {
        (sink, weaker, name)
        for way, *names in several
        for name in names
        for weaker in range(STRENGTHS.index(way), len(STRENGTHS))
    }


@pytest.mark.parametrize("path", sample(PROGRAMS, 4), ids=lambda p: p.stem)
def test_nothing_is_missing_where_all_that_libraries_made_is_one(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outside, "_FEW", 0)
    found = {
        each
        for node in flows(path)
        for sink in node.sinks
        for each in told(line(str(sink.sink), {strength: list(map(str, sink.of(strength))) for strength in STRENGTHS}))
    }
    assert {each for text in expected(path) for each in told(text)} <= found


def test_there_are_programs() -> None:
    assert len(PROGRAMS) >= 30
    assert all(expected(path) for path in PROGRAMS)
