# SPDX-License-Identifier: Apache-2.0
"""With which status does a command exit?"""

from __future__ import annotations

TYPE_CHECKING = False  # not from typing: this decides what else is loaded
if TYPE_CHECKING:
    from typing import Final

__all__ = ["COMPLETE", "INCOMPLETE", "INTERNAL", "INTERRUPTED", "WRONG_USE"]

COMPLETE: Final = 0
INCOMPLETE: Final = 1
WRONG_USE: Final = 2
INTERNAL: Final = 3
INTERRUPTED: Final = 130
