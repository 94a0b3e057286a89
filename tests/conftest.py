# SPDX-License-Identifier: Apache-2.0
"""Options of the test suite."""

import os
import shutil
import tempfile
from collections.abc import Iterator

import pytest
import remembered as remembering
from hypothesis import settings
from laws import EXAMPLES

# how long a law takes is the machine's affair
settings.register_profile("rosward", deadline=None, max_examples=EXAMPLES)
settings.load_profile("rosward")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run what takes long and seldom finds anything")
    parser.addoption(
        "--update-cases", action="store_true", help="rewrite the expectations of tests/cases by what comes out"
    )
    parser.addoption(
        "--update-pages", action="store_true", help="rewrite the runs that README.md and docs show by what is printed"
    )


def pytest_configure(config: pytest.Config) -> None:
    if (
        "PYTEST_XDIST_WORKER" not in os.environ
    ):  # one folder for all workers, and nothing of the person who runs the tests
        os.environ["ROSWARD_CACHE"] = folder = tempfile.mkdtemp(prefix="rosward-tests-")
        config.add_cleanup(lambda: shutil.rmtree(folder, ignore_errors=True))
    config.addinivalue_line("markers", "slow: runs with --slow only, as in .ci/run")


@pytest.hookimpl(tryfirst=True)
def pytest_cmdline_main(config: pytest.Config) -> None:
    """Several processes take tests that stand beside each other, so that what a module prepares is mostly prepared once."""
    if getattr(config.option, "numprocesses", None) and config.option.dist == "no":
        config.option.dist = "worksteal"


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--slow"):
        slow = [item for item in items if item.get_closest_marker("slow") is not None]
        config.hook.pytest_deselected(items=slow)
        items[:] = [item for item in items if item.get_closest_marker("slow") is None]


@pytest.fixture(scope="module")
def remembered() -> Iterator[None]:
    """Analyses of the examples are done once: see `remembered.py`."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rosward.pipeline.extract", remembering.extract)
        yield


@pytest.fixture(scope="session", autouse=True)
def no_results_of_earlier_tests() -> Iterator[None]:
    """No test finds what another one has found; those of the cache ask for it (`tests/cache`)."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rosward.cli.kept.results_folder", lambda: None)
        yield
