# SPDX-License-Identifier: Apache-2.0
"""Which places of the page are open, to be filled by each report?

filled("<title>⟦nodes⟧</title>", {"nodes": "2 nodes", …})      "<title>2 nodes</title>"
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

__all__ = ["SLOTS", "filled", "slot"]

SLOTS: Final = ("nodes", "files", "distro", "fallback", "document")

_SLOT: Final = re.compile(f"⟦({'|'.join(SLOTS)})⟧")


def slot(name: str) -> str:
    """What stands in an open place."""
    return f"⟦{name}⟧"


def filled(frame: str, texts: Mapping[str, str]) -> str:
    """The page with a text, as HTML, in each open place. What is filled in is not looked at again."""
    return _SLOT.sub(lambda found: texts[found[1]], frame)
