# SPDX-License-Identifier: Apache-2.0
"""How is a document written as JSON? Whatever the sources put into its texts, it is JSON and UTF-8."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from rosward.safe import json_escaped

__all__ = ["json_text"]


def json_text(document: object, default: Callable[[Any], object] | None = None) -> str:
    """The document, indented, with a line end. Lone surrogates, which UTF-8 cannot hold, and what cannot be seen become escapes."""
    return json_escaped(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False, default=default)) + "\n"
