# SPDX-License-Identifier: Apache-2.0
"""Characters, which are texts of one here, and small numbers in C++."""

from __future__ import annotations

from rosward.domain.values import Const, Value
from rosward.models.python.plain import text_of

__all__ = ["character_of"]


def character_of(value: Value) -> str | None:
    """The character that a value is; a small number is one, too."""
    if (
        isinstance(value, Const)
        and isinstance(value.value, int)
        and value.value.__class__ is not bool
        and 0 <= value.value < 128
    ):
        return chr(value.value)
    return text_of(value)
