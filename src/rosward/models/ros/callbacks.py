# SPDX-License-Identifier: Apache-2.0
"""Which function is called back?"""

from __future__ import annotations

from rosward.domain.compound import BoundMethod, Descriptor, Partial
from rosward.domain.values import Choice, Class, Function, Value


def callback_name(value: Value | None) -> str | None:
    """The qualified name of a function; None where it is not known."""
    while value is not None:
        if value.__class__ is Function and value.code.file.startswith("models:"):
            return None  # a method of the library itself
        if value.__class__ is Function:
            return value.code.qualname
        if value.__class__ in (BoundMethod, Partial):
            value = value.function
        elif value.__class__ is Descriptor:
            value = value.getter
        elif value.__class__ is Choice:
            value = next((o for o in value.options if callback_name(o)), None)
        elif value.__class__ is Class:
            return value.qualname
        else:
            return None
    return None
