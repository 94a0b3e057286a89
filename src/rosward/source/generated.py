# SPDX-License-Identifier: Apache-2.0
"""Which modules does the build of a package make, and where would they lie if they were written by hand?

generate_parameter_module(robot_parameters config/robot.yaml)   in the package robot
->  /ws/src/robot/robot/robot_parameters: the module robot.robot_parameters, made of config/robot.yaml
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import final

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.source import disk
from rosward.source.boundary import Boundary
from rosward.source.text import place_name
from rosward.source.workspace import GeneratedModule, Package, SourceFile, Workspace


class Made(NamedTuple):
    """A module that the build makes, by the record of what it is made of, or a folder in which there is one."""

    file: SourceFile | None
    folder: str | None


@final
class GeneratedModules:
    """The modules that builds make, by the path that they would have in the sources, without suffix."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._made: dict[str, Made] = {}

    def add(self, package: Package, roots: Iterable[str]) -> list[str]:
        """Note the modules of a package, which are imported from these folders; the first parts of their names."""
        tops = []
        for each in package.generated:
            if self._workspace.excluded.of(each.source) is not None:
                continue
            name = f"{each.package}.{each.name}"
            file = SourceFile(Path(each.source), place_name(each.source, self._workspace.root), package, name)
            tops.append(each.package)
            for root in roots:
                folder = f"{root}{os.sep}{each.package}"
                self._made.setdefault(folder, Made(None, folder))
                self._made.setdefault(f"{folder}{os.sep}{each.name}", Made(file, None))
        return tops

    def at(self, path: str, rest: list[str]) -> Made | None:
        """What would lie at the path of a module, or at what `rest` names below it."""
        return self._made.get("".join([path, *(os.sep + name for name in rest)]))


def there(
    generated: Sequence[GeneratedModule], boundary: Boundary
) -> tuple[tuple[GeneratedModule, ...], list[Finding]]:
    """The modules whose descriptions are there, and what is wrong with the others."""
    found: dict[str, GeneratedModule] = {}
    findings = []
    for each in generated:
        names = each.name, *(each.validation.split(".") if each.validation else ())
        readable = all(name.isidentifier() for name in names) and "\0" not in each.source
        if not readable or not disk.is_file(each.source) or boundary.leads_out(each.source):
            message = f"The file from which the module {each.name!r} is generated is not among the sources."
            findings.append(Finding("RW008", message, each.place))
        elif found.setdefault(each.source, each).validation != each.validation:
            message = f"The module {each.name!r} is generated from the same file as another one, with other validators. It was not read."
            findings.append(Finding("RW008", message, each.place))
    return tuple(g for g in generated if g.source in found and g.validation == found[g.source].validation), findings
