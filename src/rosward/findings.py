# SPDX-License-Identifier: Apache-2.0
"""The record of one finding, and several of them. Their kinds are in `rules.py`.

A finding is the only way in which rosward speaks of a doubt: what is not known, not read or assumed has a code,
a place, a message and what to do about it. Codes are stable: RW0xx input, RW1xx names, RW2xx analysis, RW3xx system and policy,
RW4xx policies that are checked, RW5xx running systems.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import final

from rosward.records import NamedTuple
from rosward.rules import RULES, Rule
from rosward.source.location import Place


class Finding(NamedTuple):
    """One doubt at one place: `code` is a key of `RULES`; `message` says what is the matter and, where known, how to settle it.

    `causes` say by what it is there, so that findings of one cause are told together (`one_cause.py`); none where that is not known.
    `nodes` are the full names of those that it is about, where that is known and its place alone does not say it. `remedy` is what the message
    ends with where it says how to settle it: then that counts, and not the help of the rule. `path`: the lines that lead to the place, where it is
    about what flows there.
    """

    code: str
    message: str
    place: Place
    causes: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    remedy: str = ""
    path: tuple[Place, ...] = ()

    @property
    def rule(self) -> Rule:
        """The rule that this finding is an instance of."""
        return RULES[self.code]


@final
class Findings:
    """Findings, each once, in the order in which they were added."""

    __slots__ = ("_kept",)

    def __init__(self, findings: Iterable[Finding] = ()) -> None:
        self._kept = dict.fromkeys(findings)

    def add(self, finding: Finding) -> None:
        """Add a finding, unless it is there."""
        self._kept[finding] = None

    def update(self, findings: Iterable[Finding]) -> None:
        """Add each of several findings."""
        self._kept.update(dict.fromkeys(findings))

    def __iter__(self) -> Iterator[Finding]:
        return iter(self._kept)

    def __len__(self) -> int:
        return len(self._kept)

    def __contains__(self, finding: object) -> bool:
        return finding in self._kept


def each_once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """The findings sorted by place, those of one code, place and message as one, of all their causes and nodes."""
    found: dict[tuple[Place, str, str], Finding] = {}
    for finding in findings:
        key = (finding.place, finding.code, finding.message)
        known = found.get(key)
        found[key] = finding if known is None else _both(known, finding)
    return tuple(found[key] for key in sorted(found))


def _both(left: Finding, right: Finding) -> Finding:
    """One for two findings that say the same."""
    causes = tuple(sorted({*left.causes, *right.causes}))
    return left._replace(causes=causes, nodes=tuple(sorted({*left.nodes, *right.nodes})))
