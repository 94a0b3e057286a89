# SPDX-License-Identifier: Apache-2.0
"""Every program of `tests/cases` gives exactly the nodes, entities and findings that stand beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from casefile import Case, read_cases, rewrite, run_case

CASES = [case for file in sorted((Path(__file__).parent / "cases").glob("*.md")) for case in read_cases(file)]


def _case(case: Case) -> object:
    marks = [pytest.mark.xfail(reason=case.known, strict=True)] if case.known else []
    return pytest.param(case, id=case.name, marks=marks)


@pytest.mark.parametrize("case", [_case(case) for case in CASES])
def test_case(case: Case, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    """What is written below a program is what comes out of it, no more and no less."""
    found = run_case(case, tmp_path)
    if request.config.getoption("--update-cases") and found != case.expected:
        rewrite(case.file, {case.title: found})
        return
    assert found == case.expected


def test_titles_are_unique() -> None:
    """A title names one case."""
    names = [case.name for case in CASES]
    assert len(names) == len(set(names))
