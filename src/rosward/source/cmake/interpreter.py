# SPDX-License-Identifier: Apache-2.0
"""Which scripts and Python packages does a CMakeLists.txt install?

    install(PROGRAMS scripts/talker.py DESTINATION lib/${PROJECT_NAME} RENAME talker)
    ->  Script("talker", "scripts/talker.py", line=1)

The commands are interpreted in their order as far as lists of files need it: variables, lists, globs, `foreach`,
functions, included folders. Every branch of an `if` is taken, since the answer to "what could this package install?"
should not miss a script. Files outside the package are neither read nor listed.
"""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Final, NamedTuple, final

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.cmake.files import PackageFiles
from rosward.source.cmake.install import CMakeTarget, Targets, below_share, by_option, shared
from rosward.source.cmake.text import Command, parse_cmake
from rosward.source.cmake.variables import Variables, elements
from rosward.source.entry_points import EntryPoint, read_setup_cfg
from rosward.source.location import Place
from rosward.source.text import place_name, read_bytes
from rosward.source.workspace import GeneratedModule

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.source.workspace import Shared

_STEP_LIMIT: Final = 50_000


_TARGET_COMMANDS: Final = frozenset(
    {
        "add_executable", "ament_auto_add_executable", "ament_auto_package", "rclcpp_components_register_node",
        "rclcpp_components_register_nodes",
    }
)  # fmt: skip


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
    reader.read(folder, 0)
    reader.finish()
    return CMakeProject(
        tuple(dict.fromkeys(reader.scripts)),
        tuple(dict.fromkeys(reader.python_roots)),
        tuple(reader.findings),
        tuple(dict.fromkeys(reader.shared)),
        reader.all_shared and not reader.findings,
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
        self._folder = folder
        self._file = ""
        self._steps = 0
        self._files = PackageFiles(folder)
        self._variables = Variables(
            {"PROJECT_NAME": package, "CMAKE_PROJECT_NAME": package, "CMAKE_INSTALL_PREFIX": ""},
            dict.fromkeys(("CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR", f"{package}_SOURCE_DIR"), folder),
        )
        self._functions: dict[str, tuple[list[str], list[Command]]] = {}
        self.scripts: list[InstalledScript] = []
        self.shared: list[Shared] = []
        self.all_shared = True
        self.targets = Targets(package)
        self.python_roots: list[str] = []
        self.entry_points: list[EntryPoint] = []
        self.generated: list[GeneratedModule] = []
        self.findings: list[Finding] = []

    def read(self, folder: str, depth: int, name: str = "CMakeLists.txt") -> None:
        """Interpret the description in `folder`, with its own idea of the current folder."""
        path = os.path.join(folder, name)  # noqa: PTH118  text throughout: many paths, few of them kept
        file = place_name(path, self._root)
        if self._boundary.leads_out(path):
            self.findings.append(Finding("RW012", "The link leads out of the sources. It was not read.", Place(file)))
            return
        data = read_bytes(path, file, limits.CMAKE_FILE)
        if isinstance(data, Finding):
            self.findings.append(Finding("RW008", data.message, data.place))
            return
        commands, problem = parse_cmake(data.decode("utf-8-sig", "replace"))
        if problem is not None:
            message = f"{problem[0]} The rest of this file was not read."
            self.findings.append(Finding("RW008", message, Place(file, problem[1])))
        before = self._folder, self._file
        self._folder, self._file = folder, file
        self._run(commands, depth)
        self._folder, self._file = before

    def _run(self, commands: list[Command], depth: int) -> None:
        position = 0
        while position < len(commands):
            command = commands[position]
            position += 1
            self._steps += 1
            if self._steps + self._variables.steps > _STEP_LIMIT or depth > limits.CMAKE_DEPTH or self._files.exhausted:
                self._doubt("The build description of this project is too large to be read completely.", command)
                self._steps = _STEP_LIMIT + 1
                return
            if command.name in {"foreach", "function", "macro"}:
                body, position = _block(commands, position, command.name)
                if command.name == "foreach":
                    self._foreach(command, body, depth)
                elif command.arguments:
                    self._functions[command.arguments[0].text.lower()] = ([a.text for a in command.arguments[1:]], body)
            else:
                self._command(command, depth)

    def _command(self, command: Command, depth: int) -> None:
        arguments = self._variables.expand(command.arguments, self._folder)
        match command.name:
            case "project" if arguments:
                self._variables.values["PROJECT_NAME"] = arguments[0]
            case "set" if arguments:
                values = [a for a in arguments[1:] if a != "PARENT_SCOPE"]
                if "CACHE" in values:
                    values = values[: values.index("CACHE")]
                self._variables.set(arguments[0], values)
            case "unset" if arguments:
                self._variables.values.pop(arguments[0], None)
            case "list" if len(arguments) >= 2:
                self._variables.change_list(arguments[0], arguments[1], arguments[2:])
            case "file" if len(arguments) >= 2 and arguments[0] in {"GLOB", "GLOB_RECURSE"}:
                self._glob(arguments[1], arguments[2:], recurse=arguments[0] == "GLOB_RECURSE")
            case "get_filename_component" if len(arguments) >= 3:
                self._variables.set(arguments[0], [_component(arguments[1], arguments[2])])
            case "install" | "catkin_install_python" if arguments:
                self._install(arguments, command)
            case name if name in _TARGET_COMMANDS and arguments:
                self._target(arguments, command)
            case "generate_parameter_module" if len(arguments) >= 2:
                source = os.path.normpath(os.path.join(self._folder, arguments[1]))  # noqa: PTH118
                made = self._variables.values["PROJECT_NAME"], arguments[0], source, "".join(arguments[2:3])
                self.generated.append(GeneratedModule(*made, self._place(command)))
            case "ament_python_install_package" if arguments:
                self._python_package(arguments)
            case "add_subdirectory" if arguments:
                inner = self._inside(arguments[0])
                if inner is not None and os.path.isfile(os.path.join(inner, "CMakeLists.txt")):  # noqa: PTH113, PTH118
                    name = self._variables.values["PROJECT_NAME"]  # a project within has a name of its own
                    self.read(inner, depth + 1)
                    self._variables.values["PROJECT_NAME"] = name
            case "include" if arguments and arguments[0].endswith(".cmake"):
                inner = self._inside(arguments[0])
                if inner is not None and os.path.isfile(inner):  # noqa: PTH113
                    self._include(inner, depth)
            case name if name in self._functions:
                self._call(name, arguments, depth)
            case _:
                pass

    def _include(self, path: str, depth: int) -> None:
        folder = self._folder
        self.read(os.path.dirname(path), depth + 1, os.path.basename(path))  # noqa: PTH119, PTH120
        self._folder = folder

    def _call(self, name: str, arguments: list[str], depth: int) -> None:
        parameters, body = self._functions[name]
        before = dict(self._variables.values) if len(self._variables.values) < 1000 else self._variables.values
        self._variables.values["ARGV"] = ";".join(arguments)
        self._variables.values["ARGN"] = ";".join(arguments[len(parameters) :])
        for index, argument in enumerate(arguments[:20]):
            self._variables.values[f"ARGV{index}"] = argument
        for parameter, argument in zip(parameters, arguments, strict=False):
            self._variables.values[parameter] = argument
        self._run(body, depth + 1)
        self._variables.values = before

    def _foreach(self, command: Command, body: list[Command], depth: int) -> None:
        arguments = self._variables.expand(command.arguments, self._folder)
        if not arguments:
            return
        items: list[str] = []
        mode = "ITEMS"
        rest = arguments[1:]
        if rest[:1] == ["RANGE"]:
            numbers = [int(a) for a in rest[1:] if re.fullmatch(r"-?\d{1,4}", a)]
            items = (
                [str(n) for n in range(numbers[0] if len(numbers) > 1 else 0, numbers[min(1, len(numbers) - 1)] + 1)]
                if numbers
                else []
            )
        elif rest[:1] == ["IN"]:
            for argument in rest[1:]:
                if argument in {"LISTS", "ITEMS"}:
                    mode = argument
                else:
                    items += elements(self._variables.values.get(argument, "")) if mode == "LISTS" else [argument]
        else:
            items = rest
        for item in items:
            if self._steps + self._variables.steps > _STEP_LIMIT:
                return
            self._variables.values[arguments[0]] = item
            self._run(body, depth + 1)

    def _inside(self, path: str) -> str | None:
        return self._files.inside(path, self._folder)

    def _glob(self, name: str, arguments: list[str], *, recurse: bool) -> None:
        relative: str | None = None
        patterns: list[str] = []
        rest = iter(arguments)
        for argument in rest:
            if argument == "RELATIVE":
                relative = os.path.normpath(os.path.join(self._folder, next(rest, "")))  # noqa: PTH118
            elif argument == "LIST_DIRECTORIES":
                next(rest, None)
            elif argument not in {"CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"}:
                patterns.append(argument)
        found: list[str] = []
        for pattern in patterns:
            full = self._inside(pattern)
            if full is not None:
                found += self._files.glob(full, recurse=recurse)
        self._variables.set(
            name, [os.path.relpath(path, relative) if relative else path for path in sorted(set(found))]
        )

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
        place = Place(self._file, command.line)
        if what == "DIRECTORY":
            if executable or "USE_SOURCE_PERMISSIONS" in options:
                self._install_folders(paths, options, place, all_of_them=executable)
        elif what == "PROGRAMS" or executable:
            for path in paths:
                full = self._inside(path)
                name = next(iter(options.get("RENAME", [])), "") or os.path.basename(path)  # noqa: PTH119
                if full is None:  # outside, or made by the build
                    self._doubt(f"The program {path!r} is outside the package.", command)
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
            start = self._inside(path)
            if start is not None:
                found = self._files.below(start, matching=matching, unwanted=unwanted, executable=not all_of_them)
                self.scripts += [InstalledScript(name, full, place) for name, full in found]

    def _share(self, what: str, path: str, into: str, options: dict[str, list[str]], command: Command) -> None:
        full = self._inside(path)
        if full is None or (not path and what != "DIRECTORY"):  # outside, or made by the build
            self.all_shared = False
        else:
            self.shared.append(shared(what, path, full, into, options, self._place(command)))

    def _target(self, arguments: list[str], command: Command) -> None:
        place = self._place(command)
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

    def _place(self, command: Command) -> Place:
        return Place(self._file, command.line)

    def _python_package(self, arguments: list[str]) -> None:
        """`ament_python_install_package(NAME [PACKAGE_DIR FOLDER] [SETUP_CFG FILE] [SCRIPTS_DESTINATION lib/PACKAGE])`.

        The package is imported from the folder that holds it. The scripts that its setup.cfg declares are installed only to a destination.
        """
        folder = _behind("PACKAGE_DIR", arguments) or arguments[0]
        full = self._inside(folder)
        if full is not None and full != self._top:
            self.python_roots.append(os.path.dirname(full))  # noqa: PTH120
        description = self._inside(_behind("SETUP_CFG", arguments) or f"{folder}/setup.cfg")
        if description is not None and _behind("SCRIPTS_DESTINATION", arguments) and self._is_there(description):
            declared = read_setup_cfg(description, place_name(description, self._root))
            self.entry_points += declared.entry_points
            self.findings += declared.findings

    def _is_there(self, path: str) -> bool:
        return os.path.isfile(path) and not self._boundary.leads_out(path)  # noqa: PTH113

    def finish(self) -> None:
        """Say so if not all files were looked at."""
        if self._files.exhausted:
            message = "The folders named by the build description contain too many files. Not all were examined."
            self.findings.append(Finding("RW008", message, Place(place_name(self._top, self._root))))

    def _doubt(self, message: str, command: Command) -> None:
        finding = Finding("RW008", message, Place(self._file, command.line))
        if finding not in self.findings[-20:]:
            self.findings.append(finding)


def _block(commands: list[Command], position: int, name: str) -> tuple[list[Command], int]:
    """The commands up to the end of the block that has just been opened, and the position after it."""
    depth, start = 1, position
    while position < len(commands):
        here = commands[position].name
        depth += (here == name) - (here == f"end{name}")
        position += 1
        if not depth:
            return commands[start : position - 1], position
    return commands[start:], position


def _behind(keyword: str, arguments: list[str]) -> str:
    """The value of a keyword of a command; '' where it has none."""
    return next(iter(arguments[arguments.index(keyword) + 1 :]), "") if keyword in arguments else ""


def _component(path: str, which: str) -> str:
    name = path.rpartition("/")[2]
    match which:
        case "NAME":
            return name
        case "NAME_WE":
            return name.partition(".")[0]
        case "NAME_WLE":
            return name.rpartition(".")[0] or name
        case "EXT":
            return name[name.index(".") :] if "." in name else ""
        case "DIRECTORY" | "PATH":
            return path.rpartition("/")[0]
        case _:
            return path
