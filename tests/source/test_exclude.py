# SPDX-License-Identifier: Apache-2.0
"""Which paths a pattern means. What happens to them is in tests/test_cli_configuration.py."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from pathlib import Path
from typing import Final

import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st
from laws import examples

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
        ("a/**/", "/ws/a/x/b.py", True),
        ("a/**/", "/ws/a/b.py", False),
        ("a/", "/ws/a/b.py", True),
        ("a/", "/ws/x/a", False),  # a folder, and there is none
        ("b?[0-9].py", "/ws/bc7.py", True),
        ("[^a].py", "/ws/b.py", True),
        ("[^a].py", "/ws/a.py", False),
        (r"\*.py", "/ws/*.py", True),
        (r"\*.py", "/ws/a.py", False),
        (r"\[a].py", "/ws/[a].py", True),
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


ATOMS: Final = (
    "a",
    "b",
    "ab",
    ".",
    ".py",
    "*",
    "?",
    "/",
    "**/",
    "/**/",
    "[ab]",
    "[!a]",
    "[^a]",
    "[a-b]",
    "[]a]",
    r"\a",
    r"\*",
)
PATTERNS: Final = st.lists(st.sampled_from(ATOMS), min_size=1, max_size=5).map("".join)


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository with files and folders of short names, two levels deep."""
    top = tmp_path_factory.mktemp("repository")
    subprocess.run(["git", "init", "-q", str(top)], check=True)
    for outer in ("", "a", "b", ".a", "a/b", "b/ab"):
        (top / outer).mkdir(exist_ok=True)
    for folder in [top, *(p for p in top.glob("[ab.]*/**") if p.is_dir() and ".git" not in p.parts)]:
        for name in ("ab", "x.py", "a*", "ba.py"):
            if not (folder / name).exists():
                (folder / name).touch()
    return top


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
@settings(max_examples=examples(2.4), deadline=None, suppress_health_check=list(HealthCheck))
@given(pattern=PATTERNS)
@example(pattern="a/**")
def test_a_pattern_means_what_git_takes_it_for(tree: Path, pattern: str) -> None:
    """Left out: `//` and `./`, which mean nothing to git, and stars that git takes for folders behind a text (`a**/`)."""
    parts = pattern.split("/")
    assume("//" not in pattern and "." not in parts and not any("**" in part and part != "**" for part in parts))
    try:
        pattern_of(pattern)
    except PatternError:
        assume(False)
    paths = [os.path.relpath(p, tree) for p in tree.rglob("*") if ".git" not in p.parts]
    (tree / ".git" / "info" / "exclude").write_text(pattern + "\n")
    said = subprocess.run(
        ["git", "-C", str(tree), "check-ignore", "--no-index", "-z", "--stdin"],
        input="\0".join(paths),
        capture_output=True,
        text=True,
        check=False,
    )
    exclusions = Exclusions([Exclusion(str(tree), pattern)])
    assert {p for p in paths if exclusions.of(str(tree / p))} == set(said.stdout.split("\0")) - {""}
