# SPDX-License-Identifier: Apache-2.0
"""All that rosward itself knows of libraries beside its stubs: models in code, by dotted name, and what the marks of its stubs say."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Final, NamedTuple

import rosward.models
from rosward.models.facts import LibraryFacts
from rosward.models.native import NativeFunction
from rosward.models.ros.facts import OWN

_TABLE: Final[dict[str, NativeFunction]] = {}
_CPP_TABLE: Final[dict[str, NativeFunction]] = {}
"""What `own_models` and `cpp_natives` have collected: the modules of the package never change."""


class Models(NamedTuple):
    """The models in code, and the facts about client libraries."""

    natives: Mapping[str, NativeFunction]
    facts: LibraryFacts


_CPP: Final = "rosward.models.cpp"


def cpp_natives() -> Mapping[str, NativeFunction]:
    """The models in code that only C++ needs: loaded where there is a program in C++."""
    if not _CPP_TABLE:
        _CPP_TABLE.update(_collected(importlib.import_module(_CPP).__path__, f"{_CPP}."))
    return MappingProxyType(_CPP_TABLE)


def own_models() -> Models:
    """The union of the `NATIVES` tables of the modules of this package (a name in two of them is an error), and the facts of its stubs."""
    if not _TABLE:
        _TABLE.update(_collected(rosward.models.__path__, "rosward.models.", without=_CPP))
    return Models(MappingProxyType(_TABLE), OWN)


def _collected(path: Iterable[str], prefix: str, without: str = "") -> dict[str, NativeFunction]:
    table: dict[str, NativeFunction] = {}
    for info in sorted(_modules(path, prefix, without), key=lambda i: i.name):
        module = importlib.import_module(info.name)
        for name, function in getattr(module, "NATIVES", {}).items():
            if name in table:
                raise ValueError(f"two models of {name}")
            table[name] = function
    return table


def _modules(path: Iterable[str], prefix: str, without: str) -> Iterator[pkgutil.ModuleInfo]:
    for info in pkgutil.iter_modules(path, prefix):
        if info.name == without:
            continue
        yield info
        if info.ispkg:
            yield from _modules(importlib.import_module(info.name).__path__, f"{info.name}.", without)
