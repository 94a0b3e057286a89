# SPDX-License-Identifier: Apache-2.0
"""What there is of one kind, for a program: schema in `schemas/list.schema.json`."""

from __future__ import annotations

from collections.abc import Sequence

from rosward._version import __version__
from rosward.explanation.listing import Row
from rosward.outputs.documents.json_text import json_text


def listing_json(rows: Sequence[Row], kind: str) -> str:
    """Return the rows of one kind as a document."""
    document = {
        "schema_version": 1,
        "generator": {"name": "rosward", "version": __version__},
        "kind": kind,
        "rows": [dict(row) for row in rows],
    }
    return json_text(document)
