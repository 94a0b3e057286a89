# SPDX-License-Identifier: Apache-2.0
"""What below the paths is not read, so that a user must be told?

--exclude legacy                       RW011  legacy excludes src/legacy: …
src/home -> /home/me               RW012  at src/home: this link leads out of the sources
src/attic/COLCON_IGNORE                RW013  1 folder is marked to be ignored …: src/attic
"""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.source import disk
from rosward.source.text import place_name
from rosward.source.walk import MARKERS, Tree
from rosward.source.workspace import SkipReason

__all__ = ["left_out", "named_few"]

_SHOWN: Final = 5
_NOWHERE: Final = Place("", 0)


def left_out(tree: Tree, root: Path, named: Collection[str]) -> list[Finding]:
    """The findings about what a walk did not enter; `named` are the launch files that the user names by their path."""
    return [*_excluded(tree, root), *_links(tree, root), *_marked(tree, root), *_named_in_marked(root, named)]


def named_few(names: Sequence[str]) -> str:
    """The first few of several names, and how many more there are."""
    more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return f"{', '.join(names[:_SHOWN])}{more}"


def _excluded(tree: Tree, root: Path) -> list[Finding]:
    by_pattern: dict[str, set[str]] = {}
    for path, reason in tree.skipped:
        exclusion = tree.excluded.of(path) if reason is SkipReason.EXCLUDED else None
        if exclusion is not None:
            by_pattern.setdefault(exclusion.pattern, set()).add(place_name(path, root))
    return [
        Finding(
            "RW011",
            f"{pattern} excludes {named_few(sorted(paths))}, which is not in the result.",
            _NOWHERE,
        )
        for pattern, paths in sorted(by_pattern.items())
    ]


def _links(tree: Tree, root: Path) -> list[Finding]:
    message = "This link leads out of the sources. It was not read."
    return [Finding("RW012", message, Place(name)) for name in sorted({place_name(p, root) for p in tree.outside})]


def _marked(tree: Tree, root: Path) -> list[Finding]:
    paths = sorted({place_name(path, root) for path, reason in tree.skipped if reason is SkipReason.IGNORED})
    if not paths:
        return []
    what = "1 folder is" if len(paths) == 1 else f"{len(paths)} folders are"
    return [Finding("RW013", f"{what} marked as ignored (COLCON_IGNORE or similar): {named_few(paths)}.", _NOWHERE)]


def _named_in_marked(root: Path, named: Collection[str]) -> list[Finding]:
    """A launch file that the user names may lie where colcon looks at nothing."""
    findings: list[Finding] = []
    for path in sorted(named):
        folder = os.path.dirname(path)  # noqa: PTH120
        while folder != os.path.dirname(folder):  # noqa: PTH120
            marker = next((m for m in sorted(MARKERS) if disk.is_there(f"{folder}{os.sep}{m}")), None)
            if marker is not None:
                message = f"{marker} in {place_name(folder, root)} hides this launch file from the build."
                findings.append(Finding("RW015", message, Place(place_name(path, root))))
                break
            if disk.is_there(f"{folder}{os.sep}.git"):
                break
            folder = os.path.dirname(folder)  # noqa: PTH120
    return findings
