# SPDX-License-Identifier: Apache-2.0
"""A path of the repository that a page names exists.

`engine/budget.py`, `tests/docs/`, `deployment/markup/tags_*.py`, `src/rosward/models/nodes/PKG.yaml`
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest
from docsite.pages import DOCS, ROOT, pages, prose

PACKAGE: Final = ROOT / "src" / "rosward"
ABOUT_ROSWARD: Final = {
    ROOT / "CONTRIBUTING.md",
    *(DOCS / f"{name}.md" for name in ("architecture", "limits", "semantics", "special-methods", "trust")),
    *(DOCS / "decisions").glob("*.md"),
}
"""Pages about rosward itself. On other pages, `src/driver.py` or `models/nodes/` is a file of the reader."""

FOREIGN: Final = {"yaml.py"}
"""A file of somebody else on these pages."""

ITS_OWN: Final = ("src/rosward/", "tests/", "bench/", "tools/", "docs/", ".ci/", "ci/")
_SPAN: Final = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
_PATH: Final = re.compile(r"[\w.*-]+(?:/[\w.*-]+)*/?")
_PLACEHOLDER: Final = re.compile(r"(?<![a-z])[A-Z]{3,}(?![a-z])")


def paths_of(text: str, *, about_rosward: bool) -> Iterator[str]:
    """The code spans of a page that look like a path of the repository."""
    folders = {path.name for path in (*ROOT.iterdir(), *PACKAGE.iterdir()) if path.is_dir()}
    for span in _SPAN.findall(prose(text, inline=False)):
        if (
            _PATH.fullmatch(span)
            and span not in FOREIGN
            and (
                span.startswith(ITS_OWN)
                or (about_rosward and (("/" in span and span.partition("/")[0] in folders) or span.endswith(".py")))
            )
        ):
            yield span


def exists(span: str) -> bool:
    """Whether the repository or the package has it; a name alone may be in any folder of the package or the tests."""
    if "/" not in span:
        return (ROOT / span).is_file() or any(
            next(folder.rglob(span), None) for folder in (PACKAGE, *(ROOT / n for n in ("tests", "tools", "bench")))
        )
    pattern = span.rstrip("/")
    patterns = {pattern, _PLACEHOLDER.sub("*", pattern)}
    return any(next(folder.glob(p), None) for folder in (ROOT, PACKAGE, ROOT / "src") for p in patterns)


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.relative_to(ROOT).as_posix())
def test_paths_that_a_page_names_exist(page: Path) -> None:
    if page.name != "CHANGELOG.md":  # it speaks of what was
        named = set(paths_of(page.read_text(encoding="utf-8"), about_rosward=page in ABOUT_ROSWARD))
        assert sorted(span for span in named if not exists(span)) == []


def test_modules_in_the_tables_of_the_architecture_exist() -> None:
    """Below a heading "`engine/`", the first column of a table names modules and folders of `engine/`."""
    text = (DOCS / "architecture.md").read_text(encoding="utf-8")
    missing = []
    for folder, section in re.findall(r"^#{2,} `([\w/]+)/`[^\n]*\n(.*?)(?=^#|\Z)", text, re.MULTILINE | re.DOTALL):
        room = ROOT / folder if (ROOT / folder).is_dir() else PACKAGE / folder
        for row in re.findall(r"^\| (`[^|]*?) \|", section, re.MULTILINE):
            names = [name.rstrip("/") for name in _SPAN.findall(row)]
            missing += [f"{folder}/{n}" for n in names if not any(room.glob(f"{n}*")) and not (room / n).exists()]
    assert missing == []


@pytest.mark.parametrize(
    ("text", "about_rosward", "expected"),
    [
        ("see `tests/docs/` and `src/driver.py`", False, ["tests/docs/"]),
        ("see `engine/budget.py`, `pipeline.py`, `a/b`, `rosward.toml`", True, ["engine/budget.py", "pipeline.py"]),
        ("```\n`tests/x`\n```\n", True, []),
    ],
)
def test_what_looks_like_a_path(text: str, about_rosward: bool, expected: list[str]) -> None:
    assert list(paths_of(text, about_rosward=about_rosward)) == expected


@pytest.mark.parametrize(
    ("span", "there"),
    [
        ("engine/budget.py", True),
        ("engine/nowhere.py", False),
        ("tests/docs/", True),
        ("src/rosward/models/nodes/PKG.yaml", True),
        ("test_layers.py", True),
        ("no_such_file.py", False),
        ("deployment/markup/tags_*.py", True),
    ],
)
def test_what_exists(span: str, there: bool) -> None:
    assert exists(span) is there
