# SPDX-License-Identifier: Apache-2.0
"""The version, as a constant: reading it from the installed metadata would cost more than the whole start-up."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Final

__version__: Final = "0.1.0"
