# SPDX-License-Identifier: Apache-2.0
"""Which name, like one that is wanted, does nobody have yet?

/box, where /box and /box_2 are taken, with the mark _      ->  /box_3
"""

from __future__ import annotations

from collections.abc import Collection

__all__ = ["free"]


def free(wanted: str, taken: Collection[str], mark: str) -> str:
    """The name, or, where it is taken, the first of its numbered ones that is not: 2, 3, …, behind the mark."""
    found, number = wanted, 2
    while found in taken:
        found, number = f"{wanted}{mark}{number}", number + 1
    return found
