# SPDX-License-Identifier: Apache-2.0
"""How is a document written as JSON? Whatever the sources put into its texts, it is JSON and UTF-8."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Any, Final

from rosward.location import Place
from rosward.outputs.documents.rows import place_row
from rosward.ros.flows import End
from rosward.safe import json_escaped

__all__ = ["json_text", "plain"]

_quoted: Final = json.encoder.encode_basestring


def json_text(document: object, default: Callable[[Any], object] | None = None) -> str:
    """The document, indented, with a line end. Lone surrogates, which UTF-8 cannot hold, and what cannot be seen become escapes."""
    return json_escaped(_indented(document, "\n", default)) + "\n"


def _indented(value: Any, line: str, default: Callable[[Any], object] | None) -> str:
    """The text that `json.dumps` gives with an indent of 2, in half its time; `line` begins a line around the value."""
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, dict):
        if not value:
            return "{}"
        inner = line + "  "
        parts = []
        for key, item in value.items():
            name = _quoted(key) if key.__class__ is str else _key(key)
            if item.__class__ is str:  # most are: that is worth a line here
                parts.append(f"{name}: {_quoted(item)}")
            else:
                parts.append(f"{name}: {_indented(item, inner, default)}")
        return f"{{{inner}{f',{inner}'.join(parts)}{line}}}"
    if isinstance(value, (list, tuple)):
        if not value:
            return "[]"
        inner = line + "  "
        return f"[{inner}{f',{inner}'.join([_indented(item, inner, default) for item in value])}{line}]"
    if value.__class__ is int:
        return str(value)
    if value is None:
        return "null"
    if value.__class__ is bool:
        return "true" if value else "false"
    if isinstance(value, (bool, int, float)) or default is None:
        return json.dumps(value, allow_nan=False)
    return _indented(default(value), line, default)


def _key(key: object) -> str:
    return _quoted(key) if isinstance(key, str) else json.dumps(json.dumps(key, allow_nan=False))


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
