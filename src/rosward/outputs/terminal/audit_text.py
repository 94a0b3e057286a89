# SPDX-License-Identifier: Apache-2.0
"""The comparison of what runs with the source, for a person: by node, each difference with its place; then what is no difference.

/talker
  error   RW502 src/talker.py:12  publisher /debug (std_msgs/msg/String) of /talker is not explained by the source

12 nodes run: 11 explained, 1 tool. The explained nodes have 140 entities: 139 explained.
1 running entity not explained.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rosward.audit.result import Audit, AuditCounts, Difference
from rosward.findings import Finding
from rosward.network.counts import listed, several, some
from rosward.rules import Severity
from rosward.safe import printable

__all__ = ["audit_text"]

_SHOWN = 6


def audit_text(audit: Audit, known: Collection[Finding] = (), doubts: Iterable[Finding] = ()) -> str:
    """The text. `known` are findings of the baseline, `doubts` those of the analysis that leave open what the source says."""
    new = [d for d in audit.differences if d.finding not in known]
    open_questions = [d for d in doubts if d.rule.severity is Severity.ERROR]
    lines: list[str] = []
    if audit.findings:
        lines += ["not read", *(_line(f) for f in audit.findings), ""]
    groups: dict[str, list[Difference]] = {}
    for one in new:
        groups.setdefault(one.node or "no node", []).append(one)
    for node, differences in groups.items():
        lines += [node, *(_line(d.finding) + _looks(d.seen, audit.looks) for d in differences), ""]
    lines += _section("not seen, expected only in some runs", _unseen(audit))
    lines += _section(
        "tools", [f"{t.node}  {t.tool}, {several(t.entities, 'entity', 'entities')}" for t in audit.tools]
    )
    lines += _section(
        "explained only by the name of the node, whose interface is unknown",
        [f"{u.node} {u.place}  {listed(u.entities, _SHOWN)}" for u in audit.unjudged],
    )
    if open_questions:
        lines += ["unknown about the code", *(_line(f) for f in open_questions), ""]
    lines += _summary(audit, len(audit.differences) - len(new))
    lines.append(_verdict(audit, new))
    return "\n".join(printable(line) for line in lines) + "\n"


def _section(title: str, lines: Sequence[str]) -> list[str]:
    return [title, *(f"  {line}" for line in lines), ""] if lines else []


def _line(finding: Finding) -> str:
    place = f"{finding.place}  " if finding.place.file else " "
    return f"  {finding.rule.severity.value:7} {finding.code} {place}{finding.message}"


def _looks(seen: int, looks: int) -> str:
    return f" (seen in {seen} of {looks} looks)" if 0 < seen < looks else ""


def _unseen(audit: Audit) -> list[str]:
    groups: dict[str, list[str]] = {}
    for one in audit.unseen:
        of = groups.setdefault(one.node, [])
        of.append(f"{one.entity or 'the node itself'} ({one.place})")
    return [f"{node}  {listed(entities, _SHOWN)}" for node, entities in groups.items()]


def _summary(audit: Audit, known: int) -> list[str]:
    tools = f", {several(len(audit.tools), 'tool', 'tools')}" if audit.tools else ""
    parts = [f"{_counted(audit.nodes, 'node runs', 'nodes run')}{tools}."]
    if audit.entities.running:
        has = "The explained node has" if audit.nodes.exact + audit.nodes.pattern == 1 else "The explained nodes have"
        parts.append(f"{has} {_counted(audit.entities, 'entity', 'entities')}.")
    beside = [
        some(audit.accepted, "is accepted", "are accepted"),
        some(known, "is in the baseline", "are in the baseline"),
        some(audit.untold, "expected node is not in the input", "expected nodes are not in the input"),
    ]
    told = [part for part in beside if part]
    if told:
        parts.append(f"{', '.join(told)}.")
    return [" ".join(parts)]


def _counted(counts: AuditCounts, one: str, many: str) -> str:
    explained = f"{counts.exact + counts.pattern} explained"
    through = f" ({counts.pattern} by a pattern)" if counts.pattern else ""
    return f"{several(counts.running, one, many)}: {explained}{through}"


def _verdict(audit: Audit, new: Sequence[Difference]) -> str:
    count = {code: sum(d.finding.code == code for d in new) for code in ("RW501", "RW502", "RW503", "RW504", "RW506")}
    parts = [
        some(count["RW501"], "unexplained running node", "unexplained running nodes"),
        some(count["RW502"], "unexplained running entity", "unexplained running entities"),
        some(count["RW503"], "expected but not running", "expected but not running"),
        some(count["RW504"], "with a different type or QoS", "with a different type or QoS"),
        some(count["RW506"], "explained only by an unknown name", "explained only by unknown names"),
        some(len(audit.findings), "unreadable part", "unreadable parts"),
    ]
    said = ", ".join(part for part in parts if part)
    return f"{said}." if said else "The source explains everything that runs, and everything it expects is running."
