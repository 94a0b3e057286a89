# SPDX-License-Identifier: Apache-2.0
"""Promise: what each output of a small program is made of is said completely, and nothing is said that is not so.

Sixty programs, one kind of flow each; `expected.json` holds for each sink what was observed when the program ran under the real rclpy:

    explicit    the content is computed into what goes out: the analysis must say data
    implicit    the content only decides what goes out, or whether: control
    either      depends on what one calls data: one of the two
    arrival     only that something arrived counts: at least trigger
    triggers    the events in whose callback the statement runs
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Final

import pytest

from .reported import Said, reported, said_of

HERE: Final = Path(__file__).parent
PROGRAMS: Final[dict[str, Any]] = json.loads((HERE / "expected.json").read_text())["programs"]

Difference = tuple[str, str, str]
"""A sink, what is wrong there, and of which source."""
TOO_MUCH: Final[dict[str, set[Difference]]] = {
    # a message that was sent earlier still leads to the array, which therefore is not known to be a new one
    "43_numpy.py": {(sink, "says too much", "topic:/limit") for sink in ("topic:/copy", "topic:/mean")},
}


def _lacking(claim: dict[str, Any], said: Said | None) -> set[Difference]:
    """What is not said, or too weakly."""
    sink = claim["sink"]
    if said is None:
        return {(sink, "is not known to send", "")}
    strong = said.data | said.control
    anyhow = strong | said.trigger
    found = {(sink, "lacks as data", s) for s in claim["explicit"] if s not in said.data}
    found |= {(sink, "lacks as data or control", s) for s in claim["implicit"] + claim["either"] if s not in strong}
    return found | {(sink, "lacks as trigger", s) for s in claim["arrival"] + claim["triggers"] if s not in anyhow}


def _beyond(claim: dict[str, Any], said: Said | None) -> set[Difference]:
    """What is said without need, or too strongly."""
    sink = claim["sink"]
    if said is None:
        return set()
    known = {*claim["explicit"], *claim["implicit"], *claim["either"], *claim["arrival"]}
    strong = said.data | said.control
    found = {(sink, "says data where it is control", s) for s in said.data & set(claim["implicit"])}
    found |= {(sink, "says more where only the arrival counts", s) for s in strong & set(claim["arrival"])}
    return found | {(sink, "says too much", s) for s in strong - known}


def _differences(program: str, judge: Any) -> set[Difference]:
    rows = reported(HERE / "programs" / program)
    claims = PROGRAMS[program]["sinks"]
    lines = {c["line"] for c in claims if c["line"]}
    return {d for c in claims for d in judge(c, said_of(rows, c["sink"], c["line"], lines))}


def _told(differences: set[Difference]) -> str:
    return "\n".join(f"{sink}: {what} {source}".rstrip() for sink, what, source in sorted(differences))


def test_every_program_has_its_expectation() -> None:
    assert sorted(PROGRAMS) == sorted(p.name for p in (HERE / "programs").glob("*.py"))


@pytest.mark.parametrize("program", PROGRAMS)
def test_nothing_is_missing(program: str) -> None:
    assert _told(_differences(program, _lacking)) == ""


@pytest.mark.parametrize("program", PROGRAMS)
def test_nothing_is_too_much(program: str) -> None:
    """But for what is known to be; where that becomes better, the list above is to become shorter."""
    assert _differences(program, _beyond) == TOO_MUCH.get(program, set())
