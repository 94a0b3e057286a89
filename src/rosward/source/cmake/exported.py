# SPDX-License-Identifier: Apache-2.0
"""What does a package install, export and register of what it builds?

install(TARGETS talker DESTINATION lib/demo)                                  ->  `ros2 run demo talker` starts it
rclcpp_components_register_node(arms PLUGIN "demo::Arm" EXECUTABLE arm)       ->  the component demo::Arm of the library arms
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import final

from rosward.source import disk
from rosward.source.cmake.install import by_option, installed_targets, registered_classes
from rosward.source.cmake.interpreter import Interpreter
from rosward.source.cmake.making import TargetCommands
from rosward.source.cmake.reader import Handler
from rosward.source.cmake.targets import Component, Made, ParameterHeader
from rosward.source.cmake.text import Command
from rosward.source.cmake.variables import HOLE


@final
class ExportCommands:
    """What a package hands to others, in the course of being read."""

    def __init__(self, interpreter: Interpreter, package: str, targets: TargetCommands) -> None:
        self._interpreter = interpreter
        self._package = package
        self._targets = targets
        self.components: dict[Component, None] = {}
        self.exported: dict[str, None] = {}
        self.parameters: list[ParameterHeader] = []
        self.plugins: list[tuple[str, str]] = []
        self.handlers: Mapping[str, Handler] = {
            "install": self._install,
            "ament_auto_package": self._auto_package,
            "ament_export_include_directories": self._export,
            "rclcpp_components_register_node": self._register,
            "rclcpp_components_register_nodes": self._register_several,
            "generate_parameter_library": self._generate_parameters,
            "pluginlib_export_plugin_description_file": self._plugin_file,
        }

    def _install(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        what, *rest = arguments
        if what == "TARGETS":
            for target in map(self._targets.find, installed_targets(rest, self._package)):
                if target is not None:
                    target.installed = True
        elif what == "DIRECTORY":
            paths, options = by_option(rest)
            if "".join(options.get("DESTINATION", [])[:1]).strip("/").split("/")[0] == "include":
                self._export(paths)

    def _auto_package(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002  as all handlers
        self._export(["include"])

    def _export(self, arguments: list[str], command: Command | None = None) -> None:  # noqa: ARG002
        for argument in arguments:
            path = None if HOLE in argument else self._interpreter.inside(argument)
            if path is not None and disk.is_folder(path):
                self.exported[path] = None

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
        for plugin in registered_classes(arguments):
            if HOLE not in plugin:
                self._component(arguments[0], plugin, "", "", command)

    def _component(self, library: str, plugin: str, program: str, executor: str, command: Command) -> None:
        library = self._targets.aliases.get(library, library)
        place = self._interpreter.place(command)
        self.components[Component(plugin.strip(), library, program, executor, place, self._targets.sure)] = None

    def _generate_parameters(self, arguments: list[str], command: Command) -> None:
        if len(arguments) >= 2:
            source = self._interpreter.inside(arguments[1])
            if source is not None:
                self.parameters.append(ParameterHeader(arguments[0], source, self._interpreter.place(command)))
                self._targets.add(arguments[0], Made.INTERFACE, [], command)

    def _plugin_file(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        path = self._interpreter.inside(arguments[1]) if len(arguments) > 1 else None
        if path is not None:
            self.plugins.append((arguments[0], path))
