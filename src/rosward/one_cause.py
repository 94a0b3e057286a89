# SPDX-License-Identifier: Apache-2.0
"""Which findings have one cause, so that a person reads them as one?

    RW312 the launch argument 'ns' has no value            ->  RW312 …, and 54 more with this cause: 37 RW101, 17 RW102
    RW101 the name of this publisher is not known because of launch argument …: ns
    …

Nothing gets lost: a cause weighs what the heaviest of its findings does, and each of them is still there with its place.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from typing import Final, TypeVar

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.rules import Severity

__all__ = ["OneCause", "alike", "by_cause", "more_of"]

_T = TypeVar("_T")

_SAY_WHY: Final = frozenset(("RW207", "RW312"))
"""What tells of a cause itself, where other findings tell what follows from it."""

_FOLLOW: Final = frozenset(("RW302",))
"""What is no news beside a finding of the same cause and place: that a name is known in part says that the policy has a wildcard."""

_WEIGHT: Final = {severity: index for index, severity in enumerate(Severity)}


class OneCause(NamedTuple):
    """A finding, and what else is there for the same cause."""

    finding: Finding
    also: tuple[Finding, ...] = ()


def by_cause(findings: Iterable[Finding]) -> tuple[OneCause, ...]:
    """The findings, those of one cause together: the heaviest first; of these what tells of the cause itself, then what says how to settle it."""
    return tuple(OneCause(first, tuple(rest)) for first, *rest in alike(findings, lambda finding: finding))


def alike(
    things: Iterable[_T], finding: Callable[[_T], Finding], apart: Callable[[_T], object] = bool
) -> list[list[_T]]:
    """Things that have findings, put together by the causes of these; never together are those that `apart` tells from each other."""
    groups: dict[object, list[_T]] = {}
    for number, each in enumerate(things):
        causes = finding(each).causes
        groups.setdefault((causes, apart(each)) if causes else number, []).append(each)
    return [sorted(group, key=lambda each: _order(finding(each))) for group in groups.values()]


def _order(finding: Finding) -> tuple[object, ...]:
    weight = _WEIGHT[finding.rule.severity]
    return (weight, finding.code not in _SAY_WHY, not finding.remedy, finding.code, finding.place, finding.message)


def more_of(one: OneCause) -> str:
    """What there is beside the finding that is shown: `54 more with this cause: 37 RW101, 17 RW102`; empty where there is nothing."""
    named = {finding.place for finding in (one.finding, *one.also) if finding.code not in _FOLLOW}
    counts = Counter(f.code for f in one.also if f.code not in _FOLLOW or f.place not in named)
    if not counts:
        return ""
    told = f"{sum(counts.values()):,} more with this cause"
    if set(counts) == {one.finding.code}:
        return told
    return f"{told}: " + ", ".join(f"{number:,} {code}" for code, number in sorted(counts.items()))
