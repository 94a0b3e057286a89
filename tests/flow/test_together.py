# SPDX-License-Identifier: Apache-2.0
"""Promise: where calls and objects are no longer told apart, as in large processes, more is said and nothing is lost.

The sixty programs once more: calls of one body as one from the beginning, and every two objects that one value may be are merged.
"""

from __future__ import annotations

import pytest
from sampling import sample

from rosward.engine.watching import watch
from rosward.flow.stored import shape

from .test_programs import PROGRAMS, _differences, _lacking, _told


@pytest.mark.parametrize("few", [1, 1_000_000], ids=["objects and calls", "calls"])
@pytest.mark.parametrize("program", sample(PROGRAMS, 2))
def test_nothing_is_missing(program: str, few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watch, "_LARGE", -1)
    monkeypatch.setattr(shape, "_FEW", ((float("inf"), few),))
    assert _told(_differences(program, _lacking)) == ""
