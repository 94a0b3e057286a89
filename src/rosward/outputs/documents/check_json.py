# SPDX-License-Identifier: Apache-2.0
"""The comparison of a policy with the code, for a program.

    {"schema_version": 1, "generator": {…}, "clean": false, "enclaves": [{"path": "/talker", "findings": […]}], "policy": [], "code": [], "notes": []}

`policy` holds what could not be read of the policy, `code` what is not known of the code. The form is schemas/check.schema.json.
"""

from __future__ import annotations

from typing import Final

from rosward.explanation.checked import Checked
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import finding_row, header
from rosward.suppression.judge import Judged

__all__ = ["check_json"]

_SCHEMA_VERSION: Final = 1


def check_json(found: Checked) -> str:
    """The text of the document."""
    paths = sorted({*(e.path for e in found.policy.enclaves), *(d.enclave for d in found.differences)})
    document = {
        **header(_SCHEMA_VERSION),
        "clean": found.clean,
        "enclaves": [
            {
                "path": path,
                "findings": [
                    {**_finding(d.judged), "right": d.right or None} for d in found.differences if d.enclave == path
                ],
            }
            for path in paths
        ],
        "policy": [_finding(j) for j in found.unread],
        "code": [_finding(j) for j in found.questions],
        "notes": list(found.policy.notes),
        "ignored": found.ignored,
    }
    return json_text(document)


def _finding(judged: Judged) -> dict[str, object]:
    return {
        **finding_row(judged.finding),
        "fingerprint": judged.fingerprint,
        "known": judged.known,
        "related": [{"message": r.message, "file": r.file, "line": r.line} for r in judged.related],
    }
