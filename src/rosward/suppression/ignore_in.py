# SPDX-License-Identifier: Apache-2.0
"""Which findings does the configuration ignore in some files only?

    [ignore-in]
    "legacy/**" = ["RW102", "RW302"]     ->  IgnoreIn(Exclusion("/ws", "legacy/**"), {"RW102", "RW302"})

The patterns are those of `--exclude`; the file is read all the same.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from pathlib import Path
from typing import final

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.source.exclude import Exclusion, Exclusions

__all__ = ["IgnoreIn", "IgnoredPaths"]


class IgnoreIn(NamedTuple):
    """The codes that are ignored in the files that a pattern means."""

    files: Exclusion
    codes: Collection[str]


@final
class IgnoredPaths:
    """All such patterns, asked for one finding at a time. Places are relative to `root`."""

    def __init__(self, wishes: Iterable[IgnoreIn], root: Path) -> None:
        self._root = root
        self._rules = [(Exclusions([wish.files]), wish.codes) for wish in wishes]

    def mean(self, finding: Finding) -> bool:
        """Whether a finding is to be ignored because of its file."""
        if not finding.place.file:
            return False
        rules = [files for files, codes in self._rules if finding.code in codes]
        return bool(rules) and any(f.of(str(self._root.absolute() / finding.place.file)) is not None for f in rules)
