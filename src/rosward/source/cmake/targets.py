# SPDX-License-Identifier: Apache-2.0
"""What does a package build: its targets, with all that says how their sources are compiled, and its components?

    add_executable(talker src/talker.cpp)                     ->  Built("talker", PROGRAM, sources=("/ws/demo/src/talker.cpp",), …)
    target_compile_definitions(talker PRIVATE RATE=5)             definitions=(Definition("RATE", "5"),)

What is for those that link against a target, and not for the target itself, is `handed` on.
"""

from __future__ import annotations

import enum
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.cmake.blocks import Way
from rosward.source.cmake.standards import Standard
from rosward.source.cmake.variables import HOLE


class Made(enum.Enum):
    """What kind of thing a target is."""

    PROGRAM = "program"
    LIBRARY = "library"
    OBJECTS = "objects"
    INTERFACE = "interface"


UNKNOWN_VALUE: Final = "__rosward_either()"
"""The value of a macro of which only the build knows it: one of no alternatives."""


class Definition(NamedTuple):
    """A macro that the command line defines; without `sure`, nobody knows whether it does."""

    name: str
    value: str = "1"
    sure: bool = True


class Usage(NamedTuple):
    """How something is compiled and linked: folders of headers, macros, and the names of libraries or `package::*`.

    `loose` are those libraries of which nobody knows whether it is linked with them, `standards` the versions of C++ that are asked for.
    """

    includes: tuple[str, ...] = ()
    definitions: tuple[Definition, ...] = ()
    links: tuple[str, ...] = ()
    loose: tuple[str, ...] = ()
    standards: tuple[Standard, ...] = ()


class Built(NamedTuple):
    """A target of a package. `sources` are absolute paths; `objects` the targets whose objects are among its own.

    `sure`: it is there whatever the conditions are that nobody could decide. `missing` are sources that are not there, as the build makes them.
    `output` is the name of the file that is made, where that is another.
    """

    name: str
    made: Made
    place: Place
    sources: tuple[str, ...]
    objects: tuple[str, ...]
    own: Usage
    handed: Usage
    installed: bool
    sure: bool
    missing: tuple[str, ...] = ()
    output: str = ""


class Component(NamedTuple):
    """A class that is registered as a component of a library; `program` is the executable that is made for it, '' if none is."""

    plugin: str
    library: str
    program: str
    executor: str
    place: Place
    sure: bool


class ParameterHeader(NamedTuple):
    """A header `name.hpp` that `generate_parameter_library` makes of the parameters in a YAML file."""

    name: str
    source: str
    place: Place


class Build(NamedTuple):
    """All that a package builds in C++.

    `exported` are the folders of headers that other packages see, `undecided` the conditions that nobody knows.
    """

    package: str
    folder: str
    targets: dict[str, Built]
    components: tuple[Component, ...] = ()
    exported: tuple[str, ...] = ()
    depends: tuple[str, ...] = ()
    parameters: tuple[ParameterHeader, ...] = ()
    plugins: tuple[tuple[str, str], ...] = ()
    aliases: dict[str, str] = {}  # noqa: RUF012
    undecided: tuple[Place, ...] = ()
    findings: tuple[Finding, ...] = ()


@final
@dataclass(slots=True)
class Using:
    """A `Usage` in the course of being read."""

    includes: dict[str, None] = field(default_factory=dict)
    definitions: dict[Definition, None] = field(default_factory=dict)
    links: dict[str, None] = field(default_factory=dict)
    loose: dict[str, None] = field(default_factory=dict)
    standards: list[Standard] = field(default_factory=list)

    def link(self, names: Iterable[str], *, sure: bool) -> None:
        """It is linked with these; without `sure`, nobody knows whether."""
        for name in names:
            if sure:
                self.loose.pop(name, None)
            elif name not in self.links:
                self.loose[name] = None
            self.links[name] = None

    def copy(self) -> Using:
        """The same, to be added to."""
        return Using(
            dict(self.includes), dict(self.definitions), dict(self.links), dict(self.loose), list(self.standards)
        )

    def with_(self, other: Using) -> Usage:
        """Its own things, then those of another; versions of C++ are those that another had when this was made."""
        return Usage(
            tuple({**self.includes, **other.includes}),
            tuple({**self.definitions, **other.definitions}),
            tuple({**self.links, **other.links}),
            tuple({**self.loose, **other.loose}),
            tuple(self.standards),
        )


@final
@dataclass(slots=True)
class Making:
    """A target in the course of being read; `folder` is what all targets of its folder use.

    `within`: the ways around the only place that makes it, of which nobody knows whether they are taken.
    """

    name: str
    made: Made
    place: Place
    sure: bool
    folder: Using
    within: tuple[Way, ...] = ()
    sources: dict[str, None] = field(default_factory=dict)
    missing: dict[str, None] = field(default_factory=dict)
    objects: dict[str, None] = field(default_factory=dict)
    own: Using = field(default_factory=Using)
    handed: Using = field(default_factory=Using)
    installed: bool = False
    output: str = ""

    def made_again(self, *, sure: bool) -> None:
        """Another place makes it, too: what the first one defines for it holds only there."""
        self.sure = self.sure or sure
        if self.within:
            self.within = ()
            for using in (self.own, self.handed):
                using.definitions = {d._replace(sure=False): None for d in using.definitions}
                using.loose = dict(using.links)
                using.standards = [s._replace(sure=False) for s in using.standards]

    def made_up(self) -> Built:
        """The target as it is now."""
        return Built(
            self.name,
            self.made,
            self.place,
            tuple(self.sources),
            tuple(self.objects),
            self.own.with_(self.folder),
            self.handed.with_(Using()),
            self.installed,
            self.sure,
            tuple(self.missing),
            "" if HOLE in self.output else self.output,
        )
