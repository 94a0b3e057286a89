# SPDX-License-Identifier: Apache-2.0
"""The comparison of what runs with the source, for a program: version 1, schema in `schemas/audit.schema.json`.

{"schema_version": 1, "generator": {…}, "clean": false, "looks": 10, "differences": [{"node": "/talker", "code": "RW502", …}], …}
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Final

from rosward.audit.result import Audit, AuditCounts
from rosward.findings import Finding
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import finding_row, header, place_row
from rosward.rules import Severity

__all__ = ["audit_json"]

_SCHEMA_VERSION: Final = 1


def audit_json(audit: Audit, known: Collection[Finding] = (), doubts: Iterable[Finding] = ()) -> str:
    """The text of the document. `known` are findings of the baseline, `doubts` those of the analysis that leave open what the source says."""
    document = {
        **header(_SCHEMA_VERSION),
        "clean": not audit.findings and all(d.finding in known for d in audit.differences),
        "source": audit.source or None,
        "looks": audit.looks,
        "nodes": _counts(audit.nodes),
        "entities": _counts(audit.entities),
        "accepted": audit.accepted,
        "nodes_not_told": audit.untold,
        "differences": [
            {
                "node": d.node or None,
                "entity": d.entity or None,
                "seen": d.seen,
                "known": d.finding in known,
                **finding_row(d.finding),
            }
            for d in audit.differences
        ],
        "unseen": [{"node": u.node, "entity": u.entity or None, **place_row(u.place)} for u in audit.unseen],
        "tools": [tool._asdict() for tool in audit.tools],
        "by_node_name_only": [
            {"node": u.node, "entities": list(u.entities), **place_row(u.place)} for u in audit.unjudged
        ],
        "not_read": [finding_row(f) for f in audit.findings],
        "code": [finding_row(f) for f in doubts if f.rule.severity is Severity.ERROR],
    }
    return json_text(document)


def _counts(counts: AuditCounts) -> dict[str, int]:
    return {"running": counts.running, "explained": counts.exact + counts.pattern, "by_pattern": counts.pattern}
