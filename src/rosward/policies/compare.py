# SPDX-License-Identifier: Apache-2.0
"""Does a policy let each process do what its code does, and nothing else?

    needed publisher /chatter, no rule for it         ->  RW401, at talker.py:7
    a rule for /debug, which no code of the enclave uses  ->  RW402, at policy.xml:12

A right counts as used as soon as a name that is only known in part may be its name, so nothing is called superfluous that may be used.
A rule with a pattern is told where it also allows names that nobody uses.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple, final

from rosward.findings import Finding
from rosward.network.graph import Network
from rosward.policies.judge import Judge, Judgement, Verdict
from rosward.policies.match import Pattern
from rosward.policies.needs import EnclaveNeeds, Need, needs_of
from rosward.policies.records import EnclavePolicy, Policy, PolicyRule
from rosward.policies.rights import DISCOVERY, Direction, Right
from rosward.source.location import Place

__all__ = ["Discrepancy", "compare"]


class Discrepancy(NamedTuple):
    """One difference in one enclave; `right` is what lacks or is too much, '' where the enclave itself is."""

    enclave: str
    right: str
    finding: Finding


def compare(network: Network, policy: Policy) -> tuple[Discrepancy, ...]:
    """Every difference, sorted by enclave and code."""
    by_path = {enclave.path: enclave for enclave in policy.enclaves}
    found: list[Discrepancy] = []
    needed: dict[str, list[Need]] = {}
    for wanted in needs_of(network.nodes):
        chosen = _candidates(wanted, by_path)
        if not chosen:
            found.append(_without_enclave(wanted))
        for enclave in chosen:
            found += _lacking(enclave, wanted)
            needed.setdefault(enclave.path, []).extend(wanted.needs)
    for enclave in policy.enclaves:
        if enclave.path in needed:
            found += _superfluous(enclave, needed[enclave.path])
        else:
            message = f"no process of the sources runs in enclave {enclave.path}"
            found.append(Discrepancy(enclave.path, "", Finding("RW404", message, enclave.place)))
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
    message = (
        f"the policy has no enclave {wanted.path}, in which {processes} runs ({_several(n.fqn for n in wanted.nodes)})"
    )
    return Discrepancy(wanted.path, "", Finding("RW405", message, node.launched_by or node.defined_at))


def _lacking(enclave: EnclavePolicy, wanted: EnclaveNeeds) -> Iterator[Discrepancy]:
    judge = Judge(enclave)
    for need in wanted.needs:
        judged = [(right, judge(right)) for right in need.rights]
        short = [(right, said) for right, said in judged if said.verdict is not Verdict.ALLOWED]
        if short:
            message = _told(need, short)
            yield Discrepancy(enclave.path, str(need), Finding("RW401", message, need.places[0]))
    for right in DISCOVERY:
        if judge(right).verdict is not Verdict.ALLOWED:
            message = f"{right} is not allowed, which every process needs that runs on DDS"
            yield Discrepancy(enclave.path, str(right), Finding("RW401", message, enclave.place))


def _told(need: Need, short: list[tuple[Right, Judgement]]) -> str:
    refused = any(said.verdict is Verdict.REFUSED for _, said in short)
    open_ = "*" in need.name
    verb = "is not allowed" if refused else "may be lacking: no rule allows all that the name may be"
    rules = dict.fromkeys(said.rule for _, said in short if said.rule is not None and not said.rule.allow)
    parts = [f"{need} {verb}"]
    parts += [f"denied by {rule} ({rule.place})" for rule in rules]
    if len(short) < len(need.rights):
        parts.append(f"of its rights on DDS lacks {', '.join(str(right) for right, _ in short)}")
    if need.conditional and not open_:
        parts.append("it is created in some executions only")
    return f"{'; '.join(parts)} (node {_several(need.nodes)}{_more_places(need.places)})"


def _superfluous(enclave: EnclavePolicy, needs: list[Need]) -> Iterator[Discrepancy]:
    if enclave.default_allow:
        message = "<default>ALLOW</default> allows everything that no rule denies"
        yield Discrepancy(enclave.path, "default ALLOW", Finding("RW402", message, enclave.place))
    used = _Used(needs)
    judge = Judge(enclave)
    for rule in enclave.rules:
        if not rule.allow or not any(_effective(judge, right) for right in rule.rights):
            continue
        of = f" in profile {rule.profile}" if rule.profile else ""
        white = " (the white space belongs to the name)" if rule.name != rule.name.strip() or " " in rule.name else ""
        if not any(used.may_use(right) for right in rule.rights):
            message = f"{rule}{of} is allowed, and never used{white}"
        elif not all(used.covers(right) for right in rule.rights):
            message = f"{rule}{of} allows more than is used: {_several(used.through(rule))}"
        else:
            continue
        yield Discrepancy(enclave.path, str(rule), Finding("RW402", message, rule.place))


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
    ordered = sorted(set(names))
    return ", ".join(ordered[:3]) + (f" and {len(ordered) - 3} more" if len(ordered) > 3 else "")


def _more_places(places: tuple[Place, ...]) -> str:
    return f"; also at {_several(str(place) for place in places[1:])}" if len(places) > 1 else ""
