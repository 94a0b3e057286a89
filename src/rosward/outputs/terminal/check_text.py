# SPDX-License-Identifier: Apache-2.0
"""The comparison of a policy with the code, for a person: by enclave, what lacks first, each with its place.

/talker
  error   RW401 src/talker.py:7   publisher /chatter is not allowed (node /talker)
  warning RW402 policy.xml:12     topics publish /debug in profile /talker is allowed, and never used

1 right lacking, 1 rule too much.

What is in the baseline is counted, and not listed.
"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.explanation.checked import Checked
from rosward.network.counts import some
from rosward.safe import printable
from rosward.suppression.judge import Judged

__all__ = ["check_text"]


def check_text(found: Checked) -> str:
    """The text."""
    lines = _section("not read", found.unread)
    groups: dict[str, list[Judged]] = {}
    for one in found.differences:
        groups.setdefault(one.enclave, []).append(one.judged)
    for enclave, judged in groups.items():
        lines += _section(enclave, judged)
    lines += _section("not known of the code", found.questions)
    lines += [f"note: {note}" for note in found.policy.notes]
    lines.append(_verdict(found))
    return "\n".join(printable(line) for line in lines) + "\n"


def _section(title: str, judged: Iterable[Judged]) -> list[str]:
    new = [j.finding for j in judged if not j.known]
    lines = [f"  {f.rule.severity.value:7} {f.code} {f.place}  {f.message}" for f in new]
    return [title, *lines, ""] if lines else []


def _verdict(found: Checked) -> str:
    new = [d.judged.finding.code for d in found.differences if not d.judged.known]
    parts = [
        some(new.count("RW401"), "right lacking", "rights lacking"),
        some(new.count("RW402"), "rule too much", "rules too much"),
        some(new.count("RW404"), "enclave of no process", "enclaves of no process"),
        some(new.count("RW405"), "process without enclave", "processes without enclave"),
        some(_new(found.unread), "part of the policy not read", "parts of the policy not read"),
        some(_new(found.questions), "question about the code open", "questions about the code open"),
    ]
    aside = [
        f"{number} {word}" for number, word in ((found.ignored, "ignored"), (found.known, "in the baseline")) if number
    ]
    said = ", ".join(part for part in parts if part)
    if said and not new and not _new(found.unread):
        said = f"No difference as far as the code is known: {said}"
    if said:
        return f"{', '.join([said, *aside])}."
    if found.known:
        return f"Nothing new: {', '.join(aside)}."
    number = len(found.policy.enclaves)
    clean = f"Clean: {number} {'enclave lets its process' if number == 1 else 'enclaves let their processes'} do what the code does, and no more"
    return f"{clean}{''.join(f', {part}' for part in aside)}."


def _new(judged: Iterable[Judged]) -> int:
    return sum(not j.known for j in judged)
