# SPDX-License-Identifier: Apache-2.0
"""The list of Python's own modules has all that the Python that runs the tests has, on any of the versions that rosward supports."""

from __future__ import annotations

import re
import sys

import pytest

from rosward.source.standard_library import BUILT_IN, STANDARD_LIBRARY

_FOR_TESTS = re.compile(r"__p?hello|_test|_ctypes_test|_xxtest|xx")
"""Modules with which Python tests itself."""


@pytest.mark.skipif(sys.version_info >= (3, 15), reason="the list ends with Python 3.14")
def test_the_modules_of_this_python_are_in_the_list() -> None:
    assert {n for n in sys.stdlib_module_names if not _FOR_TESTS.match(n)} <= STANDARD_LIBRARY


def test_what_this_python_has_built_in_is_in_the_list() -> None:
    assert {n for n in sys.builtin_module_names if not _FOR_TESTS.match(n)} <= BUILT_IN <= STANDARD_LIBRARY


def test_modules_that_came_and_went() -> None:
    assert {"imp", "distutils", "asyncore", "binhex", "tomllib", "annotationlib", "compression"} <= STANDARD_LIBRARY
    assert not {"numpy", "rclpy", "attr", "xx"} & STANDARD_LIBRARY
