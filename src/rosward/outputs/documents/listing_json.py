# SPDX-License-Identifier: Apache-2.0
"""What there is of one kind, for a program: schema in `schemas/list.schema.json`."""

from __future__ import annotations

from collections.abc import Sequence

from rosward.explanation.listing import Row
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import header


def listing_json(rows: Sequence[Row], kind: str) -> str:
    """Return the rows of one kind as a document."""
    document = {
        **header(1),
        "kind": kind,
        "rows": [dict(row) for row in rows],
    }
    return json_text(document)
