# SPDX-License-Identifier: Apache-2.0
"""Does a policy let each process do what its code does, and nothing else?

    needed publisher /chatter, no rule for it         ->  RW401, at talker.py:7
    a rule for /debug, which no code of the enclave uses  ->  RW402, at policy.xml:12

Of a name that is not known at all nothing is lacking: that it is not known is told of the sources (RW101, RW105, RW314). So a policy that was
written from the sources lacks nothing and has nothing too much. A right counts as used as soon as a name that is only known in part may be its
name, so nothing is called superfluous that may be used.
A rule with a pattern is told where it also allows names that nobody uses.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.counts import listed
from rosward.network.graph import Network
from rosward.policies.judge import Judge, Judgement, Verdict
from rosward.policies.match import Pattern
from rosward.policies.needs import EnclaveNeeds, Need, needs_of
from rosward.policies.records import EnclavePolicy, Policy, PolicyRule
from rosward.policies.rights import DISCOVERY, Direction, Right
from rosward.records import NamedTuple

__all__ = ["Discrepancy", "Related", "compare"]

_MOST_PLACES: Final = 5
_ROS_PREFIXES: Final = ("rt/", "rq/", "rr/")


class Related(NamedTuple):
    """Another place that has to do with a discrepancy, in the policy or in the sources."""

    message: str
    place: Place
    in_policy: bool


class Discrepancy(NamedTuple):
    """One difference in one enclave; `right` is what lacks or is too much, '' where the enclave itself is.

    `in_policy`: the finding stands in the policy, else in the sources.
    """

    enclave: str
    right: str
    finding: Finding
    in_policy: bool = False
    related: tuple[Related, ...] = ()


def compare(network: Network, policy: Policy) -> tuple[Discrepancy, ...]:
    """Every difference, sorted by enclave and code."""
    by_path = {enclave.path: enclave for enclave in policy.enclaves}
    found: list[Discrepancy] = []
    needed: dict[str, list[Need]] = {}
    runs: dict[str, list[Related]] = {}
    for wanted in needs_of(network.nodes):
        chosen = _candidates(wanted, by_path)
        if not chosen:
            found.append(_without_enclave(wanted))
        for enclave in chosen:
            found += _lacking(enclave, wanted)
            needed.setdefault(enclave.path, []).extend(wanted.needs)
            runs.setdefault(enclave.path, []).extend(_nodes(wanted))
    for enclave in policy.enclaves:
        if enclave.path in needed:
            found += _superfluous(enclave, needed[enclave.path], runs[enclave.path])
        else:
            message = f"no process in the sources runs in enclave {enclave.path}"
            found.append(Discrepancy(enclave.path, "", Finding("RW404", message, enclave.place), in_policy=True))
    return tuple(sorted(dict.fromkeys(found), key=_order))


def _order(one: Discrepancy) -> tuple[str, str, Place, str]:
    return one.enclave, one.finding.code, one.finding.place, one.finding.message


def _candidates(wanted: EnclaveNeeds, by_path: dict[str, EnclavePolicy]) -> list[EnclavePolicy]:
    """The enclave of that path; where the path is only known in part, each that it may be."""
    if wanted.path in by_path:
        return [by_path[wanted.path]]
    pattern = Pattern(wanted.found)
    return [enclave for path, enclave in by_path.items() if pattern.wild and pattern.matches(path)]


def _without_enclave(wanted: EnclaveNeeds) -> Discrepancy:
    node = wanted.nodes[0]
    processes = ", ".join(sorted({n.process for n in wanted.nodes}))
    message = f"the policy has no enclave {wanted.path}, where {processes} runs ({_several(n.display_name for n in wanted.nodes)})"
    return Discrepancy(wanted.path, "", Finding("RW405", message, node.launched_by or node.defined_at))


def _lacking(enclave: EnclavePolicy, wanted: EnclaveNeeds) -> Iterator[Discrepancy]:
    judge = Judge(enclave)
    for need in wanted.needs:
        if not need.known or (enclave.adds_discovery and not _has_a_rule(need)):
            continue
        judged = [(right, judge(right)) for right in need.rights]
        short = [(right, said) for right, said in judged if said.verdict is not Verdict.ALLOWED]
        if short:
            message = _message(need, short)
            related = [Related(f"enclave {enclave.path} of the policy", enclave.place, in_policy=True)]
            related += (Related(f"denied by {r}", r.place, in_policy=True) for r in _denials(short))
            related += (
                Related(f"{need}, also created here", place, in_policy=False) for place in need.places[1:_MOST_PLACES]
            )
            finding = Finding("RW401", message, need.places[0])
            yield Discrepancy(enclave.path, str(need), finding, related=tuple(related))
    for right in DISCOVERY:
        if judge(right).verdict is not Verdict.ALLOWED:
            message = f"{right} is not allowed, but every process that runs on DDS needs it"
            finding = Finding("RW401", message, enclave.place)
            yield Discrepancy(enclave.path, str(right), finding, in_policy=True, related=tuple(_nodes(wanted)))


def _has_a_rule(need: Need) -> bool:
    """Whether policy.xml can express it: it has no words for topics outside the ROS name space (RW305)."""
    return any(right.name.startswith(_ROS_PREFIXES) for right in need.rights)


def _message(need: Need, short: list[tuple[Right, Judgement]]) -> str:
    refused = any(said.verdict is Verdict.REFUSED for _, said in short)
    open_ = "*" in need.name
    verb = "is not allowed" if refused else "may be missing: no rule allows everything that the name may stand for"
    parts = [f"{need} {verb}"]
    parts += [f"denied by {rule} ({rule.place})" for rule in _denials(short)]
    if len(short) < len(need.rights):
        parts.append(f"missing on DDS: {', '.join(str(right) for right, _ in short)}")
    if need.conditional and not open_:
        parts.append("it is created only in some executions")
    return f"{'; '.join(parts)} (node {_several(need.nodes)}{_more_places(need.places)})"


def _denials(short: list[tuple[Right, Judgement]]) -> list[PolicyRule]:
    """The rules that take the rights away."""
    return list(dict.fromkeys(said.rule for _, said in short if said.rule is not None and not said.rule.allow))


def _nodes(wanted: EnclaveNeeds) -> list[Related]:
    """Where the nodes of an enclave are in the sources."""
    return [
        Related(f"node {node.display_name} runs in this enclave", node.defined_at, in_policy=False)
        for node in wanted.nodes[:_MOST_PLACES]
    ]


def _superfluous(enclave: EnclavePolicy, needs: list[Need], nodes: list[Related]) -> Iterator[Discrepancy]:
    if enclave.default_allow:
        message = "<default>ALLOW</default> allows everything that no rule denies"
        yield Discrepancy(enclave.path, "default ALLOW", Finding("RW402", message, enclave.place), True, tuple(nodes))
    used = _Used(needs)
    judge = Judge(enclave)
    for rule in enclave.rules:
        if not rule.allow or not any(_effective(judge, right) for right in rule.rights):
            continue
        of = f" in profile {rule.profile}" if rule.profile else ""
        white = " (the white space is part of the name)" if rule.name != rule.name.strip() or " " in rule.name else ""
        related = nodes
        if not any(used.may_use(right) for right in rule.rights):
            message = f"{rule}{of} is allowed but never used{white}"
        elif not all(used.covers(right) for right in rule.rights):
            through = used.through(rule)
            message = f"{rule}{of} allows more than is used: {_several(through)}"
            related = _of_needs([n for n in needs if str(n) in through]) or nodes
        else:
            continue
        finding = Finding("RW402", message, rule.place)
        yield Discrepancy(enclave.path, str(rule), finding, in_policy=True, related=tuple(related))


def _of_needs(needs: list[Need]) -> list[Related]:
    """Where the sources use what a rule allows."""
    places = [(need, place) for need in needs for place in need.places]
    return [Related(f"{need} is created here", place, in_policy=False) for need, place in places[:_MOST_PLACES]]


def _effective(judge: Judge, right: Right) -> bool:
    """Whether the rule of that right has any effect: no denial takes all of it away."""
    return judge(right).verdict is not Verdict.REFUSED


@final
class _Used:
    """The rights that an enclave needs, ready to be asked for."""

    def __init__(self, needs: Iterable[Need]) -> None:
        pairs = {right: str(need) for need in needs for right in need.rights}
        pairs.update((right, right.name) for right in DISCOVERY)
        self._exact = frozenset(right for right in pairs if "*" not in right.name)
        self._names = {d: [(Pattern(r.name), n) for r, n in pairs.items() if r.direction is d] for d in Direction}
        self._wild = {d: [p for p, _ in self._names[d] if p.wild] for d in Direction}

    def may_use(self, right: Right) -> bool:
        if right in self._exact:
            return True
        pattern = Pattern(right.name)
        if not pattern.wild:
            return any(p.matches(right.name) for p in self._wild[right.direction])
        return any(pattern.meets(p) for p, _ in self._names[right.direction])

    def covers(self, right: Right) -> bool:
        """Whether all of a right is used; a right without a pattern is used as a whole or not at all."""
        pattern = Pattern(right.name)
        if not pattern.wild:
            return self.may_use(right)
        return any(p.covers(pattern) for p in self._wild[right.direction])

    def through(self, rule: PolicyRule) -> list[str]:
        """The needs that the rule fulfils, in words."""
        return sorted(
            {
                need
                for right in rule.rights
                for pattern, need in self._names[right.direction]
                if Pattern(right.name).meets(pattern)
            }
        )


def _several(names: Iterable[str]) -> str:
    return listed(sorted(set(names)), 3)


def _more_places(places: tuple[Place, ...]) -> str:
    return f"; also at {_several(str(place) for place in places[1:])}" if len(places) > 1 else ""
