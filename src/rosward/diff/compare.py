# SPDX-License-Identifier: Apache-2.0
"""What came and what went between two states of a system?

    old: publisher /chatter in enclave /talker     new: publisher /status in enclave /talker
      ->  rights gained: publisher /status         rights lost: publisher /chatter

A right is gained if the old state does not allow all of it: that of `/robot_1/cmd` is none where `/robot_*/cmd` was allowed, and a
denial that was taken away gives the rule that it restricted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final, Generic, TypeVar

from rosward.diff.of_nodes import snapshot_of
from rosward.diff.snapshot import ComparedState, EntityLine
from rosward.findings import Finding
from rosward.guard import Steps
from rosward.location import Place
from rosward.network.asked import asked_differently
from rosward.network.network_file import read_network
from rosward.policies.judge import Judge, Verdict
from rosward.policies.read import read_policy
from rosward.policies.records import EnclavePolicy, Policy
from rosward.policies.rights import Right
from rosward.records import NamedTuple
from rosward.source import limits
from rosward.source.json_fields import UnreadableError
from rosward.source.text import read_bytes

__all__ = ["Change", "Differences", "RightLine", "compare", "not_compared", "read_snapshot"]

_Line = TypeVar("_Line")
_Sorted = TypeVar("_Sorted", str, EntityLine)


class RightLine(NamedTuple):
    """A right of an enclave: the words and the name of the rule that gives it; `place` is that of the rule, or of the code that needs it."""

    enclave: str
    words: str
    name: str
    place: Place

    def __str__(self) -> str:
        return f"{self.enclave}: {self.words} {self.name}"


@dataclass(frozen=True)
class Change(Generic[_Line]):
    """What came and what went of one kind, sorted."""

    gained: tuple[_Line, ...]
    lost: tuple[_Line, ...]


class Differences(NamedTuple):
    """All changes. Of two policies, nodes are profiles, and there are no entities. `notes` say what was not compared, or asked otherwise."""

    nodes: Change[str]
    entities: Change[EntityLine]
    rights: Change[RightLine]
    notes: tuple[str, ...] = ()
    failures: tuple[Finding, ...] = ()
    """RW299: what was not compared because rosward itself failed. They are among the notes, too."""

    def failing(self, failures: Iterable[Finding]) -> Differences:
        """The same, with these failures too."""
        told = tuple(failures)
        notes = (*self.notes, *(f"{f.code}: {f.message}" for f in told))
        return self._replace(notes=notes, failures=(*self.failures, *told))

    @property
    def empty(self) -> bool:
        """Whether nothing came and nothing went."""
        return not any(change.gained or change.lost for change in self[:3])


_NO_CHANGE: Final[Change[Any]] = Change((), ())


def read_snapshot(path: str) -> ComparedState:
    """What a file holds: a policy where it is XML, else a network. Raises UnreadableError."""
    data = read_bytes(path, path, limits.DIFF_FILE)
    if isinstance(data, Finding):
        raise UnreadableError(f"{path}: {data.message}")
    if not data.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"<"):
        read = read_network(path)
        return snapshot_of(read.nodes, path)._replace(asked=read.asked)
    policy = read_policy([path])
    if policy.findings:
        raise UnreadableError("; ".join(f"{f.place}: {f.message}" for f in policy.findings[:3]))
    profiles = frozenset(f"{e.path}: {name}" for e in policy.enclaves for name in e.profiles)
    return ComparedState("policy", profiles, frozenset(), policy)


def compare(old: ComparedState, new: ComparedState, *, net: bool = True) -> Differences:
    """The changes from one state to another of the same kind. What rosward fails on is not compared, and told; without `net` it is raised."""
    steps = Steps(net=net)
    found = Differences(
        steps(lambda: _change(old.nodes, new.nodes), _NO_CHANGE, "the nodes were not compared"),
        steps(lambda: _change(old.entities, new.entities), _NO_CHANGE, "the entities were not compared"),
        steps(
            lambda: Change(_beyond(new.policy, old.policy), _beyond(old.policy, new.policy)),
            _NO_CHANGE,
            "the permissions were not compared",
        ),
        tuple(asked_differently(old.asked, new.asked)),
    )
    return found.failing(steps.findings)


def not_compared(failures: Iterable[Finding]) -> Differences:
    """What is told where rosward failed on one of the sides."""
    return Differences(_NO_CHANGE, _NO_CHANGE, _NO_CHANGE).failing(failures)


def _change(old: frozenset[_Sorted], new: frozenset[_Sorted]) -> Change[_Sorted]:
    return Change(tuple(sorted(new - old)), tuple(sorted(old - new)))


def _beyond(policy: Policy, other: Policy) -> tuple[RightLine, ...]:
    """The rights that one gives and the other does not, or not wholly."""
    others = {enclave.path: enclave for enclave in other.enclaves}
    found: dict[tuple[str, str, str], RightLine] = {}
    for enclave in policy.enclaves:
        for line in _beyond_enclave(enclave, others.get(enclave.path)):
            found.setdefault(line[:3], line)
    return tuple(sorted(found.values()))


def _beyond_enclave(enclave: EnclavePolicy, other: EnclavePolicy | None) -> Iterator[RightLine]:
    if other is None:
        other = EnclavePolicy(enclave.path, enclave.place, adds_discovery=False)
    if enclave.default_allow and not other.default_allow:
        yield RightLine(enclave.path, "default", "ALLOW", enclave.place)
    if _in_short(enclave) == _in_short(other):
        return
    own, judge = Judge(enclave), Judge(_without_shared_denials(other, enclave))
    for rule in enclave.rules:
        given = [r for r in rule.rights if rule.allow and own(r).verdict is not Verdict.REFUSED]
        if any(judge(right).verdict is not Verdict.ALLOWED for right in given):
            yield RightLine(enclave.path, rule.words, rule.name, rule.place)


def _in_short(enclave: EnclavePolicy) -> list[tuple[bool, tuple[Right, ...]]]:
    return [(rule.allow, rule.rights) for rule in enclave.rules]


def _without_shared_denials(other: EnclavePolicy, enclave: EnclavePolicy) -> EnclavePolicy:
    """What both deny before all else makes no difference, and would only leave patterns allowed in part."""
    if not (_denies_first(other) and _denies_first(enclave) and _denials(other) <= _denials(enclave)):
        return other
    return other._replace(rules=tuple(rule for rule in other.rules if rule.allow))


def _denies_first(enclave: EnclavePolicy) -> bool:
    allowed = [rule.allow for rule in enclave.rules]
    return allowed == sorted(allowed)


def _denials(enclave: EnclavePolicy) -> frozenset[Right]:
    return frozenset(right for rule in enclave.rules if not rule.allow for right in rule.rights)
