# SPDX-License-Identifier: Apache-2.0
"""The comparison of a policy with the code, for a person: by enclave, what lacks first, each with its place.

/talker
  error   RW401 src/talker.py:7   publisher /chatter is not allowed (node /talker)
  warning RW402 policy.xml:12     topics publish /debug in profile /talker is allowed, and never used

1 right is lacking, 1 is never used.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rosward.findings import Finding, Severity
from rosward.outputs.safe import printable
from rosward.policies.compare import Discrepancy
from rosward.policies.records import Policy

__all__ = ["check_text"]


def check_text(policy: Policy, discrepancies: Sequence[Discrepancy], doubts: Iterable[Finding] = ()) -> str:
    """The text. `doubts` are findings of the analysis that leave open what the code needs."""
    open_questions = [d for d in doubts if d.rule.severity is Severity.ERROR]
    lines: list[str] = []
    if policy.findings:
        lines += ["not read", *(_line(f) for f in policy.findings), ""]
    groups: dict[str, list[Finding]] = {}
    for one in discrepancies:
        groups.setdefault(one.enclave, []).append(one.finding)
    for enclave, findings in groups.items():
        lines += [enclave, *(_line(f) for f in findings), ""]
    if open_questions:
        lines += ["not known of the code", *(_line(f) for f in open_questions), ""]
    lines += [f"note: {note}" for note in policy.notes]
    lines.append(_verdict(policy, discrepancies, open_questions))
    return "\n".join(printable(line) for line in lines) + "\n"


def _line(finding: Finding) -> str:
    return f"  {finding.rule.severity.value:7} {finding.code} {finding.place}  {finding.message}"


def _verdict(policy: Policy, discrepancies: Sequence[Discrepancy], open_questions: list[Finding]) -> str:
    count = {code: sum(d.finding.code == code for d in discrepancies) for code in ("RW401", "RW402", "RW404", "RW405")}
    parts = [
        _several(count["RW401"], "right lacking", "rights lacking"),
        _several(count["RW402"], "rule too much", "rules too much"),
        _several(count["RW404"], "enclave of no process", "enclaves of no process"),
        _several(count["RW405"], "process without enclave", "processes without enclave"),
        _several(len(policy.findings), "part of the policy not read", "parts of the policy not read"),
        _several(len(open_questions), "question about the code open", "questions about the code open"),
    ]
    said = ", ".join(part for part in parts if part)
    if said:
        return f"{said}."
    number = len(policy.enclaves)
    return f"Clean: {number} {'enclave lets its process' if number == 1 else 'enclaves let their processes'} do what the code does, and no more."


def _several(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}" if number else ""
