# SPDX-License-Identifier: Apache-2.0
"""Which scripts and Python packages does a CMakeLists.txt install?

    install(PROGRAMS scripts/talker.py DESTINATION lib/${PROJECT_NAME} RENAME talker)
    ->  InstalledScript("talker", "scripts/talker.py", line=1)

Every branch of an `if` is taken, since the answer to "what could this package install?" should not miss a script. Files outside
the package are neither read nor listed.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.cmake.install import CMakeTarget, Targets, below_share, by_option, shared
from rosward.source.cmake.interpreter import Interpreter
from rosward.source.cmake.reader import Handler
from rosward.source.cmake.text import Command
from rosward.source.entry_points import EntryPoint, read_setup_cfg
from rosward.source.text import place_name
from rosward.source.workspace import GeneratedModule

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.source.workspace import Shared

_INSTALL_FOLDERS: Final = MappingProxyType(
    {
        "CMAKE_INSTALL_LIBDIR": "lib",
        "CMAKE_INSTALL_BINDIR": "bin",
        "CMAKE_INSTALL_DATADIR": "share",
        "CMAKE_INSTALL_DATAROOTDIR": "share",
    }
)


class InstalledScript(NamedTuple):
    """A file, by its path, that is installed as the executable `name`."""

    name: str
    path: str
    place: Place


class CMakeProject(NamedTuple):
    """What is installed as executables and in the share folder, the folders of Python packages, and what could not be read."""

    scripts: tuple[InstalledScript, ...] = ()
    python_roots: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()
    shared: tuple[Shared, ...] = ()
    all_shared: bool = True
    targets: tuple[CMakeTarget, ...] = ()
    entry_points: tuple[EntryPoint, ...] = ()
    generated: tuple[GeneratedModule, ...] = ()


def read_cmake(folder: str, package: str, root: Path, boundary: Boundary = EVERYWHERE) -> CMakeProject:
    """What the CMakeLists.txt in `folder` installs for the package of that name; places are relative to `root`."""
    reader = _Reader(folder, package, root, boundary)
    findings = reader.run()
    return CMakeProject(
        tuple(dict.fromkeys(reader.scripts)),
        tuple(dict.fromkeys(reader.python_roots)),
        tuple(findings),
        tuple(dict.fromkeys(reader.shared)),
        reader.all_shared and not findings,
        reader.targets.startable(),
        tuple(dict.fromkeys(reader.entry_points)),
        tuple(dict.fromkeys(reader.generated)),
    )


@final
class _Reader:
    """One project in the course of being interpreted."""

    def __init__(self, folder: str, package: str, root: Path, boundary: Boundary) -> None:
        self._top = folder
        self._boundary = boundary
        self._root = root
        self._package = package
        variables = {"PROJECT_NAME": package, "CMAKE_PROJECT_NAME": package, "CMAKE_INSTALL_PREFIX": ""}
        self._interpreter = Interpreter(self, folder, package, root, boundary, variables)
        targets = (
            "add_executable", "ament_auto_add_executable", "ament_auto_package", "rclcpp_components_register_node",
            "rclcpp_components_register_nodes",
        )  # fmt: skip
        self.handlers: Mapping[str, Handler] = {
            "install": self._install,
            "catkin_install_python": self._install,
            "generate_parameter_module": self._generated,
            "ament_python_install_package": self._python_package,
            **dict.fromkeys(targets, self._target),
        }
        self.scripts: list[InstalledScript] = []
        self.shared: list[Shared] = []
        self.all_shared = True
        self.targets = Targets(package)
        self.python_roots: list[str] = []
        self.entry_points: list[EntryPoint] = []
        self.generated: list[GeneratedModule] = []

    def run(self) -> list[Finding]:
        """Read the description; what is wrong with it."""
        self._interpreter.read(self._top, 0)
        findings = self._interpreter.findings
        if self._interpreter.files.exhausted:
            message = "The folders named by the build description contain too many files. Not all were examined."
            findings.append(Finding("RW008", message, Place(place_name(self._top, self._root))))
        return findings

    def known(self, name: str) -> str:
        """The folders of an installation are relative to it."""
        return _INSTALL_FOLDERS.get(name, "")

    def environment(self, name: str) -> str:  # noqa: ARG002
        """No variable of the environment is known."""
        return ""

    def unknown_command(self, name: str) -> bool:  # noqa: ARG002
        """Commands of other packages install nothing that is known."""
        return False

    def not_understood(self, arguments: list[str], command: Command) -> None:
        """Nor do others."""

    def _generated(self, arguments: list[str], command: Command) -> None:
        if len(arguments) >= 2:
            interpreter = self._interpreter
            source = os.path.normpath(os.path.join(interpreter.folder, arguments[1]))  # noqa: PTH118
            made = interpreter.variables.get("PROJECT_NAME"), arguments[0], source, "".join(arguments[2:3])
            self.generated.append(GeneratedModule(*made, interpreter.place(command)))

    def _install(self, arguments: list[str], command: Command) -> None:
        what, *rest = arguments
        if what == "TARGETS":
            self.targets.install(rest)
        if what not in {"PROGRAMS", "FILES", "DIRECTORY"}:
            return
        paths, options = by_option(rest)
        destination = next(iter(options.get("DESTINATION", [])), "").strip("/")
        into = below_share(destination, self._package)
        if into is not None:
            for path in paths:
                self._share(what, path, into, options, command)
        if destination != f"lib/{self._package}" and not destination.startswith(f"lib/{self._package}/"):
            return
        executable = "OWNER_EXECUTE" in options.get("PERMISSIONS", []) + options.get("FILE_PERMISSIONS", [])
        place = self._interpreter.place(command)
        if what == "DIRECTORY":
            if executable or "USE_SOURCE_PERMISSIONS" in options:
                self._install_folders(paths, options, place, all_of_them=executable)
        elif what == "PROGRAMS" or executable:
            for path in paths:
                full = self._interpreter.inside(path)
                name = next(iter(options.get("RENAME", [])), "") or os.path.basename(path)  # noqa: PTH119
                if full is None:  # outside, or made by the build
                    self._interpreter.doubt(f"The program {path!r} is outside the package.", command)
                else:
                    self.scripts.append(InstalledScript(name, full, place))

    def _install_folders(
        self, paths: list[str], options: dict[str, list[str]], place: Place, *, all_of_them: bool
    ) -> None:
        """Each file that is, or becomes, executable; whether it is a Python script is for the caller to see."""
        patterns = options.get("PATTERN", [])
        matching = patterns if "FILES_MATCHING" in options else []
        unwanted = patterns if "EXCLUDE" in options and not matching else []
        for path in paths:
            start = self._interpreter.inside(path)
            if start is not None:
                found = self._interpreter.files.below(
                    start, matching=matching, unwanted=unwanted, executable=not all_of_them
                )
                self.scripts += [InstalledScript(name, full, place) for name, full in found]

    def _share(self, what: str, path: str, into: str, options: dict[str, list[str]], command: Command) -> None:
        full = self._interpreter.inside(path)
        if full is None or (not path and what != "DIRECTORY"):  # outside, or made by the build
            self.all_shared = False
        else:
            self.shared.append(shared(what, path, full, into, options, self._interpreter.place(command)))

    def _target(self, arguments: list[str], command: Command) -> None:
        place = self._interpreter.place(command)
        match command.name:
            case "add_executable":
                self.targets.program(arguments, place, installed=False)
            case "ament_auto_add_executable":
                self.targets.program(arguments, place, installed=True)
            case "ament_auto_package":
                for path in (
                    arguments[arguments.index("INSTALL_TO_SHARE") + 1 :] if "INSTALL_TO_SHARE" in arguments else ()
                ):
                    self._share("DIRECTORY", path, "", {}, command)
            case _:
                self.targets.register(arguments, place, one=command.name == "rclcpp_components_register_node")

    def _python_package(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        """`ament_python_install_package(NAME [PACKAGE_DIR FOLDER] [SETUP_CFG FILE] [SCRIPTS_DESTINATION lib/PACKAGE])`.

        The package is imported from the folder that holds it. The scripts that its setup.cfg declares are installed only to a destination.
        """
        folder = _behind("PACKAGE_DIR", arguments) or arguments[0]
        full = self._interpreter.inside(folder)
        if full is not None and full != self._top:
            self.python_roots.append(os.path.dirname(full))  # noqa: PTH120
        description = self._interpreter.inside(_behind("SETUP_CFG", arguments) or f"{folder}/setup.cfg")
        if description is not None and _behind("SCRIPTS_DESTINATION", arguments) and self._is_there(description):
            declared = read_setup_cfg(description, place_name(description, self._root))
            self.entry_points += declared.entry_points
            self._interpreter.findings += declared.findings

    def _is_there(self, path: str) -> bool:
        return disk.is_file(path) and not self._boundary.leads_out(path)


def _behind(keyword: str, arguments: list[str]) -> str:
    """The value of a keyword of a command; '' where it has none."""
    return next(iter(arguments[arguments.index(keyword) + 1 :]), "") if keyword in arguments else ""
