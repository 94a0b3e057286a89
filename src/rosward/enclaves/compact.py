# SPDX-License-Identifier: Apache-2.0
"""With which few patterns do the permissions of an enclave fit into the handshake of DDS?

    /all: 90 KB, 60 are safe  ->  service server /a/*_parameter* for six names, … : 58 KB, and no name that there is allowed besides

Only an enclave that is too large is touched. Patterns are chosen one at a time: first those that allow no further name of the network,
the narrowest first; then those that save most bytes for each name more. It ends as soon as the permissions fit; then each pattern
that they fit without is taken back. It is no search for the best choice, but no pattern of the result is idle. Where no choice of
patterns is enough, none is made: rights that do not help are not given.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Sequence
from typing import Final, final

from rosward.enclaves.patterns import Candidate, MatchedNames, candidates
from rosward.enclaves.privileges import Privilege, by_enclave, on_dds, parts, privileges
from rosward.enclaves.size import LARGEST, privilege_size, signed_size, too_large
from rosward.enclaves.widened import Widened
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.checks import UnknownNames
from rosward.policies.match import Pattern
from rosward.policies.rights import Right
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind, Node

__all__ = ["Compaction", "compact"]

_MOST_SHOWN: Final = 8


class Compaction(NamedTuple):
    """What stands for what, by enclave, and what is to be told: RW340 for each pattern, RW304 for what is still too large."""

    widened: dict[str, tuple[Widened, ...]]
    findings: tuple[Finding, ...]


def compact(nodes: Sequence[Node], unknown: UnknownNames = "deny", largest: int = LARGEST) -> Compaction:
    """The patterns that bring the signed permissions of each enclave down to `largest` bytes."""
    names = MatchedNames(privileges(nodes, unknown))
    widened: dict[str, tuple[Widened, ...]] = {}
    findings: list[Finding] = []
    for path, members in by_enclave(nodes):
        fitting = _Fitting(path, members, unknown, names, largest)
        if fitting.size() <= largest:
            continue
        chosen = fitting.fit()
        if chosen:
            widened[path] = chosen
            findings += (_finding(path, each, members) for each in chosen)
        else:
            more = f"; patterns reduce them only to {-(-fitting.least // 1024)} KB, so none was written"
            findings.append(too_large(path, fitting.size(), members[0], more))
    return Compaction(widened, tuple(findings))


def _finding(path: str, widened: Widened, nodes: Sequence[Node]) -> Finding:
    kind = widened.kind.value
    message = (
        f"enclave {path}: {kind} {widened.name} replaces {len(widened.members)} names; it {widened.also(_MOST_SHOWN)}"
    )
    return Finding("RW340", message, _place(widened, nodes))


def _place(widened: Widened, nodes: Sequence[Node]) -> Place:
    for node in nodes:
        for entity in node.entities:
            if any(
                p.kind is widened.kind and p.name in widened.members for p in parts(Privilege(entity.kind, entity.name))
            ):
                return entity.created_at[0] if entity.created_at else node.defined_at
    return nodes[0].defined_at


@final
class _Fitting:
    """The rights of one enclave while patterns take their places."""

    def __init__(
        self, path: str, nodes: Sequence[Node], unknown: UnknownNames, names: MatchedNames, largest: int
    ) -> None:
        self._path = path
        self._names = names
        self._largest = largest
        self._nodes = frozenset(node.fqn for node in nodes)
        self._own = frozenset(part for whole in privileges(nodes, unknown) for part in parts(whole))
        self._wild: dict[EntityKind, list[Pattern]] = {}
        for right in sorted(self._own, key=lambda p: (p.kind.value, p.name)):
            if "*" in right.name:
                self._wild.setdefault(right.kind, []).append(Pattern(right.name))
        self._sizes = {part: privilege_size(part) for part in self._own}
        self._chosen: list[Candidate] = []
        self._taken: set[Privilege] = set()
        self._allowed: dict[EntityKind, set[str]] = {}
        self._more: dict[tuple[EntityKind, str], frozenset[str]] = {}
        self.least = 0

    def size(self) -> int:
        """The bytes of the permissions with the patterns that are chosen."""
        left = self._own.difference(*(c.members for c in self._chosen))
        rights: set[Right] = {right for each in left for right in on_dds(each)}
        rights.update(right for each in self._chosen for right in on_dds(each.privilege))
        return signed_size(self._path, rights)

    def fit(self) -> tuple[Widened, ...]:
        """The patterns; none where the permissions are too large with all that there are."""
        self._choose()
        self.least = self.size()
        if self.least > self._largest:
            self._chosen = []
            return ()
        self._take_back()
        ordered = sorted(self._chosen, key=lambda c: (c.kind.value, c.name))
        return tuple(
            Widened(
                c.kind, c.name, frozenset(m.name for m in c.members), tuple(sorted(self._more_of(c) | self._perhaps(c)))
            )
            for c in ordered
        )

    def _choose(self) -> None:
        size = self.size()
        queue = [self._entry(c) for c in candidates(self._own, self._nodes)]
        heapq.heapify(queue)
        while queue and size > self._largest:
            entry = heapq.heappop(queue)
            now = self._entry(entry.candidate)
            if now.gain <= 0:
                continue
            if queue and now > queue[0]:
                heapq.heappush(queue, now)
                continue
            one = now.candidate
            self._chosen = [c for c in self._chosen if not (c.kind is one.kind and c.members <= one.members)]
            self._chosen.append(one)
            self._taken |= one.members
            self._allowed.setdefault(one.kind, set()).update(self._more_of(one))
            size -= now.gain

    def _take_back(self) -> None:
        """Without each pattern that is not needed, those that allow most first."""
        size = self.size()
        standing = Counter(member for c in self._chosen for member in c.members)
        for each in sorted(self._chosen, key=lambda c: (-len(self._more_of(c)), -c.reach, c.kind.value, c.name)):
            alone = sum(self._sizes[member] for member in each.members if standing[member] == 1)
            without = size + alone - self._size_of(each)
            if without <= self._largest:
                size = without
                self._chosen.remove(each)
                standing.subtract(each.members)

    def _entry(self, candidate: Candidate) -> _Ranked:
        """How good it is to choose a pattern next."""
        gain = sum(self._sizes[m] for m in candidate.members if m not in self._taken) - self._size_of(candidate)
        gain += sum(
            self._size_of(c) for c in self._chosen if c.kind is candidate.kind and c.members <= candidate.members
        )
        new = len(self._more_of(candidate) - self._allowed.get(candidate.kind, set()))
        rank = (1.0, new / gain if gain > 0 else 0.0) if new else (0.0, float(candidate.reach))
        return _Ranked(*rank, -gain, candidate.kind.value, candidate.name, candidate, gain)

    def _size_of(self, candidate: Candidate) -> int:
        """What the line of a pattern adds: nothing where the enclave has that right anyway."""
        return 0 if candidate.privilege in self._own else privilege_size(candidate.privilege)

    def _more_of(self, candidate: Candidate) -> frozenset[str]:
        """The names of the network that a pattern allows and the rights of the enclave do not."""
        key = candidate.kind, candidate.name
        known = self._more.get(key)
        if known is None:
            matched = self._names.matched(candidate.kind, candidate.name)
            known = self._more[key] = frozenset(n for n in matched if not self._needed(candidate.kind, n))
        return known

    def _perhaps(self, candidate: Candidate) -> frozenset[str]:
        """The names with holes that it may allow, which nobody can count."""
        found = self._names.perhaps(candidate.kind, candidate.name)
        return frozenset(n for n in found if not self._needed(candidate.kind, n))

    def _needed(self, kind: EntityKind, name: str) -> bool:
        if Privilege(kind, name) in self._own:
            return True
        wanted = Pattern(name)
        return any(own.covers(wanted) for own in self._wild.get(kind, ()))


class _Ranked(NamedTuple):
    """In the order in which patterns are tried."""

    costs: float
    cost: float
    minus_gain: int
    kind: str
    name: str
    candidate: Candidate
    gain: int
