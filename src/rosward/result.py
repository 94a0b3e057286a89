# SPDX-License-Identifier: Apache-2.0
"""What did an extraction give? The record alone: whoever only shows a result loads nothing that analyses."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rosward.rules import Severity

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.findings import Finding
    from rosward.network.graph import Network
    from rosward.network.launch_tree import LaunchSystem
    from rosward.source.workspace import SourceFile

__all__ = ["Result"]


@dataclass(frozen=True)
class Result:
    """What an extraction gave. `complete` is False where a finding says that something is missing from the network."""

    network: Network
    root: Path
    files: tuple[SourceFile, ...] = ()
    """The programs and launch files that were read, each with its path alone."""
    systems: tuple[LaunchSystem, ...] = ()
    """What the launch files start, where they were followed."""
    excluded: int = 0
    """How many files and folders were left unread because a pattern means them."""
    ignored: int = 0
    """How many folders were left unread because they are marked as ignored (COLCON_IGNORE or similar)."""
    launch_files: int = 0
    """How many launch files there are."""
    kept_as: str = field(default="", compare=False)
    """What tells it from other results, where it is in a cache."""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, sorted."""
        return self.network.findings

    @property
    def complete(self) -> bool:
        """Whether the network holds all that the sources do, as far as the documented assumptions go."""
        return not any(f.rule.severity is Severity.ERROR for f in self.findings)
