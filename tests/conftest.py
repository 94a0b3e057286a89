# SPDX-License-Identifier: Apache-2.0
"""Options of the test suite."""

import os

import pytest
from hypothesis import settings

# how long a law takes is the machine's affair; ROSWARD_EXAMPLES=2000 tries one longer
settings.register_profile("rosward", deadline=None, max_examples=int(os.environ.get("ROSWARD_EXAMPLES", "50")))
settings.load_profile("rosward")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-cases", action="store_true", help="rewrite the expectations of tests/cases by what comes out"
    )
    parser.addoption(
        "--update-pages", action="store_true", help="rewrite the runs that README.md and docs show by what is printed"
    )
