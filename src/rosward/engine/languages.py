# SPDX-License-Identifier: Apache-2.0
"""Which languages does the engine run? One record each; `Code.language` says which one a body is written in.

A further language is a folder beside `python/` with its record (`machine.Language`), one entry here, and one in `frontends/registry.py`.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping
from typing import Final, final

from rosward.engine.machine import Language, Watcher
from rosward.engine.python.language import PYTHON
from rosward.ir import program

__all__ = ["LANGUAGES", "Languages", "Watched"]


def _cpp() -> Language:
    """Only programs in C++ pay for its modules."""
    found: Language = importlib.import_module("rosward.engine.cpp.language").CPP
    return found


LANGUAGES: Final[Mapping[str, Callable[[], Language]]] = {program.PYTHON: lambda: PYTHON, program.CPP: _cpp}
"""What gives each. The first is the one that models and natives are written in."""


@final
class Languages(Mapping[str, Language]):
    """The languages by name, each loaded when its code is first run."""

    def __init__(self, known: Mapping[str, Callable[[], Language]] = LANGUAGES) -> None:
        self._known = known
        self._loaded: dict[str, Language] = {}

    def __getitem__(self, name: str) -> Language:
        found = self._loaded.get(name)
        if found is None:
            found = self._loaded[name] = self._known[name]()
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)


@final
class Watched(Mapping[str, Language]):
    """The same languages, noting what their operations do."""

    def __init__(self, languages: Mapping[str, Language], watch: Watcher) -> None:
        self._languages = languages
        self._watch = watch
        self._watched: dict[str, Language] = {}

    def __getitem__(self, name: str) -> Language:
        found = self._watched.get(name)
        if found is None:
            found = self._watched[name] = self._watch.watching(self._languages[name])
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self._languages)

    def __len__(self) -> int:
        return len(self._languages)
