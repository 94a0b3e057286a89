# SPDX-License-Identifier: Apache-2.0
"""The findings as annotations of a run on GitHub: one workflow command a line.

    ::warning file=src/talker.py,line=20,col=9,title=RW102 partly known name::publisher /*/state: …

Whoever runs them sees them in the change itself, one for each cause. What is in the baseline, or ignored, is not told.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.one_cause import OneCause, alike, more_of
from rosward.outputs.writing import Scan
from rosward.rules import Severity
from rosward.safe import printable
from rosward.suppression.judge import Judged

__all__ = ["github_commands", "text"]

_COMMANDS: Final = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}


def text(scan: Scan) -> str:
    """The document of the format `github`."""
    return github_commands(scan.findings)


def github_commands(findings: Iterable[Judged]) -> str:
    """The commands, errors first: GitHub shows ten of each kind for a step."""
    groups = alike((j for j in findings if not j.known), lambda j: j.finding)
    return "".join(_command(*group) for group in sorted(groups, key=lambda g: g[0].finding.rule.severity.rank))


def _command(judged: Judged, *also: Judged) -> str:
    finding = judged.finding
    more = more_of(OneCause(finding, tuple(j.finding for j in also)))
    message = f"{finding.message} (and {more})" if more else finding.message
    properties = {"title": f"{finding.code} {finding.rule.title}"}
    if judged.file:
        properties = {"file": judged.file, **properties}
    if judged.file and finding.place.line:
        at = {"line": str(finding.place.line), "col": str(max(finding.place.column, 1))}
        properties = {"file": judged.file, **at, "title": properties["title"]}
    told = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
    return f"::{_COMMANDS[finding.rule.severity]} {told}::{_data(message)}\n"


def _data(text: str) -> str:
    return printable(text).replace("%", "%25")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
