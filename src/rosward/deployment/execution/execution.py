# SPDX-License-Identifier: Apache-2.0
"""What does a launch file start, with these arguments?

Execution(files, python, Distro.JAZZY, {'sim': Const('true')}).run('demo/launch/robot.launch.py')    ->    (Started(…), Started(…), …)

Follows launch and launch_ros: includes are not scoped, groups are, timers and event handlers come last. Where launch would raise an
exception and end, that is a finding (RW320) and the execution goes on, so that one mistake does not hide the rest of the system.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, final

from rosward.deployment.execution.context import ROS_NAMESPACE
from rosward.deployment.execution.findings import FindingLog
from rosward.deployment.execution.generated import GeneratedFiles
from rosward.deployment.execution.includes import Descriptions
from rosward.deployment.execution.launch_files import LaunchFiles
from rosward.deployment.execution.nodes import At
from rosward.deployment.execution.perform_names import with_origin
from rosward.deployment.execution.scene import Scene
from rosward.deployment.execution.substitutions import SUBSTITUTIONS
from rosward.deployment.execution.system import LaunchBudget, RunningLaunch
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.performer import PythonCode
from rosward.deployment.started import Started
from rosward.domain.text import make, readable
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import Hole, Value
from rosward.effects.shell import Shell, shell
from rosward.effects.variables import Variables
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.distro import Distro
from rosward.source.surroundings import surroundings

__all__ = ["Execution", "LaunchFiles"]

MAX_ACTIONS: Final = 20_000


@final
class Execution:
    """The execution of one launch file, as `ros2 launch FILE name:=value …` does it."""

    def __init__(
        self,
        files: LaunchFiles,
        python: PythonCode,
        distro: Distro,
        arguments: Mapping[str, Value],
        limit: int = MAX_ACTIONS,
        *,
        environment: Shell | None = None,
        variables: Variables | None = None,
        net: bool = True,
    ) -> None:
        self._net = net
        self._shell = shell(surroundings(distro.value)) if environment is None else environment
        self._limit = limit
        self._variables = variables
        self._distro = distro
        self._files = files
        self._python = python
        self._arguments = arguments
        self._findings = FindingLog()
        self.unread: tuple[str, ...] = ()
        """The arguments that no launch file declared or read."""
        self.known: frozenset[str] = frozenset()
        """Those that some launch file declared or read."""

    def run(self, file: str, path: Value | None = None) -> tuple[Started, ...]:
        """What the file (named as in the workspace) starts. `path` is where it is installed: what $(dirname) is made of."""
        generated = GeneratedFiles(self._files, self._findings)
        scene = Scene(
            self._files,
            self._python,
            self._findings,
            generated,
            self._distro,
            SUBSTITUTIONS,
            self._shell,
            self._variables,
        )
        scene.words = tuple(f"{name}:={readable(value)}" for name, value in self._arguments.items())
        for name, value in self._arguments.items():
            scene.set_configuration(name, _given(name, value))
        descriptions = Descriptions(self._files, self._python, self._findings, net=self._net)
        system = RunningLaunch(scene, descriptions, LaunchBudget(self._limit, net=self._net))
        system.run(file, path or _in_sources(file), At())
        asked = self._arguments if scene.asked_all else scene.asked
        self.known = frozenset(name for name in scene.asked if name != ROS_NAMESPACE)
        self.unread = tuple(name for name in self._arguments if name not in asked)
        return tuple(system.started)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What was told so far, each once, with what Python code of launch files had to tell."""
        return tuple(dict.fromkeys((*self._findings.all(), *self._python.findings)))


def _given(name: str, value: Value) -> Value:
    """A value from the command line; `*` in it leaves that part open."""
    plain = plain_text(value)
    if plain is not None and "*" in plain:
        hole = Hole((Reason(Cause.LAUNCH_ARGUMENT, name, Place("", 0)),))
        parts: list[str | Hole] = []
        for index, part in enumerate(plain.split("*")):
            parts += [hole, part] if index else [part]
        value = make(parts)
    return with_origin(value, Origin("launch argument", name, settled=True, given=True))


def _in_sources(file: str) -> Value:
    """The path of a file outside of any package."""
    return make((Hole((Reason(Cause.SOURCES, "", Place("", 0)),)), f"/{file}"))
