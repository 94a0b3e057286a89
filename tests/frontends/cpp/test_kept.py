# SPDX-License-Identifier: Apache-2.0
"""Law: the next free register is the first that is not kept, in whatever order registers are kept and asked for."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rosward.frontends.cpp.lower.kept import Kept

NUMBERS = st.integers(0, 30)


@given(st.lists(st.tuples(st.booleans(), NUMBERS)))
def test_the_first_that_is_not_kept_is_free(steps: list[tuple[bool, int]]) -> None:
    kept, known = Kept(), set[int]()
    for keeps, number in steps:
        if keeps:
            kept.keep(number)
            known.add(number)
        else:
            assert kept.free_from(number) == next(n for n in range(number, 100) if n not in known)
