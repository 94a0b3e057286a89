# SPDX-License-Identifier: Apache-2.0
"""Which programs, libraries and components does the CMakeLists.txt of a package build, of which sources, and how compiled?

    add_library(belt_component SHARED src/belt.cpp)                                   ->  Build with a library belt_component
    rclcpp_components_register_node(belt_component PLUGIN "belt::Belt" EXECUTABLE belt)     and the component belt::Belt in it

Conditions that are known decide; options have their defaults, the machine is Linux, and tests are not built. Which sources a program
consists of over all packages is told by `programs.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Final, final

from rosward.source import disk
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.cmake.exported import ExportCommands
from rosward.source.cmake.interpreter import Interpreter
from rosward.source.cmake.making import TargetCommands
from rosward.source.cmake.reader import Handler
from rosward.source.cmake.targets import Build, Definition
from rosward.source.cmake.text import Command
from rosward.source.cmake.variables import HOLE
from rosward.source.submodules import is_not_fetched
from rosward.source.surroundings import ROS_2

_PLATFORM: Final[Mapping[str, str]] = {
    "UNIX": "1", "LINUX": "1", "CMAKE_SYSTEM_NAME": "Linux", "CMAKE_HOST_SYSTEM_NAME": "Linux", "CMAKE_SIZEOF_VOID_P": "8",
    "CMAKE_COMPILER_IS_GNUCXX": "1", "CMAKE_COMPILER_IS_GNUCC": "1", "CMAKE_CXX_COMPILER_ID": "GNU", "CMAKE_C_COMPILER_ID": "GNU",
    "CMAKE_INSTALL_LIBDIR": "lib", "CMAKE_INSTALL_BINDIR": "bin", "CMAKE_INSTALL_DATADIR": "share", "CMAKE_INSTALL_DATAROOTDIR": "share",
    "CMAKE_INSTALL_INCLUDEDIR": "include",
}  # fmt: skip
_NOT_KNOWN: Final = frozenset(
    {
        "CMAKE_BUILD_TYPE", "CMAKE_VERSION", "CMAKE_SYSTEM_PROCESSOR", "CMAKE_HOST_SYSTEM_PROCESSOR", "CMAKE_CXX_COMPILER_VERSION",
        "CMAKE_CURRENT_BINARY_DIR", "CMAKE_BINARY_DIR", "PROJECT_BINARY_DIR", "CMAKE_PREFIX_PATH", "CMAKE_CXX_COMPILER",
        "CMAKE_C_COMPILER", "CMAKE_CROSSCOMPILING", "CMAKE_CUDA_COMPILER", "CMAKE_SYSTEM_VERSION", "CMAKE_PROJECT_VERSION",
    }
)  # fmt: skip
_OF_EACH_SHELL: Final = frozenset(
    {
        "HOME", "PATH", "USER", "LOGNAME", "SHELL", "PWD", "OLDPWD", "HOSTNAME", "LANG", "TERM", "DISPLAY", "TMPDIR", "EDITOR", "CI",
        "PYTHONPATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION", "ROS_DOMAIN_ID",
        "RMW_IMPLEMENTATION", "CC", "CXX", "CFLAGS", "CXXFLAGS", "LDFLAGS",
    }
)  # fmt: skip
"""Variables of the environment that a shell, ROS or whoever builds sets; so are prefixes."""
Functions = Callable[[str], tuple[str, str] | None]


def read_build(
    folder: str,
    package: str,
    root: Path,
    boundary: Boundary = EVERYWHERE,
    *,
    depends: Iterable[str] = (),
    present: frozenset[str] = frozenset(),
    environment: Mapping[str, str] = ROS_2,
    functions: Functions | None = None,
    distros: Iterable[str] = (),
) -> Build:
    """What the CMakeLists.txt in `folder` builds of the package of that name, which depends on others by its package.xml.

    `present` are the packages of the workspace, `functions` tells which of their files defines a function,
    `distros` which distributions there are, for a build of which nobody knows the distribution.
    """
    return _Reader(
        folder, package, root, boundary, tuple(depends), present, environment, functions, tuple(distros)
    ).build()


def _is_usual(variable: str) -> bool:
    """Whether a variable of the environment may well be set where a package is built."""
    return variable in _OF_EACH_SHELL or "PREFIX" in variable or HOLE in variable


_OF_FOUND: Final = re.compile(r"(?!CMAKE_|PROJECT_).+_(?:FOUND|VERSION(?:_(?:MAJOR|MINOR|PATCH|STRING))?)")
"""What a package says that another one found: `GAZEBO_VERSION` of gazebo_dev."""


@final
class _Reader:
    """One package in the course of being read."""

    def __init__(
        self,
        folder: str,
        package: str,
        root: Path,
        boundary: Boundary,
        depends: tuple[str, ...],
        present: frozenset[str],
        environment: Mapping[str, str],
        functions: Functions | None,
        distros: tuple[str, ...],
    ) -> None:
        self._top = folder
        self._root = str(root)
        self._package = package
        self._depends = depends
        self._present = present
        self._environment = environment
        self._distros = distros
        self._functions = functions
        self._asked: set[str] = set()
        self._found: dict[str, None] = {}
        self._prefixes: set[str] = set()
        variables = {
            "PROJECT_NAME": package,
            "CMAKE_PROJECT_NAME": package,
            "CMAKE_INSTALL_PREFIX": "",
            "BUILD_TESTING": "OFF",
            "CATKIN_ENABLE_TESTING": "OFF",
        }
        self._interpreter = Interpreter(self, folder, package, root, boundary, variables, self)
        self._targets = TargetCommands(self._interpreter, folder, self._found)
        self._exports = ExportCommands(self._interpreter, package, self._targets)
        self.handlers: Mapping[str, Handler] = {
            "find_package": self._find_package,
            "ament_auto_find_build_dependencies": self._find_all,
            "autoware_package": self._autoware,
            "rosidl_get_typesupport_target": self._typesupport,
            **self._targets.handlers,
            **self._exports.handlers,
        }

    def build(self) -> Build:
        """Read the description."""
        self._interpreter.read(self._top, 0)
        return Build(
            self._package,
            self._top,
            {name: target.made_up() for name, target in self._targets.made.items()},
            tuple(self._exports.components),
            tuple(self._exports.exported),
            tuple(dict.fromkeys([*self._found, *self._depends])),
            tuple(self._exports.parameters),
            tuple(self._exports.plugins),
            self._targets.aliases,
            tuple(self._interpreter.doubts),
            tuple(self._interpreter.findings),
        )

    # What the interpreter asks

    def known(self, name: str) -> str:
        """The machine is Linux, the compiler GNU; what else CMake or a package that was found sets is not known."""
        if name in _NOT_KNOWN or name.endswith("_BINARY_DIR"):
            return HOLE
        value = _PLATFORM.get(name)
        if value is None and self._prefixes:
            if _OF_FOUND.fullmatch(name):
                return HOLE
            lower = name.lower()
            at = lower.find("_")
            while at >= 0:
                if lower[:at] in self._prefixes:
                    return HOLE
                at = lower.find("_", at + 1)
        return value or ""

    def environment(self, name: str) -> str:
        """What is given of the environment; of the rest nothing is set, but for what each shell sets."""
        return self._environment.get(name, HOLE if _is_usual(name) else "")

    def unknown_command(self, name: str) -> bool:
        """Take it from the cmake files of another package."""
        if name in self._asked or name.startswith("end"):
            return False
        self._asked.add(name)
        place = self._functions(name) if self._functions is not None else None
        if place is not None:
            self._interpreter.define(*place)
        return place is not None

    def not_understood(self, arguments: list[str], command: Command) -> None:
        """A command of a package from elsewhere may make a target."""
        self._targets.unknown(arguments, command)

    def has_command(self, name: str) -> bool | None:
        """Whether a command of that name is there."""
        lower = name.lower()
        return True if lower in self._interpreter.functions or lower in self.handlers else None

    def has_target(self, name: str) -> bool | None:
        """Whether a target of that name is there; nobody knows those of packages from elsewhere."""
        target = self._targets.find(name)
        if target is not None:
            return target.sure or None
        return None if "::" in name else False

    def has_path(self, path: str) -> bool | None:
        """Whether there is a file or folder; nobody knows outside of the package, and in a submodule that is not there."""
        inner = self._interpreter.inside(path)
        if inner is None:
            return None
        return disk.exists(inner) or (None if is_not_fetched(inner, self._root) else False)

    def has_environment(self, name: str) -> bool | None:
        """Whether an environment variable is set; None where each shell has a value of its own."""
        return True if name in self._environment else None if _is_usual(name) else False

    # Packages

    def _find_package(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        name = arguments[0]
        if HOLE in name:
            return
        self._found[name] = None
        self._prefixes.add(name.lower())
        values = self._interpreter.variables.values
        there = "REQUIRED" in arguments or name in self._present or name in self._depends
        for found in {name, name.upper()}:
            values[f"{found}_FOUND"] = "1" if there else HOLE
        values |= dict.fromkeys([f"{name}_TARGETS", f"{name}_LIBRARIES", f"{name}_INCLUDE_DIRS"], f"{name}::*")

    def _find_all(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for name in self._depends:
            self._find_package([name, "REQUIRED"], command)
        self._interpreter.variables.set(
            f"{self._interpreter.variables.get('PROJECT_NAME')}_FOUND_BUILD_DEPENDS", self._depends
        )

    def _autoware(self, arguments: list[str], command: Command) -> None:
        """`autoware_package()`: finds all dependencies, and defines the distro."""
        self._find_all(arguments, command)
        distro = self._environment.get("ROS_DISTRO")
        names = [distro] if distro else self._distros
        definitions = [Definition(f"ROS_DISTRO_{n.upper()}", "1", sure=distro is not None) for n in names]
        self._targets.folder().definitions.update(dict.fromkeys(definitions))

    def _typesupport(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        """A target of generated messages: nothing of ours."""
        self._interpreter.variables.set(arguments[0], [f"{self._package}::interfaces"])
