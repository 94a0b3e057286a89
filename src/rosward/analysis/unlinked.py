# SPDX-License-Identifier: Apache-2.0
"""Which libraries in C++ is no program of the workspace linked of, and would they create an entity?

add_library(planner SHARED src/planner.cpp)                    no program links it: its sources were not read
PLUGINLIB_EXPORT_CLASS(demo::Planner, nav2_core::GlobalPlanner)     whoever loads plugins may load it
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.linked_functions import CREATORS, NODES
from rosward.records import NamedTuple
from rosward.source.cmake.programs import Builds, Unit
from rosward.source.text import place_name
from rosward.source.workspace import Workspace

if TYPE_CHECKING:
    from rosward.frontends.cpp.headers import Headers

__all__ = ["Unlinked", "unlinked_libraries"]

_LOADABLE: Final = re.compile(
    r"\b(?:PLUGINLIB_EXPORT_CLASS|CLASS_LOADER_REGISTER_CLASS|BT_REGISTER_NODES|BT_RegisterNodesFromPlugin"
    r"|(?:GZ|IGNITION|GAZEBO)_(?:ADD|REGISTER)_\w+)\b"
)
"""What makes the classes of a library known to programs that load it."""


_MACRO: Final = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)((?:[^\n\\]|\\[^\n]|\\\n)*)", re.MULTILINE)
_INCLUDE: Final = re.compile(r"^[ \t]*#[ \t]*include[ \t]*([<\"])([^>\"\n]+)", re.MULTILINE)


class Unlinked(NamedTuple):
    """A library: a name by which it can be asked for, its first source and what it is made of; `loadable`: others can load it at run time."""

    name: str
    file: str
    units: tuple[Unit, ...]
    loadable: bool


def unlinked_libraries(
    workspace: Workspace,
    builds: Builds,
    linked: Collection[str],
    headers: Headers,
    creating: Collection[str],
    described: frozenset[str],
    known: Collection[str],
) -> list[Unlinked]:
    """Those with a source that is not among the `linked` ones, and that says the name of something that creates an entity, or includes
    a header which does.

    `described` are the sources of the classes that a file of plugins describes, `known` the files of programs.
    """
    taken = set(linked)
    there = {os.fspath(file.path) for file in workspace.cpp_sources}
    said = re.compile(rf"\b(?:{'|'.join(map(re.escape, sorted({*creating, *CREATORS})))})\b|{NODES}")
    said_by = _Headers(headers, said, known)
    found: list[Unlinked] = []
    for package in workspace.packages:
        for library in builds.libraries(package.name):
            own = [unit.path for unit in library.units if unit.path in there and unit.path not in taken]
            texts = [text for text in map(headers.read, own) if isinstance(text, str)]
            if any(map(said.search, texts)) or any(map(said_by.includes, (u for u in library.units if u.path in own))):
                name = f"{package.name}/{library.name} as a library"
                loadable = not described.isdisjoint(own) or any(
                    said_by.makes_loadable(unit) for unit in library.units if unit.path in own
                )
                found.append(Unlinked(name, place_name(own[0], workspace.root), library.units, loadable))
                taken.update(own)
    return found


@final
class _Headers:
    """The headers of the workspace, without `known` ones: which of them say something, and what they include, whatever their conditions say."""

    def __init__(self, headers: Headers, said: re.Pattern[str], known: Collection[str]) -> None:
        self._headers = headers
        self._said = said
        self._known = known
        self._read: dict[str, tuple[bool, list[tuple[str, str]]]] = {}
        self._silent: dict[tuple[str, ...], set[str]] = {}

    def includes(self, unit: Unit) -> bool:
        """Whether a source includes one that says it."""
        silent = self._silent.setdefault(unit.includes, set())
        seen = []
        for path in self._reached(unit, lambda found: found in silent or self._headers.named(found) in self._known):
            if path != unit.path and self._content(path)[0]:
                return True
            seen.append(path)
        silent.update(seen)
        return False

    def makes_loadable(self, unit: Unit) -> bool:
        """Whether a source makes classes known to who loads it, itself or by a macro that it includes."""
        own = self._text(unit.path)
        if _LOADABLE.search(own):
            return True
        macros = [each for path in self._reached(unit, lambda _: False) for each in _MACRO.findall(self._text(path))]
        names = {name for name, content in macros if _LOADABLE.search(content)}
        for _ in macros if names else ():  # macros of macros
            more = {name for name, content in macros if not names.isdisjoint(re.findall(r"\w+", content))}
            if more <= names:
                break
            names |= more
        return not names.isdisjoint(re.findall(r"\w+", own))

    def _reached(self, unit: Unit, is_known: Callable[[str], bool]) -> Iterator[str]:
        """A source, and the headers that lead from it."""
        waiting, seen = [unit.path], {unit.path}
        while waiting:
            path = waiting.pop()
            yield path
            for quote, name in self._content(path)[1]:
                found = self._headers.included(name, path, unit.includes, quoted=quote == '"')
                if found is not None and found not in seen and not is_known(found):
                    seen.add(found)
                    waiting.append(found)

    def _text(self, path: str) -> str:
        text = self._headers.read(path)
        return text if isinstance(text, str) else ""

    def _content(self, path: str) -> tuple[bool, list[tuple[str, str]]]:
        found = self._read.get(path)
        if found is None:
            text = self._text(path)
            found = self._read[path] = self._said.search(text) is not None, _INCLUDE.findall(text)
        return found
