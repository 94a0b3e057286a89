# SPDX-License-Identifier: Apache-2.0
"""Which processes does an extraction run, and which does it know?"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rosward import Result, extract
from rosward.analysis.outcome import Done, Outset, Task, outcome_of
from rosward.cache.store import Store
from rosward.source.disk import watching


class Running:
    """Extracts, and tells which processes were run."""

    def __init__(self, store: Store | None, monkeypatch: pytest.MonkeyPatch) -> None:
        self.store = store
        self.ran: list[str] = []
        monkeypatch.setattr("rosward.analysis.runner.outcome_of", self._noted)

    def _noted(self, outset: Outset, task: Task) -> Done:
        self.ran.append(task.entry.label)
        return outcome_of(outset, task)

    def __call__(self, *paths: Path, **options: Any) -> Result:
        self.ran.clear()
        with watching():
            return extract(*paths, store=self.store, **options)
