# SPDX-License-Identifier: Apache-2.0
"""Which libraries in C++ is no program of the workspace linked of, and would they create an entity?

add_library(planner SHARED src/planner.cpp)                    no program links it: its sources were not read
PLUGINLIB_EXPORT_CLASS(demo::Planner, nav2_core::GlobalPlanner)     whoever loads plugins may load it
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING, Final

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


_INCLUDE: Final = re.compile(r"^[ \t]*#[ \t]*include[ \t]*([<\"])([^>\"\n]+)", re.MULTILINE)
_HEADERS: Final = 300


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
    found: list[Unlinked] = []
    for package in workspace.packages:
        for library in builds.libraries(package.name):
            own = [unit.path for unit in library.units if unit.path in there and unit.path not in taken]
            texts = [text for text in map(headers.read, own) if isinstance(text, str)]
            if any(map(said.search, texts)) or any(
                said.search(text)
                for unit in library.units
                if unit.path in own
                for text in _included(headers, unit, known)
            ):
                name = f"{package.name}/{library.name} as a library"
                loadable = any(map(_LOADABLE.search, texts)) or not described.isdisjoint(own)
                found.append(Unlinked(name, place_name(own[0], workspace.root), library.units, loadable))
                taken.update(own)
    return found


def _included(headers: Headers, unit: Unit, known: Collection[str]) -> Iterator[str]:
    """The texts of the headers of the workspace that a source includes, without `known` ones, whatever its conditions say."""
    waiting, seen = [unit.path], {unit.path}
    while waiting and len(seen) < _HEADERS:
        path = waiting.pop()
        text = headers.read(path)
        if not isinstance(text, str):
            continue
        if path != unit.path:
            yield text
        for quote, name in _INCLUDE.findall(text):
            found = headers.find(name, path, unit.includes, quoted=quote == '"')
            if found is not None and found not in seen and headers.named(found) not in known:
                seen.add(found)
                waiting.append(found)
