# SPDX-License-Identifier: Apache-2.0
"""The answer of `rosward explain`, for a program: schema in `schemas/explain.schema.json`."""

from __future__ import annotations

from rosward.explanation.answers import Answer
from rosward.outputs.documents.json_text import json_text, plain


def explain_json(answer: Answer) -> str:
    """Return the whole answer, with nothing left out."""
    document = {"schema_version": 1, **plain(answer)}
    return json_text(document, default=str)
