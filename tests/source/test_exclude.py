# SPDX-License-Identifier: Apache-2.0
"""Which paths a pattern means. What happens to them is in tests/test_cli_configuration.py."""

from __future__ import annotations

import time

import pytest

from rosward.source.exclude import Exclusion, Exclusions, PatternError, pattern_of


def means(pattern: str, path: str, *named: str) -> bool:
    """Whether a pattern of /ws means a path (no folder of which is there)."""
    return Exclusions([Exclusion("/ws", pattern)], named).of(path) is not None


@pytest.mark.parametrize(
    ("pattern", "path", "expected"),
    [
        ("third_party", "/ws/a/third_party/b.py", True),
        ("third_party", "/ws/third_party", True),
        ("third_party", "/ws/my_third_party/b.py", False),
        ("third_party", "/third_party/b.py", False),
        ("*.py", "/ws/a/b.py", True),
        ("a/*.py", "/ws/a/b.py", True),
        ("a/*.py", "/ws/x/a/b.py", False),
        ("a/*.py", "/ws/a/x/b.py", False),
        ("a/**/b.py", "/ws/a/b.py", True),
        ("a/**/b.py", "/ws/a/x/y/b.py", True),
        ("**/a/**", "/ws/x/a/b.py", True),
        ("**/a/**", "/ws/x/b.py", False),
        ("/a", "/ws/a/b.py", True),
        ("/a", "/ws/x/a", False),
        ("a/**", "/ws/x/a/b.py", False),
        ("a/", "/ws/a/b.py", True),
        ("a/", "/ws/x/a", False),  # a folder, and there is none
        ("b?[0-9].py", "/ws/bc7.py", True),
    ],
)
def test_a_pattern(pattern: str, path: str, expected: bool) -> None:
    assert means(pattern, path) is expected


def test_what_is_named_is_read_and_what_is_in_it_by_its_own_names() -> None:
    assert means("a", "/ws/a/b.py")
    assert not means("a", "/ws/a/b.py", "/ws/a")
    assert means("a", "/ws/a/x/a/b.py", "/ws/a")


@pytest.mark.parametrize("pattern", ["!a", "..", "a/../b", "**", "/", "", "a\0", "a" * 2_000])
def test_what_is_no_pattern(pattern: str) -> None:
    with pytest.raises(PatternError):
        pattern_of(pattern)


def test_hostile_patterns_take_no_time() -> None:
    start = time.process_time()
    for pattern in ("*a" * 400 + "b", "**/" * 300 + "b", "**/a/" * 150 + "b", "[" * 900):
        exclusions = Exclusions([Exclusion("/", pattern)])
        for path in ("/" + "a" * 200, "/a" * 1_000, "/" + "[" * 200):
            exclusions.of(path)
    assert time.process_time() - start < 10
