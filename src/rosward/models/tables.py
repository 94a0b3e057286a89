# SPDX-License-Identifier: Apache-2.0
"""All that rosward itself knows of libraries beside its stubs: models in code, by dotted name, and what the marks of its stubs say."""

from __future__ import annotations

import importlib
import json
import pkgutil
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Final, final

import rosward.models
from rosward.models.facts import LibraryFacts
from rosward.models.native import NativeFunction
from rosward.models.ros.facts import OWN
from rosward.records import NamedTuple
from rosward.source.kept import kept

_OWN_NATIVES: Final[list[Natives]] = []
_CPP_TABLE: Final[dict[str, NativeFunction]] = {}
"""What `own_models` and `cpp_natives` have collected: the modules of the package never change."""


class Models(NamedTuple):
    """The models in code, and the facts about client libraries."""

    natives: Mapping[str, NativeFunction]
    facts: LibraryFacts


_OWN_MODULES: Final = "rosward.models."
_CPP: Final = "rosward.models.cpp"


@final
class Natives(Mapping[str, NativeFunction]):
    """Models in code by dotted name. The module that one stands in is imported when somebody asks for one of its models."""

    def __init__(self, modules: Mapping[str, str]) -> None:
        self._modules = modules
        self._loaded: dict[str, NativeFunction] = {}

    def __getitem__(self, name: str) -> NativeFunction:
        found = self._loaded.get(name)
        if found is None:
            self._loaded.update(_natives(self._modules[name]))
            found = self._loaded[name]
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self._modules)

    def __len__(self) -> int:
        return len(self._modules)


def cpp_natives() -> Mapping[str, NativeFunction]:
    """The models in code that only C++ needs: loaded where there is a program in C++."""
    if not _CPP_TABLE:
        modules = _modules_of_natives(importlib.import_module(_CPP).__path__, f"{_CPP}.")
        _CPP_TABLE.update({name: _natives(module)[name] for name, module in modules.items()})
    return MappingProxyType(_CPP_TABLE)


def own_models() -> Models:
    """The `NATIVES` tables of all other modules of this package, and the facts of its stubs."""
    if not _OWN_NATIVES:
        content = kept("natives", lambda: json.dumps(_own_natives()).encode())
        found = {} if content is None else json.loads(content)
        if not found or not all(
            module.startswith(_OWN_MODULES) for module in found.values()
        ):  # nothing else is imported
            found = _own_natives()
        _OWN_NATIVES.append(Natives(found))
    return Models(_OWN_NATIVES[0], OWN)


def _own_natives() -> dict[str, str]:
    return _modules_of_natives(rosward.models.__path__, _OWN_MODULES, without=_CPP)


def _modules_of_natives(path: Iterable[str], prefix: str, without: str = "") -> dict[str, str]:
    """In which module each model stands; a name in two of them is an error."""
    found: dict[str, str] = {}
    for info in sorted(_modules(path, prefix, without), key=lambda i: i.name):
        for name in _natives(info.name):
            if name in found:
                raise ValueError(f"two models of {name}")
            found[name] = info.name
    return found


def _natives(module: str) -> Mapping[str, NativeFunction]:
    found: Mapping[str, NativeFunction] = getattr(importlib.import_module(module), "NATIVES", {})
    return found


def _modules(path: Iterable[str], prefix: str, without: str) -> Iterator[pkgutil.ModuleInfo]:
    for info in pkgutil.iter_modules(path, prefix):
        if info.name == without:
            continue
        yield info
        if info.ispkg:
            yield from _modules(importlib.import_module(info.name).__path__, f"{info.name}.", without)
