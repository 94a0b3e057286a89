# SPDX-License-Identifier: Apache-2.0
"""How many arguments does a native read? With fewer it is not entered: the program does not compile, or calls something else of that name."""

from __future__ import annotations

from collections.abc import Mapping

from rosward.models.native import NativeFunction
from rosward.models.python.plain import native

__all__ = ["with_least"]


def with_least(
    functions: Mapping[str, NativeFunction], default: int, least: Mapping[str, int] | None = None
) -> dict[str, NativeFunction]:
    """The same functions, each of which is given at least so many arguments: `least` by name, else `default`."""
    return {name: native(function, (least or {}).get(name, default)) for name, function in functions.items()}
