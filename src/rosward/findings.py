# SPDX-License-Identifier: Apache-2.0
"""The record of one finding, and several of them. Their kinds are in `rules.py`.

A finding is the only way in which rosward speaks of a doubt: what is not known, not read or assumed has a code,
a place, a message and what to do about it. Codes are stable: RW0xx input, RW1xx names, RW2xx analysis, RW3xx system and policy,
RW4xx policies that are checked, RW5xx running systems.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.rules import RULES, Rule


class Finding(NamedTuple):
    """One doubt at one place: `code` is a key of `RULES`; `message` says what is the matter and, where known, how to settle it.

    `causes` say by what it is there, so that findings of one cause are told together (`one_cause.py`); none where that is not known.
    `nodes` are the full names of those that it is about, where that is known and its place alone does not say it. `remedy` is what the message
    ends with where it says how to settle it: then that counts, and not the help of the rule. `path`: the lines that lead to the place, where it is
    about what flows there. `doubts` are the reasons that the message of `doubtful` names.
    """

    code: str
    message: str
    place: Place
    causes: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    remedy: str = ""
    path: tuple[Place, ...] = ()
    doubts: tuple[str, ...] = ()

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


_BECAUSE: Final = " because of "
_MOST_DOUBTS: Final = 6


def doubtful(
    code: str, what: str, doubts: Sequence[str], place: Place, causes: tuple[str, ...] = (), *, remedy: str = ""
) -> Finding:
    """What is not known, because of what, and the one thing that settles it."""
    named = "; ".join(doubts[:_MOST_DOUBTS])
    more = len(doubts) - _MOST_DOUBTS
    because = f"{_BECAUSE}{named}{f'; and {more} more' if more > 0 else ''}" if doubts else ""
    message = f"{what}{because}: {remedy}" if remedy else f"{what}{because}"
    return Finding(code, message, place, causes, remedy=remedy, doubts=tuple(doubts))


def each_once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """The findings sorted by place, those of one code, place and message as one, of all their causes, nodes and doubts."""
    found: dict[tuple[Place, str, str], list[Finding]] = {}
    for finding in findings:
        about = finding.message.partition(_BECAUSE)[0] if finding.doubts else finding.message
        found.setdefault((finding.place, finding.code, about), []).append(finding)
    return tuple(sorted((_as_one(key[2], same) for key, same in found.items()), key=_position))


def _position(finding: Finding) -> tuple[Place, str, str]:
    return finding.place, finding.code, finding.message


def _as_one(about: str, findings: list[Finding]) -> Finding:
    """One for findings that say the same, or of which only the reasons differ."""
    first = min(findings, key=_position)
    if len(findings) == 1:
        return first
    causes = tuple(sorted({cause for each in findings for cause in each.causes}))
    nodes = tuple(sorted({node for each in findings for node in each.nodes}))
    doubts = tuple(dict.fromkeys(doubt for each in sorted(findings, key=_position) for doubt in each.doubts))
    if doubts != first.doubts:
        remedy = next((each.remedy for each in sorted(findings, key=_position) if each.remedy), "")
        first = doubtful(first.code, about, doubts, first.place, remedy=remedy)
    return first._replace(causes=causes, nodes=nodes)
