# SPDX-License-Identifier: Apache-2.0
"""The differences of two states, for a program: schema in `schemas/diff.schema.json`."""

from __future__ import annotations

from typing import Final

from rosward.diff.compare import Differences, RightLine
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import header, place_row

_SCHEMA_VERSION: Final = 1


def diff_json(differences: Differences) -> str:
    """`{"nodes": {"gained": […], "lost": […]}, "entities": …, "rights": …}`."""
    nodes, entities, rights, notes, _ = differences
    document = {
        **header(_SCHEMA_VERSION),
        "nodes": {"gained": nodes.gained, "lost": nodes.lost},
        "entities": {
            "gained": [e._asdict() for e in entities.gained],
            "lost": [e._asdict() for e in entities.lost],
        },
        "rights": {"gained": [_right(r) for r in rights.gained], "lost": [_right(r) for r in rights.lost]},
        "notes": notes,
    }
    return json_text(document)


def _right(line: RightLine) -> dict[str, object]:
    return {"enclave": line.enclave, "words": line.words, "name": line.name, **place_row(line.place)}
