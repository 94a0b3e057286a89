# SPDX-License-Identifier: Apache-2.0
"""Is rosward compiled here (hatch_build.py)? Then a few tests do not run that look into its classes, or replace its functions."""

from __future__ import annotations

import pytest

from rosward.domain import values

COMPILED = not (values.__file__ or "").endswith(".py")
interpreted = pytest.mark.skipif(
    COMPILED, reason="compiled classes have no __slots__, and compiled calls cannot be replaced"
)
