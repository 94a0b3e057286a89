# SPDX-License-Identifier: Apache-2.0
"""How does the page hold long texts in little room?

    packed("{…}")   ->  "eNq9…"     base64 of a zlib stream: letters that mean nothing to HTML
    unpacked("eNq9…")  ->  "{…}"

A browser undoes it by `DecompressionStream("deflate")` (assets/js/unpack.js).
"""

from __future__ import annotations

import base64
import zlib

__all__ = ["packed", "unpacked"]


def packed(text: str) -> str:
    """The text, compressed as far as zlib can."""
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode()


def unpacked(text: str) -> str:
    """The text that was packed."""
    return zlib.decompress(base64.b64decode(text, validate=True)).decode()
