# SPDX-License-Identifier: Apache-2.0
"""Promise: a random program has the same graph in Python and in C++, and it is the graph that the compiled program has.

`RANDOM_CPP=300` tries so many programs of each kind instead of one (.ci/run does); `RANDOM_CPP_SINCE=1000` begins with that seed.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

import pytest
from live.agreement import Claim, claims_of, judge
from live.harness import Seen

import rosward
from rosward import Result

from .compiled import Ran, needs_compiler, run_many
from .random_programs import Written, write

COUNT: Final = int(os.environ.get("RANDOM_CPP", "1"))
SINCE: Final = int(os.environ.get("RANDOM_CPP_SINCE", "1"))
UNIT: Final = 25
"""So many programs of each kind are compiled as one, which takes a third of the time, and are one test."""
SAME: Final = 0.85
"""The least share of entities that are said in both languages. Which of them are conditional may differ: now one, now the other sees more."""

pytestmark = needs_compiler


class Compared(NamedTuple):
    """One program: what it is, what runs, what is said of it in both languages."""

    about: str
    written: Written
    ran: Ran
    cpp: Result
    python: Result


def _compared(folder: Path, seeds: range) -> Iterator[Compared]:
    """Programs in which all that decides stands, and as many in which something is open."""
    programs = {f"write({seed}, known={known})": write(seed, known=known) for known in (True, False) for seed in seeds}
    runs = run_many((p.cpp for p in programs.values()), folder)
    for number, ((about, written), ran) in enumerate(zip(programs.items(), runs, strict=True)):
        results = []
        for name, text in (("main.cpp", written.cpp), ("main.py", written.python)):
            place = folder / str(number) / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")
            results.append(rosward.extract(place.parent))
            place.unlink()
        yield Compared(about, written, ran, *results)


def _own(result: Result) -> set[Claim]:
    """What a program creates by itself."""
    system = {(node.fqn, entity.name) for node in result.network.nodes for entity in node.entities if entity.system}
    return {claim for claim in claims_of(result) if (claim.node, claim.name) not in system}


def _apart(one: set[Claim], other: set[Claim]) -> list[str]:
    """What one says for sure, and the other not at all."""
    return [str(claim) for claim in one if claim.certain and not any(_fits(claim, each) for each in other)]


def _fits(claim: Claim, other: Claim) -> bool:
    """Whether both say the same; one may know the name where the other has a pattern of it."""
    return _covers(other, claim) or _covers(claim, other)


def _covers(claim: Claim, other: Claim) -> bool:
    return claim.covers((other.node, other.kind, other.name, other.type or ""))


@pytest.mark.parametrize("start", range(SINCE, SINCE + COUNT, UNIT))
def test_random_programs(tmp_path: Path, start: int) -> None:
    same = total = 0
    for compared in _compared(tmp_path, range(start, min(start + UNIT, SINCE + COUNT))):
        about, ran = compared.about, compared.ran
        seen = Seen(
            ran.nodes, frozenset({*ran.facts, *ran.system}), "normal" if ran.status == 0 else "failed", (), ran.output
        )
        verdict = judge(compared.cpp, [seen])
        assert verdict.uncovered == (), f"{about}: created, and not said in C++"
        assert verdict.missing == (), f"{about}: said for sure in C++, and not created"
        cpp, python = _own(compared.cpp), _own(compared.python)
        assert _apart(python, cpp) == [], f"{about}: sure in Python, not said in C++"
        assert _apart(cpp, python) == [], f"{about}: sure in C++, not said in Python"
        names = [{claim[:4] for claim in claims} for claims in (cpp, python)]
        same += len(names[0] & names[1])
        total += len(names[0] | names[1])
    assert same >= SAME * total or COUNT < UNIT  # a few programs are no share
