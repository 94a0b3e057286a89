# SPDX-License-Identifier: Apache-2.0
"""All that rosward itself knows of libraries beside its stubs: models in code, by dotted name, and what the marks of its stubs say."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, NamedTuple

import rosward.models
from rosward.models.facts import LibraryFacts
from rosward.models.native import NativeFunction
from rosward.models.ros.facts import OWN

_TABLE: Final[dict[str, NativeFunction]] = {}
"""What `own_models` has collected: the modules of the package never change."""


class Models(NamedTuple):
    """The models in code, and the facts about client libraries."""

    natives: Mapping[str, NativeFunction]
    facts: LibraryFacts


def own_models() -> Models:
    """The union of the `NATIVES` tables of the modules of this package (a name in two of them is an error), and the facts of its stubs."""
    if not _TABLE:
        _TABLE.update(_collected())
    return Models(MappingProxyType(_TABLE), OWN)


def _collected() -> dict[str, NativeFunction]:
    table: dict[str, NativeFunction] = {}
    for info in sorted(pkgutil.walk_packages(rosward.models.__path__, "rosward.models."), key=lambda i: i.name):
        module = importlib.import_module(info.name)
        for name, function in getattr(module, "NATIVES", {}).items():
            if name in table:
                raise ValueError(f"two models of {name}")
            table[name] = function
    return table
