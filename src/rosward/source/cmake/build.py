# SPDX-License-Identifier: Apache-2.0
"""Which programs, libraries and components does the CMakeLists.txt of a package build, of which sources, and how compiled?

    add_library(belt_component SHARED src/belt.cpp)                                   ->  Build with a library belt_component
    rclcpp_components_register_node(belt_component PLUGIN "belt::Belt" EXECUTABLE belt)     and the component belt::Belt in it

Conditions that are known decide; options have their defaults, the machine is Linux, and tests are not built. Which sources a program
consists of over all packages is told by `programs.py`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final, final

from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.cmake.generators import meant, objects_of
from rosward.source.cmake.interpreter import Handler, Interpreter
from rosward.source.cmake.targets import (
    Build,
    Component,
    Definition,
    Made,
    Making,
    ParameterHeader,
    Using,
)
from rosward.source.cmake.text import Command
from rosward.source.cmake.variables import HOLE
from rosward.source.surroundings import ROS_2

SOURCE_SUFFIXES: Final = (".cpp", ".cc", ".cxx", ".c++", ".C", ".cp")
"""Of files that are compiled as C++."""

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
_VISIBLE: Final = frozenset(
    {"PUBLIC", "PRIVATE", "INTERFACE", "LINK_PUBLIC", "LINK_PRIVATE", "LINK_INTERFACE_LIBRARIES"}
)
_KINDS: Final[Mapping[str, Made]] = {
    "STATIC": Made.LIBRARY, "SHARED": Made.LIBRARY, "MODULE": Made.LIBRARY, "OBJECT": Made.OBJECTS, "INTERFACE": Made.INTERFACE,
    "UNKNOWN": Made.LIBRARY,
}  # fmt: skip
_NO_SOURCE: Final = frozenset(
    {"WIN32", "MACOSX_BUNDLE", "EXCLUDE_FROM_ALL", "NO_TARGET_LINK_LIBRARIES", "PRIVATE", "PUBLIC", "BEFORE", "SYSTEM", "AFTER"}
)  # fmt: skip
_ARTIFACTS: Final = frozenset(
    {"ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "INCLUDES", "PUBLIC_HEADER"}
)
_TARGET_LIMIT: Final = 2_000


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
) -> Build:
    """What the CMakeLists.txt in `folder` builds of the package of that name, which depends on others by its package.xml.

    `present` are the packages of the workspace, `functions` tells which of their files defines a function.
    """
    return _Reader(folder, package, root, boundary, tuple(depends), present, environment, functions).build()


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
    ) -> None:
        self._top = folder
        self._package = package
        self._depends = depends
        self._present = present
        self._environment = environment
        self._functions = functions
        self._asked: set[str] = set()
        self._found: dict[str, None] = {}
        self._prefixes: set[str] = set()
        variables = {
            "PROJECT_NAME": package,
            "CMAKE_PROJECT_NAME": package,
            "CMAKE_INSTALL_PREFIX": "",
            "BUILD_TESTING": "OFF",
        }
        self._interpreter = Interpreter(self, folder, package, root, boundary, variables, self)
        self._folders: dict[str, Using] = {folder: Using()}
        self._targets: dict[str, Making] = {}
        self._aliases: dict[str, str] = {}
        self._components: dict[Component, None] = {}
        self._exported: dict[str, None] = {}
        self._parameters: list[ParameterHeader] = []
        self._plugins: list[tuple[str, str]] = []
        self.handlers: Mapping[str, Handler] = {
            "add_executable": self._add_executable,
            "cuda_add_executable": self._add_executable,
            "ament_auto_add_executable": self._add_executable,
            "add_library": self._add_library,
            "cuda_add_library": self._add_library,
            "ament_auto_add_library": self._add_library,
            "target_sources": self._target_sources,
            "target_link_libraries": self._target_links,
            "ament_target_dependencies": self._target_depends,
            "target_include_directories": self._target_includes,
            "target_compile_definitions": self._target_definitions,
            "target_compile_options": self._target_options,
            "set_target_properties": self._properties,
            "include_directories": self._folder_includes,
            "add_compile_definitions": self._folder_definitions,
            "add_definitions": self._folder_options,
            "add_compile_options": self._folder_options,
            "link_libraries": self._folder_links,
            "find_package": self._find_package,
            "ament_auto_find_build_dependencies": self._find_all,
            "autoware_package": self._autoware,
            "install": self._install,
            "ament_auto_package": self._auto_package,
            "ament_export_include_directories": self._export,
            "rclcpp_components_register_node": self._register,
            "rclcpp_components_register_nodes": self._register_several,
            "generate_parameter_library": self._generate_parameters,
            "pluginlib_export_plugin_description_file": self._plugin_file,
            "rosidl_get_typesupport_target": self._typesupport,
        }

    def build(self) -> Build:
        """Read the description."""
        self._interpreter.read(self._top, 0)
        return Build(
            self._package,
            self._top,
            {name: target.made_up() for name, target in self._targets.items()},
            tuple(self._components),
            tuple(self._exported),
            tuple(dict.fromkeys([*self._found, *self._depends])),
            tuple(self._parameters),
            tuple(self._plugins),
            self._aliases,
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
            lower = name.lower()
            at = lower.find("_")
            while at >= 0:
                if lower[:at] in self._prefixes:
                    return HOLE
                at = lower.find("_", at + 1)
        return value or ""

    def environment(self, name: str) -> str:
        """What is given of the environment; the rest is not known."""
        return self._environment.get(name, HOLE)

    def unknown_command(self, name: str) -> bool:
        """Take it from the cmake files of another package."""
        if name in self._asked or name.startswith("end"):
            return False
        self._asked.add(name)
        place = self._functions(name) if self._functions is not None else None
        if place is not None:
            self._interpreter.define(*place)
        return place is not None

    def has_command(self, name: str) -> bool | None:
        """Whether a command of that name is there."""
        lower = name.lower()
        return True if lower in self._interpreter.functions or lower in self.handlers else None

    def has_target(self, name: str) -> bool | None:
        """Whether a target of that name is there; nobody knows those of packages from elsewhere."""
        if name in self._targets or name in self._aliases:
            return self._target(name).sure or None
        return None if "::" in name else False

    def has_path(self, path: str) -> bool | None:
        """Whether there is a file or folder; nobody knows outside of the package."""
        inner = self._interpreter.inside(path)
        return None if inner is None else os.path.exists(inner)  # noqa: PTH110

    def has_environment(self, name: str) -> bool | None:
        """Whether an environment variable is set."""
        return True if name in self._environment else None

    # Targets

    @property
    def _sure(self) -> bool:
        return not self._interpreter.undecided

    def _folder(self) -> Using:
        """What all targets of the folder use that is read: at first what the folder above it uses."""
        folder = self._interpreter.folder
        if folder not in self._folders:
            above = folder
            while above not in self._folders:
                above = os.path.dirname(above)  # noqa: PTH120
            self._folders[folder] = self._folders[above].copy()
        return self._folders[folder]

    def _target(self, name: str) -> Making:
        return self._targets[self._aliases.get(name, name)]

    def _making(self, name: str) -> Making | None:
        name = self._aliases.get(name, name)
        return self._targets.get(name)

    def _add(self, name: str, made: Made, sources: Sequence[str], command: Command) -> None:
        if HOLE in name or len(self._targets) >= _TARGET_LIMIT:
            return
        target = self._targets.get(name)
        if target is None:
            target = Making(name, made, self._interpreter.place(command), self._sure, self._folder())
            self._targets[name] = target
        elif self._sure:
            target.sure = True
        if command.name.startswith("ament_auto_"):
            sources = list(self._automatic(target, sources))
        self._put(target, sources)

    def _add_executable(self, arguments: list[str], command: Command) -> None:
        name, *sources = arguments
        if "ALIAS" in sources[:1]:
            self._aliases |= dict.fromkeys([name], "".join(sources[1:2]))
        elif "IMPORTED" not in sources[:2]:
            self._add(name, Made.PROGRAM, sources, command)
            if command.name == "ament_auto_add_executable" and name in self._targets:
                self._targets[name].installed = True

    def _add_library(self, arguments: list[str], command: Command) -> None:
        name, *sources = arguments
        if "ALIAS" in sources[:1]:
            self._aliases |= dict.fromkeys([name], "".join(sources[1:2]))
        elif "IMPORTED" not in sources[:2]:
            made = next((_KINDS[s] for s in sources[:2] if s in _KINDS), Made.LIBRARY)
            self._add(name, made, [s for s in sources if s not in _KINDS], command)

    def _automatic(self, target: Making, sources: Sequence[str]) -> Iterator[str]:
        """What `ament_auto_add_*` does for a target: folders of sources, the folder of headers, links to all that was found."""
        include = os.path.join(self._top, "include")  # noqa: PTH118
        if os.path.isdir(include):  # noqa: PTH112
            target.own.includes[include] = None
            target.handed.includes[include] = None
        links = [f"{package}::*" for package in self._found]
        if "NO_TARGET_LINK_LIBRARIES" not in sources and target.made is Made.PROGRAM:
            links += [name for name, other in self._targets.items() if other.made is Made.LIBRARY]
        target.own.links |= dict.fromkeys(links)
        target.handed.links |= dict.fromkeys(links)
        into_folders = False
        for source in sources:
            if source == "DIRECTORY":
                into_folders = True
            elif into_folders:
                start = self._interpreter.inside(source)
                if start is not None:
                    yield from self._interpreter.files.glob(f"{start}{os.sep}*", recurse=False)
            else:
                yield source

    def _put(self, target: Making, sources: Iterable[str]) -> None:
        """Add sources to a target."""
        for argument in sources:
            if argument in _NO_SOURCE or argument in _VISIBLE:
                continue
            text, _ = meant(argument)
            objects = objects_of(text)
            if objects is not None:
                target.objects[objects] = None
            elif text.endswith(SOURCE_SUFFIXES):
                path = None if HOLE in text else self._interpreter.inside(text)
                if path is not None and os.path.isfile(path):  # noqa: PTH113
                    target.sources[path] = None
                else:
                    target.missing[text.replace(HOLE, "*")] = None

    def _target_sources(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        target = self._making(arguments[0])
        if target is not None:
            self._put(target, arguments[1:])

    def _by_visibility(self, arguments: list[str]) -> Iterator[tuple[list[Using], str]]:
        """Each argument with where it belongs: to the target, to those that link against it, or to both."""
        target = self._making(arguments[0])
        if target is None:
            return
        both = [target.own, target.handed]
        into = both
        for argument in arguments[1:]:
            if argument in _VISIBLE:
                into = both if "PUBLIC" in argument else [target.own] if "PRIVATE" in argument else [target.handed]
            elif argument not in {"SYSTEM", "BEFORE", "AFTER"}:
                yield into, argument

    def _target_links(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.links |= self._links([argument])

    def _target_depends(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            if HOLE not in argument:
                for using in into:
                    using.links[f"{argument}::*"] = None

    def _target_includes(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            for using in into:
                self._include([argument], using)

    def _target_definitions(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.definitions |= self._definitions([argument])

    def _target_options(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.definitions |= self._definitions(a for a in [argument] if a.startswith("-D"))

    def _properties(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        """`set_target_properties(a b PROPERTIES COMPILE_DEFINITIONS X=1 …)`."""
        if "PROPERTIES" not in arguments:
            return
        at = arguments.index("PROPERTIES")
        pairs = dict(zip(arguments[at + 1 :: 2], arguments[at + 2 :: 2], strict=False))
        texts = [*pairs.get("COMPILE_DEFINITIONS", "").split(";")]
        texts += [flag for flag in pairs.get("COMPILE_FLAGS", "").split() if flag.startswith("-D")]
        for target in map(self._making, arguments[:at]):
            if target is not None:
                target.own.definitions |= self._definitions(t for t in texts if t)

    # What all targets of a folder use

    def _folder_includes(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self._include([a for a in arguments if a not in {"SYSTEM", "BEFORE", "AFTER"}], self._folder())

    def _folder_definitions(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self._folder().definitions.update(self._definitions(arguments))

    def _folder_options(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self._folder().definitions.update(self._definitions(a for a in arguments if a.startswith("-D")))

    def _folder_links(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self._folder().links.update(self._links(arguments))

    def _include(self, paths: Iterable[str], into: Using) -> None:
        for argument in paths:
            text, _ = meant(argument)
            path = None if HOLE in text or not text else self._interpreter.inside(text)
            if path is not None:
                into.includes[path] = None
            elif "::" in text:
                into.links[text] = None

    def _definitions(self, texts: Iterable[str]) -> dict[Definition, None]:
        found: dict[Definition, None] = {}
        for argument in texts:
            text, sure = meant(argument)
            name, equals, value = text.removeprefix("-D").partition("=")
            if name.isidentifier():
                sure = sure and self._sure and HOLE not in value
                value = value.replace('\\"', '"').replace(HOLE, "")
                found[Definition(name, value if equals else "1", sure)] = None
        return found

    @staticmethod
    def _links(arguments: Iterable[str]) -> dict[str, None]:
        texts = (meant(argument).text for argument in arguments)
        return {
            t: None
            for t in texts
            if t and HOLE not in t and not t.startswith("-") and t not in {"debug", "optimized", "general"}
        }

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
        names = [distro] if distro else ["humble", "jazzy", "kilted", "rolling"]
        definitions = [Definition(f"ROS_DISTRO_{n.upper()}", "1", sure=distro is not None) for n in names]
        self._folder().definitions.update(dict.fromkeys(definitions))

    def _typesupport(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        """A target of generated messages: nothing of ours."""
        self._interpreter.variables.set(arguments[0], [f"{self._package}::interfaces"])

    # What is installed, exported and registered

    def _install(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        what, *rest = arguments
        if what == "TARGETS":
            destination, artifact, option = "", "", ""
            names: list[str] = []
            for argument in rest:
                if argument in _ARTIFACTS:
                    artifact = option = argument
                elif argument in {"DESTINATION", "EXPORT", "COMPONENT", "PERMISSIONS", "CONFIGURATIONS", "OPTIONAL"}:
                    option = argument
                elif option == "DESTINATION" and artifact in {"", "RUNTIME"}:
                    destination = argument.strip("/")
                elif not option:
                    names.append(argument)
            if destination == f"lib/{self._package}" or destination.startswith(f"lib/{self._package}/"):
                for target in map(self._making, names):
                    if target is not None:
                        target.installed = True
        elif what == "DIRECTORY" and "DESTINATION" in rest:
            at = rest.index("DESTINATION")
            if "".join(rest[at + 1 : at + 2]).strip("/").split("/")[0] == "include":
                self._export(rest[:at])

    def _auto_package(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002  as all handlers
        self._export(["include"])

    def _export(self, arguments: list[str], command: Command | None = None) -> None:  # noqa: ARG002
        for argument in arguments:
            path = None if HOLE in argument else self._interpreter.inside(argument)
            if path is not None and os.path.isdir(path):  # noqa: PTH112
                self._exported[path] = None

    def _register(self, arguments: list[str], command: Command) -> None:
        library, *rest = arguments
        given: dict[str, str] = {}
        key = ""
        for argument in rest:
            if argument in {"PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX", "NO_UNDEFINED_SYMBOLS"}:
                key = argument
            elif key:
                given.setdefault(key, argument)
        plugin, program = given.get("PLUGIN", ""), given.get("EXECUTABLE", "")
        if plugin and HOLE not in plugin + program:
            self._component(library, plugin, program, given.get("EXECUTOR", "SingleThreadedExecutor"), command)

    def _register_several(self, arguments: list[str], command: Command) -> None:
        library, *rest = arguments
        for plugin in rest[: rest.index("RESOURCE_INDEX")] if "RESOURCE_INDEX" in rest else rest:
            if HOLE not in plugin:
                self._component(library, plugin, "", "", command)

    def _component(self, library: str, plugin: str, program: str, executor: str, command: Command) -> None:
        library = self._aliases.get(library, library)
        place = self._interpreter.place(command)
        self._components[Component(plugin.strip(), library, program, executor, place, self._sure)] = None

    def _generate_parameters(self, arguments: list[str], command: Command) -> None:
        if len(arguments) >= 2:
            source = self._interpreter.inside(arguments[1])
            if source is not None:
                self._parameters.append(ParameterHeader(arguments[0], source, self._interpreter.place(command)))
                self._add(arguments[0], Made.INTERFACE, [], command)

    def _plugin_file(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        path = self._interpreter.inside(arguments[1]) if len(arguments) > 1 else None
        if path is not None:
            self._plugins.append((arguments[0], path))
