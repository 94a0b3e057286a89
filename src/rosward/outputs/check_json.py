# SPDX-License-Identifier: Apache-2.0
"""The comparison of a policy with the code, for a program.

    {"schema_version": 1, "generator": {…}, "clean": false, "enclaves": [{"path": "/talker", "findings": […]}], "policy": [], "code": [], "notes": []}

`policy` holds what could not be read of the policy, `code` what is not known of the code.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Final

from rosward._version import __version__
from rosward.findings import Finding, Severity
from rosward.outputs.safe import encodable
from rosward.policies.compare import Discrepancy
from rosward.policies.records import Policy

__all__ = ["check_json"]

_SCHEMA_VERSION: Final = 1


def check_json(policy: Policy, discrepancies: Sequence[Discrepancy], doubts: Iterable[Finding] = ()) -> str:
    """The text of the document. `doubts` are findings of the analysis that leave open what the code needs."""
    open_questions = [_finding(d) for d in doubts if d.rule.severity is Severity.ERROR]
    paths = sorted({*(e.path for e in policy.enclaves), *(d.enclave for d in discrepancies)})
    document = {
        "schema_version": _SCHEMA_VERSION,
        "generator": {"name": "rosward", "version": __version__},
        "clean": not (discrepancies or policy.findings or open_questions),
        "enclaves": [
            {
                "path": path,
                "findings": [
                    {**_finding(d.finding), "right": d.right or None} for d in discrepancies if d.enclave == path
                ],
            }
            for path in paths
        ],
        "policy": [_finding(f) for f in policy.findings],
        "code": open_questions,
        "notes": list(policy.notes),
    }
    return encodable(json.dumps(document, indent=2, ensure_ascii=False)) + "\n"


def _finding(finding: Finding) -> dict[str, object]:
    return {
        "code": finding.code,
        "severity": finding.rule.severity.value,
        "message": finding.message,
        "file": finding.place.file,
        "line": finding.place.line,
    }
