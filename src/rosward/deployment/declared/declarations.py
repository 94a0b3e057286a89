# SPDX-License-Identifier: Apache-2.0
"""Where do the declarations of packages stand, and what do they declare?

declarations = Declarations([Path("models")])
declarations.executable("robot_state_publisher", "robot_state_publisher")  ->  Program
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Final, final

from rosward.deployment.declared.read import read_package
from rosward.deployment.declared.shapes import EndpointGroup, PackageDeclaration, Program
from rosward.findings import Finding, Findings
from rosward.guard import guarded
from rosward.location import Place
from rosward.source import disk, limits
from rosward.source.text import read_bytes
from rosward.source.yaml_documents import YamlDocuments

MODELS: Final = Path(__file__).parent.parent.parent / "models" / "nodes"
_NAME: Final = re.compile(r"[A-Za-z0-9_-]{1,200}")


@final
class Declarations:
    """The declared interfaces of packages: those of `folders` (DIR/nodes/PKG.yaml or DIR/PKG.yaml) before rosward's own.

    Files are read when something asks for their package; what is wrong with them stands in `findings`.
    """

    def __init__(
        self, folders: Sequence[Path] = (), *, net: bool = True, documents: YamlDocuments | None = None
    ) -> None:
        self._net = net
        self.documents = documents or YamlDocuments()
        """The YAML files that were read, these and others."""
        self._places = [(f"{folder.name}/{sub}", folder / sub) for folder in folders for sub in ("nodes", "")]
        self._places.append(("models:nodes/", MODELS))
        self._packages: dict[str, tuple[PackageDeclaration, ...]] = {}
        self.findings = Findings()

    def executable(self, package: str, name: str) -> Program | None:
        """The declared executable of a package."""
        return next((p.executables[name] for p in self._of(package) if name in p.executables), None)

    def component(self, package: str, plugin: str) -> Program | None:
        """The declared component of a package, by the name of its plugin."""
        return next((p.components[plugin] for p in self._of(package) if plugin in p.components), None)

    def interface(self, package: str, name: str) -> EndpointGroup | None:
        """A named group of a package."""
        return next((p.interfaces[name] for p in self._of(package) if name in p.interfaces), None)

    def knows(self, package: str) -> bool:
        """Whether anything is declared of a package."""
        return bool(self._of(package))

    def _of(self, package: str) -> tuple[PackageDeclaration, ...]:
        if package not in self._packages:
            self._packages[package] = tuple(self._read(package)) if _NAME.fullmatch(package) else ()
        return self._packages[package]

    def _read(self, package: str) -> Iterator[PackageDeclaration]:
        for label, folder in self._places:
            path = folder / f"{package}.yaml"
            if not disk.is_file(path):
                continue
            file = f"{label.rstrip('/')}/{package}.yaml"
            data = read_bytes(path, file, limits.DECLARED_FILE)
            if isinstance(data, Finding):
                self.findings.add(Finding("RW324", data.message, data.place))
                continue
            text, missing = data.decode("utf-8", "replace"), "the declared interface was not read"
            read = guarded(
                partial(read_package, text, file, package, self.documents), Place(file), missing, net=self._net
            )
            found, findings = (None, (read,)) if isinstance(read, Finding) else read
            self.findings.update(findings)
            if found is not None:
                yield found
