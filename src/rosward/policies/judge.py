# SPDX-License-Identifier: Apache-2.0
"""Does an enclave grant a right?

    deny publish rt/robot_7/cmd, allow publish rt/robot_*/cmd
      publish rt/robot_1/cmd -> allowed      publish rt/robot_7/cmd -> refused      publish rt/*/cmd -> in part

The rules are tried in order, and the first that matches decides. A right whose name is a pattern is allowed only where one rule
covers the whole pattern, and no rule before it denies a part.
"""

from __future__ import annotations

import enum
from typing import final

from rosward.policies.match import Pattern
from rosward.policies.records import EnclavePolicy, PolicyRule
from rosward.policies.rights import DISCOVERY, Direction, Right
from rosward.records import NamedTuple

__all__ = ["Judge", "Judgement", "Verdict"]


class Verdict(enum.Enum):
    """What an enclave says of a right."""

    ALLOWED = "allowed"
    REFUSED = "refused"
    IN_PART = "in part"


class Judgement(NamedTuple):
    """A verdict, and the rule that decides, if one does."""

    verdict: Verdict
    rule: PolicyRule | None = None


class _OrderedRule(NamedTuple):
    order: int
    pattern: Pattern
    rule: PolicyRule


@final
class Judge:
    """The rules of one enclave, ready to be asked."""

    def __init__(self, enclave: EnclavePolicy) -> None:
        self._default = Verdict.ALLOWED if enclave.default_allow else Verdict.REFUSED
        self._added = frozenset(DISCOVERY) if enclave.adds_discovery else frozenset()
        self._exact: dict[Right, _OrderedRule] = {}
        self._wild: dict[Direction, list[_OrderedRule]] = {d: [] for d in Direction}
        self._all: dict[Direction, list[_OrderedRule]] = {d: [] for d in Direction}
        for order, rule in enumerate(enclave.rules):
            for right in rule.rights:
                entry = _OrderedRule(order, Pattern(right.name), rule)
                self._all[right.direction].append(entry)
                if entry.pattern.wild:
                    self._wild[right.direction].append(entry)
                else:
                    self._exact.setdefault(right, entry)

    def __call__(self, right: Right) -> Judgement:
        """What the rules say of one right."""
        if right in self._added:
            return Judgement(Verdict.ALLOWED)
        wanted = Pattern(right.name)
        return self._of_pattern(right.direction, wanted) if wanted.wild else self._of_name(right)

    def _of_name(self, right: Right) -> Judgement:
        first = self._exact.get(right)
        for entry in self._wild[right.direction]:
            if first is not None and entry.order >= first.order:
                break
            if entry.pattern.matches(right.name):
                first = entry
                break
        if first is None:
            return Judgement(self._default)
        return Judgement(Verdict.ALLOWED if first.rule.allow else Verdict.REFUSED, first.rule)

    def _of_pattern(self, direction: Direction, wanted: Pattern) -> Judgement:
        """Parts that are decided before make the verdict that of a part, unless all say the same."""
        parts: list[_OrderedRule] = []
        verdict, rule = self._default, None
        for entry in self._all[direction]:
            if not entry.pattern.meets(wanted):
                continue
            if entry.pattern.covers(wanted):
                verdict, rule = (Verdict.ALLOWED if entry.rule.allow else Verdict.REFUSED), entry.rule
                break
            parts.append(entry)
        for entry in parts:
            if entry.rule.allow is not (verdict is Verdict.ALLOWED):
                return Judgement(Verdict.IN_PART, entry.rule)
        return Judgement(verdict, rule)
