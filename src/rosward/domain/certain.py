# SPDX-License-Identifier: Apache-2.0
"""Which constant is a value for sure?"""

from __future__ import annotations

from rosward.domain.values import Const, Value


def text_of(value: Value | None, default: str = "") -> str:
    """The str that a value surely is."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else default


def is_true(value: Value | None) -> bool:
    """Whether a value is the constant True."""
    return isinstance(value, Const) and value.value is True
