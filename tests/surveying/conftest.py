# SPDX-License-Identifier: Apache-2.0
"""Repositories to survey, and what a survey of them gave.

Without the extras `survey` and `dask`, and DuckDB, only `test_extra.py` is there, and it is skipped; `ROSWARD_TESTS_REQUIRE="survey"` turns that into
a failure.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from .checkouts import Surveyed

MISSING = [name for name in ("pyarrow", "distributed", "duckdb") if find_spec(name) is None]

if MISSING:
    collect_ignore_glob = ["test_[!e]*.py", "test_executing.py"]


@pytest.fixture(scope="session")
def surveyed(tmp_path_factory: pytest.TempPathFactory) -> Surveyed:
    """A folder of a few repositories, and the survey of it by processes of this machine."""
    from .checkouts import Surveyed

    return Surveyed.of(tmp_path_factory.mktemp("surveyed"))
