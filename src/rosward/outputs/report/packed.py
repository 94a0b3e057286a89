# SPDX-License-Identifier: Apache-2.0
"""How does the page hold long texts in little room?

    packed("{…}")   ->  "eNq9…"     base64 of a zlib stream: letters that mean nothing to HTML
    unpacked("eNq9…")  ->  "{…}"

A browser undoes it by `DecompressionStream("deflate")` (assets/js/unpack.js).
"""

from __future__ import annotations

import base64
import re
import zlib
from typing import Final

__all__ = ["document_in", "packed", "unpacked"]

_DOCUMENT: Final = re.compile(r'<script type="text/plain" id="report">([A-Za-z0-9+/=]*)</script>')


def packed(text: str) -> str:
    """The text, compressed as far as zlib can."""
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode()


def unpacked(text: str) -> str:
    """The text that was packed."""
    return zlib.decompress(base64.b64decode(text, validate=True)).decode()


def document_in(page: str) -> str:
    """The JSON document of a report. ValueError where it is no report."""
    found = _DOCUMENT.search(page)
    if found is None:
        raise ValueError("this page does not contain a rosward report")
    return unpacked(found[1])
