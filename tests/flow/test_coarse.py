# SPDX-License-Identifier: Apache-2.0
"""Promise: the coarser walk, which follows where the other one takes too long, claims whatever that one claims, at least as strongly."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from rosward.flow import process

from .reported import reported

PROGRAMS: Final = sorted((Path(__file__).parent / "programs").glob("*.py"))


def _claims(program: Path) -> dict[tuple[str, int, str], int]:
    found: dict[tuple[str, int, str], int] = {}
    for row in reported(program):
        for rank, sources in enumerate((row.data, row.control, row.trigger)):
            for source in sources:
                key = (row.sink, row.line, source)
                found[key] = min(rank, found.get(key, rank))
    return found


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda p: p.name)
def test_the_coarse_walk_covers_the_fine_one(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fine = _claims(program)
    monkeypatch.setattr(process, "_LEAST", 0)
    monkeypatch.setattr(process, "_STEPS_EACH", 0)
    coarse = _claims(program)
    assert {key: rank for key, rank in fine.items() if coarse.get(key, 9) > rank} == {}
