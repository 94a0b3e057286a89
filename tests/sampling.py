# SPDX-License-Identifier: Apache-2.0
"""Of many alike, some run always, and all of them with `--slow`, as in .ci/run.

@pytest.mark.parametrize("seed", sample(range(16), 4))      seeds 0, 4, 8 and 12; the others with --slow
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def sample(values: Iterable[object], one_in: int) -> list[object]:
    """The values (plain tuples, of several parameters), of which every `one_in`-th runs always, the first of all among them."""

    def slow(value: Any) -> object:
        if hasattr(value, "marks"):  # one of `pytest.param`
            return pytest.param(*value.values, id=value.id, marks=(*value.marks, pytest.mark.slow))
        return pytest.param(*(value if type(value) is tuple else (value,)), marks=pytest.mark.slow)

    return [value if n % one_in == 0 else slow(value) for n, value in enumerate(values)]
