# SPDX-License-Identifier: Apache-2.0
"""A server without a socket, and a browser that says what a real one would.

Without the extra `serve`, only `test_extra.py` is there, and it is skipped; `ROSWARD_TESTS_REQUIRE="serve"` turns that into a failure.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from .page import Page

NEEDED = ("starlette", "uvicorn", "python_multipart", "watchfiles")
CLIENTS = ("httpx2", "httpx")
MISSING = [name for name in NEEDED if find_spec(name) is None]
MISSING += [] if any(map(find_spec, CLIENTS)) else CLIENTS[:1]

if MISSING:
    collect_ignore_glob = ["test_[!e]*.py", "test_examples.py"]


@pytest.fixture
def page(tmp_path: Path) -> Iterator[Page]:
    """The page of a server whose analyses are not real, in a folder of its own."""
    from .page import opened

    with opened(tmp_path / "results") as found:
        yield found


@pytest.fixture
def real_page(tmp_path: Path) -> Iterator[Page]:
    """The page of a server that analyses."""
    from .page import opened

    with opened(tmp_path / "results", real=True) as found:
        yield found
