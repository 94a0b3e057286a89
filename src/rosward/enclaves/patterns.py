# SPDX-License-Identifier: Apache-2.0
"""Which patterns may stand for several rights, and which names does each match beside them?

    service servers /a/get_parameters, /a/set_parameters, /a/list_parameters, …   ->  /a/*_parameter*, /a/*
    publishers /robot1/odom, /robot1/scan, /robot2/odom                           ->  /robot1/*, /robot*/odom

A pattern is a beginning, `*` and an end, for some `*`, a middle and `*`. It is in the words of a policy, so sros2 makes the same of it
as we do: `<topic>/robot1/*</topic>` is `rt/robot1/*`. `*` crosses `/`. A right with a hole in its name stays as it is, and no
pattern is `/*`: what allows every name is no reduction.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Set
from typing import Final, final

from rosward.enclaves.privileges import Privilege, parts
from rosward.policies.match import Pattern
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind

__all__ = ["Candidate", "MatchedNames", "candidates"]

_TOPICS: Final = frozenset({EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION})
_PARAMETERS: Final = "_parameter"
_ACTION: Final = "/_action/"
_BOUNDARY: Final = re.compile(r"(?<=_)(?=[^/_])|(?<=[A-Za-z])(?=[0-9])")
"""Where a name may end in a number or a word of its own: behind `_`, before digits."""


class Candidate(NamedTuple):
    """A pattern and what it would stand for. `reach`: the smaller, the fewer names anyone may think of match it."""

    kind: EntityKind
    name: str
    members: frozenset[Privilege]
    reach: int

    @property
    def privilege(self) -> Privilege:
        """The right that the pattern is."""
        return Privilege(self.kind, self.name)


@final
class MatchedNames:
    """Every name of a network, ready to be asked which of them a pattern matches."""

    def __init__(self, all_privileges: Iterable[Privilege]) -> None:
        topics: set[str] = set()
        services: set[str] = set()
        for whole in all_privileges:
            for part in parts(whole):
                if part.ros:
                    (topics if part.kind in _TOPICS else services).add(part.name)
        self._names = {True: _Sorted(topics), False: _Sorted(services)}

    def matched(self, kind: EntityKind, pattern: str) -> Iterator[str]:
        """The names of topics, or of services, that a pattern matches; where they have holes themselves, whatever they turn out to be."""
        return self._names[kind in _TOPICS].matched(pattern)

    def perhaps(self, kind: EntityKind, pattern: str) -> Iterator[str]:
        """The names with holes that a pattern may match or not."""
        return self._names[kind in _TOPICS].perhaps(pattern)


@final
class _Sorted:
    def __init__(self, names: Iterable[str]) -> None:
        everything = sorted(names)
        self._plain = [name for name in everything if "*" not in name]
        self._wild = [(name, Pattern(name)) for name in everything if "*" in name]

    def matched(self, pattern: str) -> Iterator[str]:
        start = pattern.partition("*")[0]
        fits = re.compile(".*".join(map(re.escape, pattern.split("*")))).fullmatch
        for index in range(bisect_left(self._plain, start), len(self._plain)):
            name = self._plain[index]
            if not name.startswith(start):
                break
            if fits(name):
                yield name
        ours = Pattern(pattern)
        yield from (name for name, theirs in self._wild if ours.covers(theirs))

    def perhaps(self, pattern: str) -> Iterator[str]:
        ours = Pattern(pattern)
        yield from (name for name, theirs in self._wild if ours.meets(theirs) and not ours.covers(theirs))


def candidates(rights: Iterable[Privilege], nodes: Set[str]) -> list[Candidate]:
    """The patterns that stand for two rights or more; of those that stand for the same ones, that which says most of a name.

    `nodes` are the full names of the nodes of the enclave.
    """
    members: dict[tuple[EntityKind, str], set[Privilege]] = {}
    for right in rights:
        if right.ros and "*" not in right.name:
            for pattern in _patterns(right.name):
                members.setdefault((right.kind, pattern), set()).add(right)
    narrowest: dict[tuple[EntityKind, frozenset[Privilege]], str] = {}
    for (kind, name), several in sorted(members.items(), key=lambda item: (item[0][0].value, item[0][1])):
        if len(several) > 1:
            key = kind, frozenset(several)
            if len(name.replace("*", "")) > len(narrowest.get(key, "").replace("*", "")):
                narrowest[key] = name
    return [Candidate(kind, name, several, _reach(name, nodes)) for (kind, several), name in narrowest.items()]


def _patterns(name: str) -> Iterator[str]:
    """The patterns that match a name and may match its neighbours."""
    slashes = [i for i, character in enumerate(name) if character == "/"]
    starts = sorted({*(i + 1 for i in slashes), *(m.start() for m in _BOUNDARY.finditer(name))})
    folder, last = name[: slashes[-1] + 1], name[slashes[-1] + 1 :]
    if _PARAMETERS in last:
        yield f"{folder}*{_PARAMETERS}*"
    for start in starts:
        if start > 1:
            yield name[:start] + "*"
        for slash in slashes:
            if slash > start:  # something stands between
                yield f"{name[:start]}*{name[slash:]}"


def _reach(pattern: str, nodes: Set[str]) -> int:
    start, _, rest = pattern.partition("*")
    if start.endswith(_ACTION):
        return 0
    if start.endswith("/") and start[:-1] in nodes:
        return 1 if rest else 2
    return 3 if rest else 4
