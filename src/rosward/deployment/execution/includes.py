# SPDX-License-Identifier: Apache-2.0
"""Launch files by path: which one is meant, and what it says, each read once.

<include file="$(find-pkg-share demo)/launch/a.launch.xml"/>    ->    the Description of demo/launch/a.launch.xml

A file that is not there is RW311, and the rest goes on. Configurations that it would have set are then not known to be set: whoever
reads one finds what the including file has set, or an unknown value.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.deployment.markup.xml import read_xml
from rosward.deployment.markup.yaml_file import read_yaml
from rosward.deployment.tree import Description
from rosward.domain.choice import reasons_of
from rosward.domain.text import is_path, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import Hole, Value
from rosward.findings import Finding
from rosward.guard import guarded
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.deployment.execution.findings import FindingLog
    from rosward.deployment.execution.launch_files import LaunchFiles
    from rosward.deployment.execution.scene import Scene
    from rosward.deployment.performer import PythonCode

_SUFFIXES: Final = {".py": "python", ".xml": "xml", ".yaml": "yaml", ".yml": "yaml"}


@final
class Descriptions:
    """The launch files that were read."""

    def __init__(self, files: LaunchFiles, python: PythonCode, findings: FindingLog, *, net: bool = True) -> None:
        self._net = net
        self._files = files
        self._python = python
        self._findings = findings
        self._read: dict[tuple[str, str], Description | None] = {}

    def find(self, path: Value, place: Place) -> str | None:
        """The file behind a path; where there is none, that is told."""
        file = self._files.find(path)
        if file is None:
            message, causes = self._missing(path)
            self._findings.tell("RW311", message, place, causes)
        return file

    def _missing(self, path: Value) -> tuple[str, tuple[str, ...]]:
        """What is to be said of it, and by what it is put together with what else is missing."""
        shown = self._files.show(path)
        parts = parts_of(path)
        first = parts[0]
        if isinstance(first, Hole) and is_path(path):
            packages = [r.subject for r in first.reasons if r.cause is not Cause.SOURCES]
            absent = [p for p in packages if not self._files.has_package(p)]
            if absent:
                why = f"the package '{absent[0]}' is not among the sources"
                return f"The included launch file {shown} was not found: {why}.", (f"package {absent[0]}",)
            if len(parts) == 2:
                return f"The included launch file {shown} does not exist.", (f"file {shown}",)
        reasons = "; ".join(str(r) for r in reasons_of(path)[:3])
        why = f" ({reasons})." if reasons else "."
        return f"The included launch file {shown} was not found{why}", ()

    def read(self, file: str, form: str, scene: Scene) -> Description | None:
        """What a launch file says; None where it cannot be read, which is told."""
        kind = self._form(file, form)
        key = (file, kind)
        if key not in self._read:
            self._read[key] = None  # a file that includes itself while it is read
            read = guarded(
                lambda: self._parsed(file, kind, scene),
                Place(file),
                "what this launch file starts is missing",
                net=self._net,
            )
            if isinstance(read, Finding):
                self._findings.add(read)
            else:
                self._read[key] = read
        return self._read[key]

    def _form(self, file: str, form: str) -> str:
        if form != "any":
            return form
        found = next((kind for suffix, kind in _SUFFIXES.items() if file.endswith(suffix)), "")
        if found:
            return found
        text = self._files.text(file) or ""
        return "xml" if text.lstrip("\ufeff \t\r\n").startswith("<") else "yaml"

    def _parsed(self, file: str, kind: str, scene: Scene) -> Description | None:
        if kind == "python":
            return self._python.read(file, scene)
        text = self._files.text(file)
        if text is None:
            self._findings.tell("RW310", "The launch file cannot be read.", Place(file, 0))
            return None
        description, findings = read_xml(text, file) if kind == "xml" else read_yaml(text, file)
        self._findings.add(*findings)
        return description
