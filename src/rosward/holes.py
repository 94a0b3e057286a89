# SPDX-License-Identifier: Apache-2.0
"""How does a text of which parts are not known stand in one str?

    holed(['/robot_', None, '/cmd'])      Holed('/robot_*/cmd')
    literal('/robot_*/cmd')               a text that no ROS name can be: its * is a character, no hole

`Holed` is a type of its own, so that a text of the source becomes one only through these functions: a `*` that somebody wrote can never
come to stand for anything.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, NewType

Holed = NewType("Holed", str)
"""A text in which `*` stands for each part that is not known, and for nothing else."""

HOLE: Final = Holed("*")
"""What stands in a name for the part that is not known; no ROS name may hold it."""

_STAR: Final = "\ue002"
"""Stands for a `*` that is a character: one that ROS names may not hold either."""


def literal(text: str) -> Holed:
    """A text that is wholly known."""
    return Holed(text.replace("*", _STAR))


def holed(parts: Iterable[str | None]) -> Holed:
    """Known texts, and None for each hole."""
    return Holed("".join(HOLE if part is None else literal(part) for part in parts))


def with_stars(text: str) -> str:
    """The text as a person reads it: `*` for holes and for what is one."""
    return text.replace(_STAR, "*")
