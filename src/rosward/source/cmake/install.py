# SPDX-License-Identifier: Apache-2.0
"""Which programs and components does a CMakeLists.txt build, and how is an `install(…)` of files to be read?

    add_executable(talker src/talker.cpp)
    install(TARGETS talker DESTINATION lib/demo)                                ->  executable talker
    rclcpp_components_register_node(arms PLUGIN "demo::Arm" EXECUTABLE arm)     ->  component demo::Arm of arms, executable arm

`interpreter.py` interprets the commands; here is what those say that are about targets and destinations.
"""

from __future__ import annotations

import itertools
import os
from typing import Final, final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.workspace import Shared, TargetKind

_INSTALL_WORDS: Final = frozenset(
    {
        "COMPONENT", "CONFIGURATIONS", "DESTINATION", "DIRECTORY_PERMISSIONS", "EXCLUDE", "EXCLUDE_FROM_ALL",
        "FILES_MATCHING", "FILE_PERMISSIONS", "MESSAGE_NEVER", "OPTIONAL", "PATTERN", "PERMISSIONS", "REGEX", "RENAME",
        "TYPE", "USE_SOURCE_PERMISSIONS",
    }
)  # fmt: skip
_ARTIFACTS: Final = frozenset(
    {
        "ARCHIVE", "BUNDLE", "FRAMEWORK", "INCLUDES", "LIBRARY", "OBJECTS", "PRIVATE_HEADER", "PUBLIC_HEADER", "RESOURCE",
        "RUNTIME",
    }
)  # fmt: skip
_TARGET_OPTIONS: Final = _INSTALL_WORDS | {"EXPORT"}


class CMakeTarget(NamedTuple):
    """A program or component; see `workspace.Target`."""

    name: str
    kind: TargetKind
    place: Place
    plugin: str = ""


def by_option(arguments: list[str]) -> tuple[list[str], dict[str, list[str]]]:
    """The paths of `install(FILES …)` and the like, and what stands behind each option."""
    paths: list[str] = []
    options: dict[str, list[str]] = {}
    into = paths
    for argument in arguments:
        if argument in _INSTALL_WORDS:
            into = options.setdefault(argument, [])
        else:
            into.append(argument)
    return paths, options


def installed_targets(arguments: list[str], package: str) -> list[str]:
    """The targets of `install(TARGETS a b [RUNTIME] DESTINATION lib/PACKAGE)`; none where programs go elsewhere."""
    names: list[str] = []
    destination, artifact, option = "", "", ""
    for argument in arguments:
        if argument in _ARTIFACTS:
            artifact = option = argument
        elif argument in _TARGET_OPTIONS:
            option = argument
        elif option == "DESTINATION" and artifact in {"", "RUNTIME"}:
            destination = argument.strip("/")
        elif not option:
            names.append(argument)
    return names if destination == f"lib/{package}" or destination.startswith(f"lib/{package}/") else []


def registered_classes(arguments: list[str]) -> list[str]:
    """The classes of `rclcpp_components_register_nodes(LIBRARY a b [RESOURCE_INDEX …])`."""
    return arguments[1 : arguments.index("RESOURCE_INDEX") if "RESOURCE_INDEX" in arguments else None]


def below_share(destination: str, package: str) -> str | None:
    """The part of a destination behind `share/PACKAGE`, None if it is elsewhere."""
    parts = [part for part in destination.split("/") if part not in ("", ".")]
    return "/".join(parts[2:]) if parts[:2] == ["share", package] and ".." not in parts else None


def shared(what: str, path: str, source: str, into: str, options: dict[str, list[str]], place: Place) -> Shared:
    """What `install(FILES|PROGRAMS|DIRECTORY path DESTINATION share/PACKAGE/into)` puts there; `source` is where `path` leads."""
    name = os.path.basename(path)  # noqa: PTH119  of `launch/`: '', its content
    if what != "DIRECTORY":
        name = next(iter(options.get("RENAME", [])), "") or name
    whole = not options.keys() & {"PATTERN", "REGEX", "FILES_MATCHING"}
    return Shared("/".join(part for part in (into, name) if part), source, place, whole)


@final
class Targets:
    """The targets of one project, in the course of being read."""

    def __init__(self, package: str) -> None:
        self._package = package
        self._programs: dict[str, Place] = {}
        self._installed: dict[str, None] = {}
        self._registered: list[CMakeTarget] = []

    def program(self, arguments: list[str], place: Place, *, installed: bool) -> None:
        """`add_executable(NAME …)`; ament_auto installs its own."""
        if {"IMPORTED", "ALIAS"}.isdisjoint(arguments[1:3]):
            self._programs.setdefault(arguments[0], place)
            if installed:
                self._installed[arguments[0]] = None

    def install(self, arguments: list[str]) -> None:
        """`install(TARGETS a b [RUNTIME] DESTINATION lib/PACKAGE)`."""
        self._installed.update(dict.fromkeys(installed_targets(arguments, self._package)))

    def register(self, arguments: list[str], place: Place, *, one: bool) -> None:
        """`rclcpp_components_register_node(LIBRARY PLUGIN c EXECUTABLE e)`, `…_nodes(LIBRARY c…)`."""
        library, *rest = arguments
        if not one:
            plugins = registered_classes(arguments)
            self._registered += [CMakeTarget(library, TargetKind.COMPONENT, place, plugin) for plugin in plugins]
            return
        given = dict(itertools.pairwise(rest))
        plugin, program = given.get("PLUGIN", ""), given.get("EXECUTABLE", "")
        if plugin:
            self._registered.append(CMakeTarget(library, TargetKind.COMPONENT, place, plugin))
        if program:
            self._registered.append(CMakeTarget(program, TargetKind.EXECUTABLE, place, plugin))

    def startable(self) -> tuple[CMakeTarget, ...]:
        """What can be started or loaded."""
        programs = [
            CMakeTarget(name, TargetKind.EXECUTABLE, place)
            for name, place in self._programs.items()
            if name in self._installed
        ]
        return tuple(dict.fromkeys([*programs, *self._registered]))
