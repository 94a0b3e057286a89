# SPDX-License-Identifier: Apache-2.0
"""Patterns as DDS has them, held against `fnmatch` of Python, which reads `*`, `?` and brackets alike."""

from __future__ import annotations

import fnmatch
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.policies.match import Pattern

TEXT = st.text(alphabet="ab/", max_size=6)
PATTERN = st.lists(st.sampled_from(["a", "b", "/", "*", "?", "[ab]", "[!a]", "[a-b]"]), max_size=5).map("".join)


@pytest.mark.parametrize(
    ("pattern", "name", "expected"),
    [
        ("rt/robot_*/cmd_vel", "rt/robot_1/cmd_vel", True),
        ("rt/robot_*/cmd_vel", "rt/robot_1/arm/cmd_vel", True),  # * crosses /
        ("rt/robot_*/cmd_vel", "rt/robot_1/cmd_velx", False),
        ("rt/robot_*/cmd_vel", "rt/ROBOT_1/cmd_vel", False),
        ("rt/deep/*", "rt/deep", False),
        ("rt/robot_[0-9]", "rt/robot_7", True),
        ("rt/robot_[!0-9]", "rt/robot_7", False),
        ("rt/{a,b}", "rt/a", False),  # braces are not expanded
        ("rt/a[", "rt/a[", True),  # not closed: itself
        ("rt/a\\*", "rt/a\\b", True),  # no escapes
    ],
)
def test_names_match_as_dds_says(pattern: str, name: str, expected: bool) -> None:
    assert Pattern(pattern).matches(name) is expected


@pytest.mark.parametrize(
    ("wide", "narrow", "expected"),
    [
        ("rt/*", "rt/a/*", True),
        ("rt/a/*", "rt/*", False),
        ("rt/robot_*", "rt/robot_*/cmd", True),
        ("rt/robot_?/cmd", "rt/robot_*/cmd", False),
        ("rt/*/cmd", "rt/*/arm/cmd", True),
        ("rt/[a-z]*", "rt/a*", True),
    ],
)
def test_a_pattern_covers_another(wide: str, narrow: str, expected: bool) -> None:
    assert Pattern(wide).covers(Pattern(narrow)) is expected


@given(PATTERN, TEXT)
def test_matching_is_that_of_fnmatch(pattern: str, name: str) -> None:
    assert Pattern(pattern).matches(name) is fnmatch.fnmatchcase(name, pattern)


@given(PATTERN, PATTERN, TEXT)
def test_covering_and_meeting_say_what_matching_says(one: str, other: str, name: str) -> None:
    first, second = Pattern(one), Pattern(other)
    both = first.matches(name) and second.matches(name)
    assert first.meets(second) or not both
    assert not (first.covers(second) and second.matches(name)) or first.matches(name)
    assert first.meets(second) is second.meets(first)


def test_no_pattern_is_slow() -> None:
    nasty, start = Pattern("rt/" + "*a" * 100), time.process_time()
    assert not nasty.matches("rt/" + "a" * 99 + "b" * 200)
    assert not nasty.covers(Pattern("rt/*" + "?" * 200))
    assert nasty.meets(Pattern("rt/*b" + "?" * 200))
    assert time.process_time() - start < 5
