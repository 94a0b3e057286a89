# SPDX-License-Identifier: Apache-2.0
"""Options of the test suite."""

import pytest
from hypothesis import settings

settings.register_profile("rosward", deadline=None)  # how long a law takes is the machine's affair
settings.load_profile("rosward")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-cases", action="store_true", help="rewrite the expectations of tests/cases by what comes out"
    )
    parser.addoption(
        "--update-pages", action="store_true", help="rewrite the runs that README.md and docs show by what is printed"
    )
