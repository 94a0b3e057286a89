# SPDX-License-Identifier: Apache-2.0
"""What do the commands of a CMakeLists.txt do, in their order?

    foreach(side left right)
      add_executable(${side}_node src/side.cpp)         ->  add_executable left_node src/side.cpp
    endforeach()                                            add_executable right_node src/side.cpp

Variables, lists, loops, functions and included files are interpreted here; what the other commands mean is up to the reader that asks
(`installed.py`, `build.py`). Two ways to treat an `if`: for "what could this package install?" each branch counts, in its order; where
a reader has `Surroundings` to ask, a condition that is known takes one way, any other both, and what they leave in variables is joined.

Nothing outside of the package is read, and everything is bounded.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.boundary import Boundary
from rosward.source.cmake.blocks import Block, Step, Way, blocks
from rosward.source.cmake.conditions import Surroundings, holds
from rosward.source.cmake.files import PackageFiles
from rosward.source.cmake.joined import joined
from rosward.source.cmake.lists import COMPUTATIONS, change_list, loop_items
from rosward.source.cmake.probes import is_kept, may_write, written
from rosward.source.cmake.reader import Reader
from rosward.source.cmake.text import Command, parse_cmake
from rosward.source.cmake.variables import HOLE, Variables
from rosward.source.text import place_name, read_bytes

_STEP_LIMIT: Final = 50_000
_NESTING_LIMIT: Final = 60


class Function(NamedTuple):
    """A function or macro of the description."""

    parameters: list[str]
    body: list[Step]
    is_macro: bool
    file: str


@final
class Interpreter:
    """One project in the course of being interpreted."""

    def __init__(
        self,
        reader: Reader,
        folder: str,
        package: str,
        root: Path,
        boundary: Boundary,
        variables: dict[str, str],
        around: Surroundings | None = None,
    ) -> None:
        self._reader = reader
        self.top = folder
        self._boundary = boundary
        self._root = root
        self._package = package
        self._around = around
        self._steps = 0
        self._loops = 0
        self._parents: list[dict[str, str]] = []
        self.folder = folder
        self._listed = folder
        self.file = ""
        self.files = PackageFiles(folder)
        self._first = dict(variables)
        self.variables = Variables(self._known, reader.environment, self._spent, variables)
        self.functions: dict[str, Function] = {}
        self.undecided: list[Way] = []
        """The ways around the command that nobody could say are taken."""
        self._ways = 0
        self.doubts: dict[Place, None] = {}
        """All such conditions."""
        self.findings: list[Finding] = []

    def read(self, folder: str, depth: int, name: str = "CMakeLists.txt", *, included: bool = False) -> None:
        """Interpret the description in `folder`, with its own idea of the current folder, unless it is one that is `included`."""
        file = place_name(os.path.join(folder, name), self._root)  # noqa: PTH118  text throughout: many paths, few of them kept
        steps = self._steps_of(folder, name, file)
        before = self.folder, self.file, self._listed
        self.file, self._listed = file, folder
        if not included or self._around is None:
            self.folder = folder
        self.run(steps, depth)
        self.folder, self.file, self._listed = before

    def define(self, folder: str, name: str) -> None:
        """Take the functions and macros of a file, and nothing else that it says."""
        before, self.file = self.file, place_name(f"{folder}{os.sep}{name}", self._root)
        for step in self._steps_of(folder, name, self.file):
            if isinstance(step, Block) and step.opening.name in {"function", "macro"}:
                self._define(step)
        self.file = before

    def _steps_of(self, folder: str, name: str, file: str) -> list[Step]:
        path = os.path.join(folder, name)  # noqa: PTH118
        if self._boundary.leads_out(path):
            self.findings.append(Finding("RW012", "The link leads out of the sources. It was not read.", Place(file)))
            return []
        data = read_bytes(path, file, limits.CMAKE_FILE)
        if isinstance(data, Finding):
            self.findings.append(Finding("RW008", data.message, data.place))
            return []
        commands, problem = parse_cmake(data.decode("utf-8-sig", "replace").replace(HOLE, "\ufffd"))
        if problem is not None:
            message = f"{problem[0]} The rest of this file was not read."
            self.findings.append(Finding("RW008", message, Place(file, problem[1])))
        steps, too_deep = blocks(commands, _NESTING_LIMIT)
        if too_deep is not None:
            self.findings.append(
                Finding("RW008", "This block is nested too deeply. It was not read.", Place(file, too_deep.line))
            )
        return steps

    def run(self, steps: list[Step], depth: int) -> str:
        """Carry out the steps; how they end: '', or the name of the command that leads out of them."""
        for step in steps:
            command = step.opening if isinstance(step, Block) else step
            self._steps += 1
            if self._steps > _STEP_LIMIT or depth > limits.CMAKE_DEPTH or self.files.exhausted:
                self.doubt("The build description of this project is too large to be read completely.", command)
                self._steps = _STEP_LIMIT + 1
                return "return"
            if isinstance(step, Block):
                leads_out = self._block(step, depth)
                if leads_out:
                    return leads_out
            elif self._around is not None and command.name in {"return", "break", "continue"}:
                if command.name == "return" or self._loops:
                    return command.name
            else:
                self._command(command, depth)
        return ""

    def _block(self, block: Block, depth: int) -> str:
        match block.opening.name:
            case "foreach":
                return self._foreach(block, depth)
            case "while":
                return self._while(block, depth)
            case "function" | "macro":
                self._define(block)
                return ""
            case "if" if self._around is None:
                self.run(block.body, depth)
                for _, body in block.branches:
                    self.run(body, depth)
                return ""
            case "if":
                return self._if(block, depth)
            case _:
                return self.run(block.body, depth)

    def _define(self, block: Block) -> None:
        arguments = [a.text for a in block.opening.arguments]
        if arguments:
            function = Function(arguments[1:], block.body, block.opening.name == "macro", self.file)
            self.functions[arguments[0].lower()] = function

    def _if(self, block: Block, depth: int) -> str:
        """The way that the condition takes, or each of them where nobody knows."""
        branches: list[list[Step]] = []
        place = self.place(block.opening)
        for command, body in [(block.opening, block.body), *block.branches]:
            verdict = True if command.name == "else" else self._holds(command)
            if verdict is not False:
                branches.append(body)
            if verdict:
                break
        else:
            branches.append([])
        if len(branches) == 1:
            return self.run(branches[0], depth)
        self.doubts[place] = None
        before = self.variables.values
        self._spent(len(before) // 10)
        after: list[dict[str, str]] = []
        for body in branches:
            self.variables.values = dict(before)
            self._ways += 1
            self.undecided.append(Way(place, self._ways))
            self.run(body, depth)  # what leads out of a way that may not be taken does not lead out
            self.undecided.pop()
            after.append(self.variables.values)
        self.variables.values = joined(before, after)
        return ""

    def _foreach(self, block: Block, depth: int) -> str:
        arguments = self.variables.expand(block.opening.arguments)
        if not arguments:
            return ""
        self._loops += 1
        leads_out = ""
        for item in list(loop_items(arguments, self.variables)):
            if self._steps > _STEP_LIMIT:
                break
            self.variables.values[arguments[0]] = item
            leads_out = self.run(block.body, depth + 1)
            if leads_out in {"break", "return"}:
                break
        self._loops -= 1
        return leads_out if leads_out == "return" else ""

    def _while(self, block: Block, depth: int) -> str:
        """Around as long as the condition is known to hold; once where nobody knows."""
        self._loops += 1
        leads_out = ""
        while self._steps <= _STEP_LIMIT:
            self._steps += 1
            verdict = self._holds(block.opening)
            if verdict is False:
                break
            leads_out = self.run(block.body, depth + 1)
            if verdict is None or leads_out in {"break", "return"}:
                break
        self._loops -= 1
        return leads_out if leads_out == "return" and self._around is not None else ""

    def _holds(self, command: Command) -> bool | None:
        """Whether its condition holds; None where nobody can say, or is asked."""
        return None if self._around is None else holds(command.arguments, self.variables, self._around)

    def _command(self, command: Command, depth: int) -> None:
        arguments = self.variables.expand(command.arguments)
        match command.name:
            case "project" if arguments:
                self.variables.values["PROJECT_NAME"] = arguments[0]
                if self._around is not None and "VERSION" in arguments[:-1]:
                    self.variables.set_version(arguments[0], arguments[arguments.index("VERSION") + 1])
            case "set" if arguments:
                self._set(arguments)
            case "unset" if arguments:
                self.variables.values.pop(arguments[0], None)
            case "list" if len(arguments) >= 2:
                if not change_list(arguments, self.variables):
                    self._forget(arguments[1:])
            case "file" if len(arguments) >= 2 and arguments[0] in {"GLOB", "GLOB_RECURSE"}:
                found = self.files.file_glob(arguments[2:], self.folder, recurse=arguments[0] == "GLOB_RECURSE")
                self.variables.set(arguments[1], found)
            case "option" if len(arguments) >= 2:
                self._option(arguments)
            case name if name in COMPUTATIONS:
                if not COMPUTATIONS[name](arguments, self.variables):
                    self._forget(arguments)
            case "add_subdirectory" | "externalproject_add" if arguments:
                into = self._subdirectory if command.name == "add_subdirectory" else self._again
                into(arguments, depth)
            case "include" if arguments:
                self._include(arguments[0], depth)
            case name if name in self._reader.handlers:
                if arguments:
                    self._reader.handlers[name](arguments, command)
            case name if name in self.functions:
                self._call(name, arguments, depth)
            case name if (values := written(name, arguments)) is not None:
                self._take(values)
                self._keep(values if is_kept(name) else {})
            case name:
                if self._reader.unknown_command(name) and name in self.functions:
                    self._call(name, arguments, depth)
                else:
                    self._take(may_write(name, arguments, self.variables.values))
                    self._reader.not_understood(arguments, command)

    def _set(self, arguments: list[str]) -> None:
        name, *values = arguments
        outside = "PARENT_SCOPE" in values
        values = [a for a in values if a != "PARENT_SCOPE"]
        if "CACHE" in values:
            values = values[: values.index("CACHE")]
        if outside and self._around is not None and self._parents:
            self._parents[-1][name] = ";".join(values)
        elif not values and self._around is not None:
            self.variables.values.pop(name, None)
        else:
            self.variables.set(name, values)

    def _option(self, arguments: list[str]) -> None:
        if self._around is not None and arguments[0] not in self.variables.values:
            self.variables.values[arguments[0]] = arguments[2] if len(arguments) > 2 else "OFF"

    def _forget(self, names: list[str]) -> None:
        """What the commands would write into these variables is not known."""
        self._take({name: HOLE for name in names if name.isidentifier()})

    def _take(self, values: dict[str, str]) -> None:
        if self._around is not None:
            self.variables.values.update(values)

    def _keep(self, values: dict[str, str]) -> None:
        """What a command writes for the whole build, whatever function it stands in."""
        self._spent(len(values) * len(self._parents) // 50)
        for scope in self._parents:
            for name, value in values.items():
                scope.setdefault(name, HOLE if self.undecided else value)

    def _subdirectory(self, arguments: list[str], depth: int) -> None:
        inner = self.inside(arguments[0])
        if inner is not None and disk.is_file(os.path.join(inner, "CMakeLists.txt")):  # noqa: PTH118
            values = self.variables.values
            name = values["PROJECT_NAME"]  # a project within has a name of its own
            if self._around is not None:
                self._parents.append(values)
                self._spent(len(values) // 50)
                self.variables.values = dict(values)
            self.read(inner, depth + 1)
            if self._around is not None:
                self.variables.values = self._parents.pop()
            self.variables.values["PROJECT_NAME"] = name

    def _again(self, arguments: list[str], depth: int) -> None:
        """`ExternalProject_Add(it SOURCE_DIR ${PROJECT_SOURCE_DIR} CMAKE_ARGS -DALL=OFF)`: a folder of the package, built with these."""
        if self._around is None or "SOURCE_DIR" not in arguments[:-1]:
            return
        inner = self.inside(arguments[arguments.index("SOURCE_DIR") + 1])
        if inner is None or not disk.is_file(os.path.join(inner, "CMakeLists.txt")):  # noqa: PTH118
            return
        values = self.variables.values
        given = (a[2:].partition("=") for a in arguments if a.startswith("-D") and "=" in a)
        self.variables.values = {**self._first, **{name.partition(":")[0]: value for name, _, value in given}}
        folder, self.folder = self.folder, inner
        self.read(inner, depth + 1)
        self.folder, self.variables.values = folder, values

    def _include(self, path: str, depth: int) -> None:
        places = [path]
        if not path.endswith(".cmake"):
            if self._around is None:
                return
            places = [f"{folder}/{path}.cmake" for folder in self.variables.elements("CMAKE_MODULE_PATH")[:20]]
        for place in places:
            inner = self.inside(place)
            if inner is not None and disk.is_file(inner):
                self.read(os.path.dirname(inner), depth + 1, os.path.basename(inner), included=True)  # noqa: PTH119, PTH120
                return

    def _call(self, name: str, arguments: list[str], depth: int) -> None:
        function = self.functions[name]
        values = self.variables.values
        own = {"ARGV": ";".join(arguments), "ARGN": ";".join(arguments[len(function.parameters) :])}
        own["ARGC"] = str(len(arguments))
        own |= {f"ARGV{index}": argument for index, argument in enumerate(arguments[:20])}
        own |= dict(zip(function.parameters, arguments, strict=False))
        loops, self._loops = self._loops, 0
        file, self.file = self.file, function.file
        if function.is_macro and self._around is not None:
            shadowed = {key: values[key] for key in own if key in values}
            values |= own
            self.run(function.body, depth + 1)
            values = self.variables.values  # a condition in it that nobody knows leaves others
            for key in own:
                values.pop(key, None)
            self.variables.values |= shadowed
        else:
            self._spent(len(values) // 50)
            if len(values) < 1000:
                self._parents.append(values)
                self.variables.values = dict(values)
            self.variables.values |= own
            self.run(function.body, depth + 1)
            if len(values) < 1000:
                self.variables.values = self._parents.pop()
        self._loops, self.file = loops, file

    def _known(self, name: str) -> str:
        if name == "CMAKE_CURRENT_SOURCE_DIR":
            return self.folder
        if name in {"CMAKE_CURRENT_LIST_DIR", "CMAKE_CURRENT_FUNCTION_LIST_DIR"}:
            return self._listed
        if name in {"CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR", f"{self._package}_SOURCE_DIR"}:
            return self.top
        return self._reader.known(name)

    def _spent(self, steps: int) -> None:
        self._steps += steps

    def inside(self, path: str) -> str | None:
        """The absolute form of a path as written, if it is within the package."""
        return self.files.inside(path, self.folder)

    def place(self, command: Command) -> Place:
        """Where a command stands."""
        return Place(self.file, command.line)

    def doubt(self, message: str, command: Command) -> None:
        """Say that something of the description is not understood."""
        finding = Finding("RW008", message, self.place(command))
        if finding not in self.findings[-20:]:
            self.findings.append(finding)
