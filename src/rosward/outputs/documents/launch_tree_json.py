# SPDX-License-Identifier: Apache-2.0
"""What launch files start, for a program: schema in `schemas/launch-tree.schema.json`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rosward.findings import Finding
from rosward.network.launch_tree import LaunchSystem
from rosward.outputs.documents.json_text import json_text, plain
from rosward.outputs.documents.rows import finding_row


def launch_tree_json(systems: Iterable[LaunchSystem], findings: Sequence[Finding]) -> str:
    """Return a list of systems with their entries in the order of their start, and the findings."""
    document = {
        "schema_version": 1,
        "systems": [
            {"name": s.name, "file": s.file, "entries": [plain(e._asdict()) for e in s.entries]} for s in systems
        ],
        "diagnostics": [{**finding_row(f), "column": f.place.column} for f in findings],
    }
    return json_text(document)
