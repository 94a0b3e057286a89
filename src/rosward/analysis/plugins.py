# SPDX-License-Identifier: Apache-2.0
"""Which classes of the workspace can a program load by pluginlib, and what is a program linked of that loads some?

<class name="demo/Square" type="demo::Square" base_class_type="demo::Shape"/>
->  the sources of the library around it, and a text that says what a loader makes:
    if (base == "demo::Shape" && name == "demo/Square") {return std::make_shared<demo::Square>();}
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from typing import Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits
from rosward.source.cmake.programs import Builds, Unit
from rosward.source.plugin_files import PluginClass, read_plugins
from rosward.source.text import place_name, read_bytes
from rosward.source.workspace import Workspace

__all__ = ["Plugins", "plugins_of"]

_TYPE: Final = re.compile(r"\w+(?:::\w+)*(?: ?<[\w:<>, ]*>)?", re.ASCII)
"""A type that a loader can make, as C++ writes it: `demo::Square`, `demo::Grid<>`, `demo::Grid<demo::Cell>`."""
_MOST: Final = 500
"""So many classes a loader is told of."""


class Library(NamedTuple):
    """The library of a class: its package, and what it is made of."""

    package: str
    units: tuple[Unit, ...]


class Plugins(NamedTuple):
    """What a program is linked of that loads plugins, and the text in C++ that makes them; '' where there are none.

    `libraries` has the package and the sources of each class.
    """

    units: tuple[Unit, ...]
    text: str
    libraries: Mapping[PluginClass, Library]
    findings: tuple[Finding, ...]

    def named(self, name: str) -> PluginClass | None:
        """The class of a name, or of a type."""
        return next((c for c in self.libraries if name in (c.name, c.type)), None)


def plugins_of(workspace: Workspace, builds: Builds) -> Plugins:
    """Those of a workspace."""
    units: dict[Unit, None] = {}
    classes: dict[PluginClass, Library] = {}
    findings: list[Finding] = []
    for package in workspace.packages:
        build = builds.build(package.name)
        for _, path in build.plugins if build is not None else ():
            file = place_name(path, workspace.root)
            data = read_bytes(path, file, limits.MANIFEST_FILE)
            if isinstance(data, Finding):
                findings.append(data)
                continue
            found, wrong = read_plugins(data, file)
            if wrong is not None:
                findings.append(Finding("RW008", f"The plugins were not read: {wrong[0]}", Place(file, wrong[1])))
            for each in found:
                if _TYPE.fullmatch(each.type) and len(classes) < _MOST:
                    library = Library(package.name, builds.library(package.name, each.library))
                    classes.setdefault(each, library)
                    units |= dict.fromkeys(library.units)
    return Plugins(tuple(units), _text(classes) if classes else "", classes, tuple(findings))


def _text(classes: Collection[PluginClass]) -> str:
    """What makes an object of a class by its name, and which names there are for a base."""
    made = [
        f"if (base == {json.dumps(c.base)} && (name == {json.dumps(c.name)} || name == {json.dumps(c.type)}))"
        f" {{return std::make_shared<{c.type}>();}}"
        for c in classes
    ]
    named = [f"if (base == {json.dumps(c.base)}) {{names.push_back({json.dumps(c.name)});}}" for c in classes]
    lines = [
        "namespace pluginlib {",
        "std::shared_ptr<void> of_workspace(const std::string & base, const std::string & name) {",
        *made,
        "return rosward::outside_plugin(name); }",
        "std::vector<std::string> names_in_workspace(const std::string & base) {",
        "std::vector<std::string> names;",
        *named,
        "return names; }",
        "}",
    ]
    return "\n".join([*lines, ""])
