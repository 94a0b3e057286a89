# SPDX-License-Identifier: Apache-2.0
"""What a kind of finding is: its code, how much it weighs, and what can be done about it."""

from __future__ import annotations

import enum

from rosward.records import NamedTuple


class Severity(enum.Enum):
    """How much a finding weighs; an `error` makes the result incomplete."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"

    @property
    def rank(self) -> int:
        """0 for the heaviest."""
        return list(Severity).index(self)


class Rule(NamedTuple):
    """One kind of finding: its stable code, a short title, its severity and what a user can do about it."""

    code: str
    title: str
    severity: Severity
    help: str
