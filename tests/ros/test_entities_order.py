# SPDX-License-Identifier: Apache-2.0
"""Promise: what is found in several ways is as sure as the surest, what is made of several parts as the least sure."""

from __future__ import annotations

import pytest

from rosward.ros.entities import Resolution, least_sure, surest
from rosward.rules import Severity


def test_of_several_ways_the_surest_counts() -> None:
    assert surest([Resolution.PATTERN, Resolution.DEFAULT, Resolution.BOUND]) is Resolution.DEFAULT
    with pytest.raises(ValueError, match="empty"):
        surest([])


def test_of_several_parts_the_least_sure_counts() -> None:
    assert least_sure(Resolution.BOUND, Resolution.EXACT) is Resolution.BOUND
    assert least_sure(Resolution.UNKNOWN, Resolution.PATTERN) is Resolution.UNKNOWN


def test_a_name_with_a_hole_is_not_whole() -> None:
    assert [r.value for r in Resolution if r.whole] == ["exact", "default", "bound"]


def test_errors_are_the_heaviest() -> None:
    assert sorted(Severity, key=lambda s: s.rank) == [Severity.ERROR, Severity.WARNING, Severity.NOTE]
