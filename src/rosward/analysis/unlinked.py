# SPDX-License-Identifier: Apache-2.0
"""Which libraries in C++ is no program of the workspace linked of, and would they create an entity?

add_library(planner SHARED src/planner.cpp)                    no program links it: its sources were not read
PLUGINLIB_EXPORT_CLASS(demo::Planner, nav2_core::GlobalPlanner)     whoever loads plugins may load it
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection
from typing import Final

from rosward.analysis.linked_functions import CREATORS, NODES
from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.source.cmake.programs import Builds, Unit
from rosward.source.text import place_name
from rosward.source.workspace import Workspace

__all__ = ["Unlinked", "unlinked_libraries"]

_LOADABLE: Final = re.compile(
    r"\b(?:PLUGINLIB_EXPORT_CLASS|CLASS_LOADER_REGISTER_CLASS|BT_REGISTER_NODES|BT_RegisterNodesFromPlugin"
    r"|(?:GZ|IGNITION|GAZEBO)_(?:ADD|REGISTER)_\w+)\b"
)
"""What makes the classes of a library known to programs that load it."""


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
    read: Callable[[str], str | Finding],
    creating: Collection[str],
    described: frozenset[str],
) -> list[Unlinked]:
    """Those with a source that is not among the `linked` ones, and that says the name of something that creates an entity.

    `described` are the sources of the classes that a file of plugins describes.
    """
    taken = set(linked)
    there = {os.fspath(file.path) for file in workspace.cpp_sources}
    said = re.compile(rf"\b(?:{'|'.join(map(re.escape, sorted({*creating, *CREATORS})))})\b|{NODES}")
    found: list[Unlinked] = []
    for package in workspace.packages:
        for library in builds.libraries(package.name):
            own = [unit.path for unit in library.units if unit.path in there and unit.path not in taken]
            texts = [text for text in map(read, own) if isinstance(text, str)]
            if any(map(said.search, texts)):
                name = f"{package.name}/{library.name} as a library"
                loadable = any(map(_LOADABLE.search, texts)) or not described.isdisjoint(own)
                found.append(Unlinked(name, place_name(own[0], workspace.root), library.units, loadable))
                taken.update(own)
    return found
