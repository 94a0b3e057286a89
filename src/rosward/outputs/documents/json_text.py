# SPDX-License-Identifier: Apache-2.0
"""How is a document written as JSON? Whatever the sources put into its texts, it is JSON and UTF-8."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Any

from rosward.outputs.documents.rows import place_row
from rosward.ros.flows import End
from rosward.safe import json_escaped
from rosward.source.location import Place

__all__ = ["json_text", "plain"]


def json_text(document: object, default: Callable[[Any], object] | None = None) -> str:
    """The document, indented, with a line end. Lone surrogates, which UTF-8 cannot hold, and what cannot be seen become escapes."""
    return json_escaped(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False, default=default)) + "\n"


def plain(value: Any) -> Any:
    """Return a record as JSON has it: objects for named tuples, lists for sequences, `{"file", "line"}` for places, texts for ends of flows."""
    if isinstance(value, Place):
        return place_row(value)
    if isinstance(value, End):
        return str(value)
    if hasattr(value, "_asdict"):
        return {key: plain(each) for key, each in value._asdict().items()}
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)  # JSON has no such number
    return [plain(each) for each in value] if isinstance(value, (tuple, list)) else value
