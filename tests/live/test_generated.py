# SPDX-License-Identifier: Apache-2.0
"""Promise: random programs, made of what real code does, have the graph that rosward says they have.

Two hundred programs here, the same each time (`LIVE_PROGRAMS=5000` for more); any number by `python -m tests.live.generate --count N`.
What stands in `constructs/` is left out here: about one in twelve programs that may hold it still shows a difference (docs/trust.md).
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any, Final

import pytest

pytest.importorskip("rclpy")

from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from .draft import Drawn
from .generate import compare, complaint
from .generator import write
from .harness import RealRclpy

COUNT: Final = int(os.environ.get("LIVE_PROGRAMS", "200"))
GENERATED: Final = settings(
    max_examples=COUNT // 2,
    derandomize=True,
    database=None,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.generate, Phase.shrink],
)
EXACT: Final = 0.9
"""The least share of exact names among the entities of programs that leave nothing open."""


@pytest.fixture(scope="module")
def real() -> Iterator[RealRclpy]:
    with RealRclpy() as server:
        yield server


def test_programs_that_leave_nothing_open(real: RealRclpy) -> None:
    """The static graph holds all that runs, what is certain runs, and nearly every name is known."""
    exact: list[bool] = []

    @GENERATED
    @given(st.data())
    def holds(data: Any) -> None:
        outcome = compare(real, write(Drawn(data.draw, st), further=False).files)
        assert complaint(outcome.verdict) == "", outcome.seen.output
        exact.extend([False] * len(outcome.verdict.vague))
        exact.extend([True] * (len(outcome.seen.facts) - len(outcome.verdict.vague)))

    holds()
    assert sum(exact) >= EXACT * len(exact)


def test_programs_with_open_conditions(real: RealRclpy) -> None:
    """Where only a run decides, the static graph holds what a run decides for."""

    @GENERATED
    @given(st.data())
    def holds(data: Any) -> None:
        outcome = compare(real, write(Drawn(data.draw, st), known=False, further=False).files)
        assert complaint(outcome.verdict) == "", outcome.seen.output

    holds()
