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
    lines += _section("unknown about the code", found.questions)
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
        some(new.count("RW401"), "missing permission", "missing permissions"),
        some(new.count("RW402"), "unused permission", "unused permissions"),
        some(new.count("RW404"), "enclave without a process", "enclaves without a process"),
        some(new.count("RW405"), "process without an enclave", "processes without an enclave"),
        some(_new(found.unread), "unreadable part of the policy", "unreadable parts of the policy"),
        some(_new(found.questions), "open question about the code", "open questions about the code"),
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
    clean = f"Clean: {number} {'enclave allows its process' if number == 1 else 'enclaves allow their processes'} exactly what the code does"
    return f"{clean}{''.join(f', {part}' for part in aside)}."


def _new(judged: Iterable[Judged]) -> int:
    return sum(not j.known for j in judged)
