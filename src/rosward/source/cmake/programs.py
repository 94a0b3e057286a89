# SPDX-License-Identifier: Apache-2.0
"""Of which sources does a program consist, over all packages of a workspace?

    add_executable(pump src/main.cpp), target_link_libraries(pump pump_core)
    ->  Program("pump", units=(main.cpp, make.cpp, pump.cpp)), each with its folders of headers and its macros

A library belongs to a program with the sources that the library is made of, compiled as the library is: `Unit`s are compared by all that
matters for their text, so that what two programs share is read once.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Final, final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.boundary import Boundary
from rosward.source.cmake.build import read_build
from rosward.source.cmake.compile_commands import CompileCommands, read_compile_commands
from rosward.source.cmake.standards import macros
from rosward.source.cmake.targets import Build, Built, Definition, Made
from rosward.source.cmake.text import parse_cmake
from rosward.source.text import read_bytes
from rosward.source.walk import CPP_SOURCES
from rosward.source.workspace import Package, Workspace

_FILES: Final = 100
_REACHED: Final = 5_000
_LOOKED_AT: Final = 50_000
_SKIPPED: Final = frozenset({"test", "tests", "build", "install", "log"})


class Unit(NamedTuple):
    """A source as one target compiles it: `includes` are the folders of headers in their order."""

    path: str
    includes: tuple[str, ...]
    definitions: tuple[Definition, ...]


class Program(NamedTuple):
    """What an executable, or the library of a component, consists of; the target's own sources come first.

    `elsewhere` are the names of libraries that are not of the workspace, `missing` the sources that are not there. `plugin` is the class
    that an executable is made for by `rclcpp_components_register_node`.
    """

    package: str
    name: str
    place: Place
    units: tuple[Unit, ...]
    plugin: str = ""
    library: str = ""
    elsewhere: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    installed: bool = True
    sure: bool = True


@final
class Builds:
    """What the packages of a workspace build, each read when it is asked for."""

    __slots__ = ("_boundary", "_builds", "_closures", "_compiled", "_environment", "_functions", "_packages", "_root")

    def __init__(
        self, packages: Iterable[Package], root: Path, boundary: Boundary, environment: Mapping[str, str]
    ) -> None:
        self._packages: dict[str, Package] = {}
        for package in packages:
            self._packages.setdefault(package.name, package)
        self._root = root
        self._boundary = boundary
        self._environment = environment
        self._builds: dict[str, Build | None] = {}
        self._functions: dict[str, dict[str, str]] = {}
        self._compiled: CompileCommands | None = None
        self._closures: dict[tuple[str, str], tuple[tuple[str, ...], tuple[Definition, ...]]] = {}

    @classmethod
    def of(cls, workspace: Workspace) -> Builds:
        """Those of a workspace."""
        return cls(workspace.packages, workspace.root, workspace.boundary, workspace.environment)

    def build(self, package: str) -> Build | None:
        """What a package builds; None where it is not of the workspace, or has no CMakeLists.txt."""
        if package not in self._builds:
            self._builds[package] = None
            record = self._packages.get(package)
            if record is not None and disk.is_file(os.path.join(record.path, "CMakeLists.txt")):  # noqa: PTH118
                self._builds[package] = read_build(
                    os.fspath(record.path),
                    package,
                    self._root,
                    self._boundary,
                    depends=sorted(record.depends),
                    present=frozenset(self._packages),
                    environment=self._environment,
                    functions=self._function,
                )
        return self._builds[package]

    def programs(self, package: str) -> Iterator[Program]:
        """The executables of a package, those that are made for components included, and the components."""
        build = self.build(package)
        if build is None:
            return
        for target in build.targets.values():
            if target.made is Made.PROGRAM:
                yield self._program(build, target, target.output or target.name, target.place)
        for component in build.components:
            target_of = build.targets.get(component.library)
            if target_of is None:
                continue
            made = self._program(build, target_of, component.library, component.place)
            made = made._replace(
                plugin=component.plugin, library=component.library, installed=True, sure=component.sure
            )
            yield made
            if component.program:
                yield made._replace(name=component.program)

    def library(self, package: str, name: str) -> tuple[Unit, ...]:
        """The sources of a library of a package, and of all that it is linked with."""
        build = self.build(package)
        target = build.targets.get(build.aliases.get(name, name)) if build is not None else None
        return () if build is None or target is None else self._program(build, target, name, target.place).units

    def libraries(self, package: str) -> Iterator[Program]:
        """The libraries of a package, but for those of components, each with all that it is linked with."""
        build = self.build(package)
        if build is None:
            return
        of_components = {component.library for component in build.components}
        for target in build.targets.values():
            if target.made is not Made.PROGRAM and target.sources and target.name not in of_components:
                yield self._program(build, target, target.name, target.place)

    def unbuilt(self, package: str) -> list[str]:
        """The C++ sources in the folder of a package that none of its targets has, tests and nested packages left out."""
        build = self.build(package)
        record = self._packages.get(package)
        if record is None:
            return []
        taken = {source for target in build.targets.values() for source in target.sources} if build else set()
        found: list[str] = []
        looked_at = 0
        for folder, inner, names in disk.walk(record.path):
            looked_at += len(names) + len(inner)
            if looked_at > _LOOKED_AT:
                break
            inner[:] = sorted(
                n for n in inner
                if n not in _SKIPPED and not n.startswith(".") and not disk.is_file(f"{folder}/{n}/package.xml")
            )  # fmt: skip
            found += [
                p for n in sorted(names) if n.endswith(CPP_SOURCES) and (p := f"{folder}{os.sep}{n}") not in taken
            ]
        return found

    def _program(self, build: Build, target: Built, name: str, place: Place) -> Program:
        units: dict[Unit, None] = {}
        elsewhere: dict[str, None] = {}
        missing: dict[str, None] = {}
        for owner, reached in self._reached(build, target, elsewhere):
            usage = self._usage(owner, reached)
            units |= {self._unit(source, reached.name, *usage): None for source in reached.sources}
            missing |= dict.fromkeys(reached.missing)
        return Program(
            build.package, name, place, tuple(units), "", "", tuple(elsewhere), tuple(missing), target.installed, target.sure
        )  # fmt: skip

    def _unit(self, source: str, target: str, includes: tuple[str, ...], definitions: tuple[Definition, ...]) -> Unit:
        """A source of a target; where a build has left how it compiled it, with the macros of that."""
        compiled = self._commands().get((source, target))
        if compiled is None:
            return Unit(source, includes, definitions)
        return Unit(source, tuple(dict.fromkeys([*includes, *compiled.includes])), compiled.definitions)

    def alone(self, source: str, includes: tuple[str, ...]) -> Unit:
        """A source that no target is known to have; some build may have left how it compiled it."""
        target = min((name for path, name in self._commands() if path == source), default="")
        return self._unit(source, target, includes, ())

    def _commands(self) -> CompileCommands:
        if self._compiled is None:
            root = os.fspath(self._root)
            builds = [f"{root}{os.sep}build{os.sep}{name}" for name in self._packages]
            folders = [root, *builds, *(os.fspath(package.path) for package in self._packages.values())]
            self._compiled = read_compile_commands(dict.fromkeys(folders), self._boundary)
        return self._compiled

    def _reached(
        self, build: Build, target: Built, elsewhere: dict[str, None], *, handed: bool = False, loose: bool = True
    ) -> Iterator[tuple[Build, Built]]:
        """The target and all that it is linked with. With `handed`, only what these hand on to those that link with them; without `loose`,
        only what it is linked with for sure."""
        seen: set[tuple[str, str]] = set()
        waiting: list[tuple[Build, Built]] = [(build, target)]
        position = 0
        while position < len(waiting) and position < _REACHED:
            here, current = waiting[position]
            position += 1
            key = here.package, current.name
            if key in seen:
                continue
            seen.add(key)
            yield here, current
            links = dict.fromkeys((*current.objects, *current.own.links))
            if position > 1:
                links = dict.fromkeys(current.handed.links) | ({} if handed else links)
            left_out = () if loose else (*current.own.loose, *current.handed.loose)
            for link in (link for link in links if link not in left_out):
                found = list(self._linked(here, link))
                waiting += found
                if not found:
                    elsewhere[link] = None

    def _linked(self, build: Build, link: str) -> Iterator[tuple[Build, Built]]:
        """The targets that a name stands for: one of the package, or those of another one."""
        own = build.targets.get(build.aliases.get(link, link))
        if own is not None:
            yield build, own
            return
        package, marks, name = link.partition("::")
        if not marks:
            return
        other = build if package == build.package else self.build(package)
        if other is None:
            return
        target = other.targets.get(other.aliases.get(link, name))
        if target is not None:
            yield other, target
        else:  # all that it exports, or an export set of another name
            yield from ((other, t) for t in other.targets.values() if t.made is not Made.PROGRAM)

    def _usage(self, build: Build, target: Built) -> tuple[tuple[str, ...], tuple[Definition, ...]]:
        """The folders of headers and the macros with which the sources of a target are compiled."""
        key = build.package, target.name
        found = self._closures.get(key)
        if found is None:
            includes = dict.fromkeys(target.own.includes)
            definitions = dict.fromkeys(target.own.definitions)
            standards = list(target.own.standards)
            packages = [build.package]
            sure = {id(other) for _, other in self._reached(build, target, {}, handed=True, loose=False)}
            for owner, other in self._reached(build, target, {}, handed=True):
                if other is not target:
                    includes |= dict.fromkeys(other.handed.includes)
                    own = other.handed.definitions
                    definitions |= dict.fromkeys(own if id(other) in sure else (d._replace(sure=False) for d in own))
                    standards += (s._replace(sure=s.sure and id(other) in sure) for s in other.handed.standards)
                packages.append(owner.package)
            links = (link.partition("::")[0] for link in target.own.links if "::" in link)
            reached = dict.fromkeys([*packages, *links, *build.depends])
            waiting = list(reached)
            for name in waiting:  # which grows: a header includes those of what its package depends on
                other_build = self.build(name)
                if other_build is not None:
                    waiting += (d for d in other_build.depends if d not in reached)
                    reached |= dict.fromkeys(other_build.depends)
                    includes |= dict.fromkeys(other_build.exported)
                    folder = os.path.join(other_build.folder, "include")  # noqa: PTH118
                    if disk.is_folder(folder):
                        includes[folder] = None
            definitions |= dict.fromkeys(Definition(*each) for each in macros(standards))
            found = self._closures[key] = tuple(includes), tuple(definitions)
        return found

    def _function(self, name: str) -> tuple[str, str] | None:
        """The file in the folder `cmake` of a package that defines a function, or macro."""
        for package in self._packages.values():
            folder = os.path.join(package.path, "cmake")  # noqa: PTH118
            if name in self._defined_in(folder):
                return folder, self._functions[folder][name]
        return None

    def _defined_in(self, folder: str) -> dict[str, str]:
        found = self._functions.get(folder)
        if found is None:
            found = self._functions[folder] = {}
            try:
                names = [e.name for e in disk.listing(folder) if Path(e.name).suffix == ".cmake"][:_FILES]
            except OSError:
                return found
            for file in names:
                path = f"{folder}{os.sep}{file}"
                data = b"" if self._boundary.leads_out(path) else read_bytes(path, path, limits.CMAKE_FUNCTIONS_FILE)
                if isinstance(data, bytes):
                    for command in parse_cmake(data.decode("utf-8", "replace"))[0]:
                        if command.name in {"function", "macro"} and command.arguments:
                            found.setdefault(command.arguments[0].text.lower(), file)
        return found
