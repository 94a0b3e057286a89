# SPDX-License-Identifier: Apache-2.0
"""The findings as code scanning services read them: SARIF 2.1.0.

    {"ruleId": "RW102", "level": "warning", "message": {"text": "…"}, "locations": [{… "uri": "src/talker.py" … "startLine": 20}]}

Paths are relative to the root of the repository, which SRCROOT stands for; where that is on this machine has no place in the file. What has
no place in a file (RW007) is a notification of the run, since services show results by file. What is there for one cause is one result with
related locations. With a baseline, each result says whether it is in it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Sequence
from typing import Final
from urllib.parse import quote

from rosward._version import __version__
from rosward.one_cause import OneCause, alike, more_of
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.writing import Scan
from rosward.rules import RULES, Rule
from rosward.safe import encodable
from rosward.suppression.judge import Judged, RelatedPlace

__all__ = ["sarif_json", "text"]

_SCHEMA: Final = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_ROOT: Final = "SRCROOT"
_FINGERPRINT: Final = "roswardFinding/v2"


def text(scan: Scan) -> str:
    """The document of the format `sarif`."""
    return sarif_json(scan.findings, baseline=scan.baseline, documentation=scan.documentation)


def sarif_json(findings: Sequence[Judged], *, baseline: bool = False, documentation: str | None = None) -> str:
    """The text of `findings.sarif`. `documentation` is the address of the page that docs/findings.md became, if it has one."""
    indices = {code: index for index, code in enumerate(RULES)}
    run: dict[str, object] = {
        "tool": {"driver": _driver(documentation)},
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {_ROOT: {"description": {"text": "The root of the repository."}}},
        "invocations": [
            {
                "executionSuccessful": True,
                "toolExecutionNotifications": [_notification(j) for j in findings if not j.file],
            }
        ],
        "results": [_result(group, indices, baseline) for group in _together(j for j in findings if j.file)],
    }
    document = {"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}
    return json_text(document)


def _driver(documentation: str | None) -> dict[str, object]:
    home = {} if documentation is None else {"informationUri": documentation}
    rules = [_rule(rule, documentation) for rule in RULES.values()]
    return {"name": "rosward", "version": __version__, "semanticVersion": __version__, **home, "rules": rules}


def _rule(rule: Rule, documentation: str | None) -> dict[str, object]:
    link = {} if documentation is None else {"helpUri": f"{documentation}#{rule.code.lower()}"}
    return {
        "id": rule.code,
        "shortDescription": {"text": rule.title},
        "fullDescription": {"text": f"{rule.title}. {rule.help}"},
        "help": {"text": rule.help},
        **link,
        "defaultConfiguration": {"level": rule.severity.value},
    }


def _together(findings: Iterable[Judged]) -> list[list[Judged]]:
    return alike(findings, lambda j: j.finding, lambda j: j.known)


def _result(group: list[Judged], indices: dict[str, int], baseline: bool) -> dict[str, object]:
    """What stands for the findings of one cause, all of their places in it."""
    judged, *others = group
    finding = judged.finding
    state = {"baselineState": "unchanged" if judged.known else "new"} if baseline else {}
    related = [
        {"id": number, "message": {"text": r.message}, **_location(r.file, r.line, r.column)}
        for number, r in enumerate([*judged.related, *_related(others)], 1)
    ]
    more = more_of(OneCause(finding, tuple(j.finding for j in others)))
    return {
        "ruleId": finding.code,
        "ruleIndex": indices[finding.code],
        "level": finding.rule.severity.value,
        "message": {"text": f"{finding.message} (and {more})" if more else finding.message},
        "locations": [_location(judged.file, finding.place.line, finding.place.column)],
        **({"relatedLocations": related} if related else {}),
        **({"codeFlows": [_code_flow(judged)]} if finding.path else {}),
        "partialFingerprints": {_FINGERPRINT: _fingerprint(group)},
        **state,
    }


def _code_flow(judged: Judged) -> dict[str, object]:
    """The lines that lead to the place, as one thread."""
    steps = [{"location": _location(p.file, p.line, p.column)} for p in judged.finding.path]
    return {"threadFlows": [{"locations": steps}]}


def _related(others: Iterable[Judged]) -> Iterator[RelatedPlace]:
    for j in others:
        yield RelatedPlace(
            f"{j.finding.code}: {j.finding.message}", j.file, j.finding.place.line, j.finding.place.column
        )
        yield from j.related


def _fingerprint(group: Sequence[Judged]) -> str:
    """That of the finding, or of all that are there for one cause: another one makes it a new result."""
    if len(group) == 1:
        return group[0].fingerprint
    return hashlib.sha256("\n".join(sorted(j.fingerprint for j in group)).encode()).hexdigest()


def _location(file: str, line: int, column: int) -> dict[str, object]:
    region = {"startLine": max(line, 1), **({"startColumn": max(column, 1)} if line else {})}
    return {"physicalLocation": {"artifactLocation": _artifact(file), "region": region}}


def _artifact(file: str) -> dict[str, str]:
    uri = quote(encodable(file), safe="/")
    return {"uri": f"file://{uri}"} if file.startswith("/") else {"uri": uri, "uriBaseId": _ROOT}


def _notification(judged: Judged) -> dict[str, object]:
    finding = judged.finding
    return {
        "level": finding.rule.severity.value,
        "message": {"text": finding.message},
        "descriptor": {"id": finding.code},
    }
