# SPDX-License-Identifier: Apache-2.0
"""The findings in the order in which a person should read them: errors first, one group for each rule."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, NamedTuple

from rosward.findings import RULES, Finding, Rule, Severity

__all__ = ["Doubts", "doubts"]

_ORDER: Final = {severity: index for index, severity in enumerate(Severity)}


class Doubts(NamedTuple):
    """One rule, and where it was found to hold; sorted by place."""

    rule: Rule
    findings: tuple[Finding, ...]


def doubts(findings: Iterable[Finding]) -> tuple[Doubts, ...]:
    """Group the findings by rule: errors, warnings, notes, and by code within these."""
    groups: dict[str, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(finding.code, []).append(finding)
    codes = sorted(groups, key=lambda code: (_ORDER[RULES[code].severity], code))
    return tuple(Doubts(RULES[code], tuple(sorted(groups[code], key=lambda f: (f.place, f.message)))) for code in codes)
