# SPDX-License-Identifier: Apache-2.0
"""Where precision is given up, nothing is lost in silence, and nothing becomes more certain: each case is analysed once more without any."""

from __future__ import annotations

from fnmatch import fnmatchcase
from pathlib import Path

import pytest
from casefile import WORDS, Case, read_cases, told, write_files
from sampling import sample

import rosward
from rosward.engine.budget import Budget

CASES = [
    case
    for file in sorted((Path(__file__).parent / "cases").glob("*.md"))
    for case in read_cases(file)
    if not case.known
]
COARSE = Budget(coarse=0.0, entry_coarse=0, large=-1)


class Line:
    """A node or an entity as an expectation tells it."""

    def __init__(self, text: str) -> None:
        self.text = text
        kind, name, *rest = text.split()
        self.kind, self.name = kind, name
        self.type = rest.pop(0) if kind != "node" else ""
        self.words = set(rest)

    def covers(self, other: Line) -> bool:
        """Whether it allows what another line says."""
        return (
            self.kind == other.kind
            and (self.name == other.name or fnmatchcase(other.name, self.name))
            and self.type in {other.type, "?"}
        )


def lines(text: list[str]) -> list[Line]:
    """The nodes and entities of an expectation."""
    return [Line(t) for t in text if t.split()[0] in {"node", *WORDS.values()}]


@pytest.mark.parametrize("case", sample(CASES, 32), ids=lambda case: case.name)
def test_covers_the_precise_result(case: Case, tmp_path: Path) -> None:
    """Whatever is expected of a program is covered, or told to be missing."""
    write_files(case, tmp_path)
    result = rosward.extract(tmp_path, distro=case.options.get("distro", "jazzy"), budget=COARSE)
    found = lines(told(result, system="show system" in case.expected))
    expected = lines(case.expected)
    lost = [e.text for e in expected if not any(f.covers(e) for f in found)]
    assert not lost or not result.complete
    sure = {e.text for e in expected if not e.words}  # the same may be sure of another node
    doubtful = [e.text for e in expected if e.words]
    surer = [f.text for f in found if not f.words and f.text not in sure and any(f.text in text for text in doubtful)]
    assert not surer
