# SPDX-License-Identifier: Apache-2.0
"""A real browser: the chromium of the machine, or the one that `CHROMIUM` names.

Without it, or without playwright, the tests are skipped; `ROSWARD_TESTS_REQUIRE="browser"` turns that into a failure.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from importlib.util import find_spec
from typing import TYPE_CHECKING, Final, NoReturn

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser

_OPTIONS: Final = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
)  # fmt: skip


def lacking(what: str, why: str) -> NoReturn:
    """Skip, or fail where this has to be there."""
    if what in os.environ.get("ROSWARD_TESTS_REQUIRE", "").split():
        pytest.fail(f"{what} is required here: {why}", pytrace=False)
    pytest.skip(why)


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    """One browser for the tests of this folder; each opens a context of its own.

    It ends with the folder: as long as it is there playwright keeps an event loop running in this thread, and whatever
    else calls `asyncio.run` in the same process fails.
    """
    if find_spec("playwright") is None:
        lacking("browser", "no playwright")
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        lacking("browser", "no chromium")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=program, args=list(_OPTIONS))
        yield opened
        opened.close()
