# SPDX-License-Identifier: Apache-2.0
"""All models in code, by dotted name."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import rosward.models
from rosward.models.native import NativeFunction

_TABLE: Final[dict[str, NativeFunction]] = {}
"""What `natives` has collected: the modules of the package never change."""


def natives() -> Mapping[str, NativeFunction]:
    """The union of the `NATIVES` tables of the modules of this package; a name in two of them is an error."""
    if not _TABLE:
        _TABLE.update(_collected())
    return MappingProxyType(_TABLE)


def _collected() -> dict[str, NativeFunction]:
    table: dict[str, NativeFunction] = {}
    for info in sorted(pkgutil.walk_packages(rosward.models.__path__, "rosward.models."), key=lambda i: i.name):
        module = importlib.import_module(info.name)
        for name, function in getattr(module, "NATIVES", {}).items():
            if name in table:
                raise ValueError(f"two models of {name}")
            table[name] = function
    return table
