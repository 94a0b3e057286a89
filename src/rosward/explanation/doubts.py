# SPDX-License-Identifier: Apache-2.0
"""The findings in the order in which a person should read them: errors first, one group for each rule, one line for each cause."""

from __future__ import annotations

from collections.abc import Iterable

from rosward.findings import Finding
from rosward.one_cause import OneCause, by_cause
from rosward.records import NamedTuple
from rosward.rules import RULES, Rule

__all__ = ["Doubts", "doubts"]


class Doubts(NamedTuple):
    """One rule, and where it was found to hold, each cause once; sorted by place."""

    rule: Rule
    causes: tuple[OneCause, ...]


def doubts(findings: Iterable[Finding]) -> tuple[Doubts, ...]:
    """Group the findings by rule: errors, warnings, notes, and by code within these."""
    groups: dict[str, list[OneCause]] = {}
    for one in by_cause(findings):
        groups.setdefault(one.finding.code, []).append(one)
    codes = sorted(groups, key=lambda code: (RULES[code].severity.rank, code))
    return tuple(Doubts(RULES[code], tuple(sorted(groups[code], key=_place))) for code in codes)


def _place(one: OneCause) -> tuple[object, ...]:
    return (one.finding.place, one.finding.message)
