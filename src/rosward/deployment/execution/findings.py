# SPDX-License-Identifier: Apache-2.0
"""What the execution of launch files has to tell, each once."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final, final

from rosward.findings import Finding, Findings
from rosward.location import Place

MAX_FINDINGS: Final = 5_000


@final
class FindingLog:
    """Findings, each once, in the order in which they came up."""

    def __init__(self) -> None:
        self._found = Findings()
        self._heard: list[Findings] = []

    @contextmanager
    def heard(self) -> Iterator[Findings]:
        """What is told meanwhile, also where it was told before."""
        told = Findings()
        self._heard.append(told)
        try:
            yield told
        finally:
            self._heard.pop()

    def tell(self, code: str, message: str, place: Place, causes: tuple[str, ...] = ()) -> None:
        """Tell a doubt."""
        self.add(Finding(code, message, place, causes))

    def add(self, *findings: Finding) -> None:
        """Tell doubts that somebody else has found."""
        if len(self._found) < MAX_FINDINGS:
            for found in (self._found, *self._heard):
                found.update(findings)

    def all(self) -> tuple[Finding, ...]:
        """All that were told."""
        return tuple(self._found)
