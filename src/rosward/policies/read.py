# SPDX-License-Identifier: Apache-2.0
"""What do several files say together: policies of SROS2 and permissions of DDS?

    read_policy(["base.policy.xml", "arm.policy.xml"])  ->  Policy with the enclaves of both

An enclave in several files has the rules of all, the denials of policies first, as if sros2 had merged them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Final

from rosward.findings import Finding
from rosward.policies.document import read_document
from rosward.policies.match import LONGEST_NAME, is_pattern
from rosward.policies.permissions import read_permissions
from rosward.policies.records import EnclavePolicy, Policy, PolicyRule
from rosward.policies.sros2 import read_sros2

__all__ = ["read_policy"]

_MOST_PATTERNS: Final = 1_000
"""Names with a wildcard in all files together, so that comparing them stays a matter of seconds."""


def read_policy(files: Sequence[str]) -> Policy:
    """The enclaves of all files, sorted by path. What is not understood is a finding; nothing is raised."""
    reading = _Reading()
    for file in files:
        root, findings = read_document(file)
        reading.findings += findings
        if root is None:
            continue
        if root.tag == "policy":
            enclaves, findings = read_sros2(root)
            reading.findings += findings
        elif root.tag == "dds":
            enclaves, findings, notes = read_permissions(root)
            reading.findings += findings
            reading.notes += notes
        else:
            message = f"<{root.tag}> is neither an SROS2 policy (<policy>) nor DDS permissions (<dds>)."
            reading.findings.append(Finding("RW403", message, root.place))
            continue
        for enclave in enclaves:
            reading.add(enclave)
    ordered = tuple(reading.enclaves[path] for path in sorted(reading.enclaves))
    return Policy(ordered, tuple(reading.findings), tuple(reading.notes))


@dataclass
class _Reading:
    enclaves: dict[str, EnclavePolicy] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    patterns: int = 0

    def add(self, enclave: EnclavePolicy) -> None:
        enclave = enclave._replace(rules=tuple(self._understood(enclave.rules)))
        before = self.enclaves.get(enclave.path)
        self.enclaves[enclave.path] = enclave if before is None else _merged(before, enclave)

    def _understood(self, rules: Iterable[PolicyRule]) -> Iterable[PolicyRule]:
        for rule in rules:
            self.patterns += is_pattern(rule.name)
            if len(rule.name) > LONGEST_NAME:
                self._tell(f"A name of more than {LONGEST_NAME} characters matches nothing on DDS.", rule)
            elif "[[:" in rule.name or "[[." in rule.name or "[[=" in rule.name:
                self._tell(f"The character class in {rule.name} could not be parsed.", rule)
            elif self.patterns > _MOST_PATTERNS and is_pattern(rule.name):
                self._tell("There are too many patterns before this one. It was not compared.", rule)
            else:
                yield rule

    def _tell(self, message: str, rule: PolicyRule) -> None:
        self.findings.append(Finding("RW403", message, rule.place))


def _merged(one: EnclavePolicy, other: EnclavePolicy) -> EnclavePolicy:
    rules = (*one.rules, *other.rules)
    return one._replace(
        rules=tuple(sorted(rules, key=lambda rule: rule.allow)) if other.adds_discovery else rules,
        profiles=(*one.profiles, *other.profiles),
        default_allow=one.default_allow or other.default_allow,
        adds_discovery=one.adds_discovery or other.adds_discovery,
    )
